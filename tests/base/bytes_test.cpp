#include "base/bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace gh {
namespace {

TEST(Bytes, WhatIsWrittenIsRead) {
    ByteWriter writer;
    writer.write(std::uint8_t{200});
    writer.write(std::int16_t{-300});
    writer.write(std::uint64_t{0x0123456789ABCDEFu});
    writer.write(-0.0f);
    writer.write(2.5);
    writer.write_string("Hall of Mirrors");

    ByteReader reader(writer.bytes());
    std::uint8_t u8 = 0;
    std::int16_t i16 = 0;
    std::uint64_t u64 = 0;
    float f = 1.0f;
    double d = 0.0;
    std::string text;
    EXPECT_TRUE(reader.read(u8) && reader.read(i16) && reader.read(u64) && reader.read(f) && reader.read(d));
    EXPECT_TRUE(reader.read_string(text, 100));
    EXPECT_EQ(u8, 200);
    EXPECT_EQ(i16, -300);
    EXPECT_EQ(u64, 0x0123456789ABCDEFu);
    EXPECT_TRUE(f == 0.0f && std::signbit(f));
    EXPECT_EQ(d, 2.5);
    EXPECT_EQ(text, "Hall of Mirrors");
    EXPECT_EQ(reader.left(), 0u);
}

TEST(Bytes, NumbersLieLowByteFirst) {
    ByteWriter writer;
    writer.write(std::uint32_t{0x04030201});
    ASSERT_EQ(writer.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(writer.bytes()[i], static_cast<std::byte>(i + 1));
}

TEST(Bytes, AReadBeyondTheEndFailsForGoodAndLeavesItsTargetAlone) {
    const std::byte three[3] = {};
    ByteReader reader(three);
    std::uint32_t four = 77;
    EXPECT_FALSE(reader.read(four));
    EXPECT_EQ(four, 77u);
    EXPECT_TRUE(reader.has_failed());
    std::uint8_t one = 5;
    EXPECT_FALSE(reader.read(one)) << "a run of reads is checked once, at its end";
    EXPECT_EQ(one, 5);
}

TEST(Bytes, ALengthThatLiesAllocatesNothing) {
    ByteWriter writer;
    writer.write(std::uint32_t{0xFFFFFFFFu});
    writer.write(std::uint8_t{1});
    std::string text = "before";
    ByteReader too_short(writer.bytes());
    EXPECT_FALSE(too_short.read_string(text, 0xFFFFFFFFu));
    ByteReader too_long(writer.bytes());
    EXPECT_FALSE(too_long.read_string(text, 10));
    EXPECT_EQ(text, "before");
    std::span<const std::byte> raw;
    ByteReader huge(writer.bytes());
    EXPECT_FALSE(huge.read_bytes(SIZE_MAX, raw)) << "position + count must not wrap round";
}

}  // namespace
}  // namespace gh

#include "base/hash.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <vector>

namespace gh {
namespace {

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}

// Published test values of XXH64 with seed 0.
TEST(Hash, IsXxh64) {
    EXPECT_EQ(hash_bytes({}), 0xEF46DB3751D8E999u);
    EXPECT_EQ(hash_bytes(bytes_of("a")), 0xD24EC4F1A98C6E5Bu);
    EXPECT_EQ(hash_bytes(bytes_of("abc")), 0x44BC2CF5AD770999u);
}

TEST(Hash, DoesNotDependOnHowBytesAreCutIntoCalls) {
    std::vector<std::byte> bytes(1000);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(i * 7);
    for (const std::size_t cut : {1u, 3u, 31u, 32u, 33u, 500u}) {
        Hasher hasher;
        for (std::size_t at = 0; at < bytes.size(); at += cut) {
            hasher.add(std::span<const std::byte>(bytes).subspan(at, std::min(cut, bytes.size() - at)));
        }
        EXPECT_EQ(hasher.digest(), hash_bytes(bytes)) << "in pieces of " << cut;
    }
}

TEST(Hash, AFieldIsItsLittleEndianBytes) {
    Hasher hasher;
    hasher.add(std::uint32_t{0x04030201});
    hasher.add(std::int16_t{-2});
    hasher.add(true);
    EXPECT_EQ(hasher.digest(), hash_bytes(bytes_of(std::string_view("\x01\x02\x03\x04\xFE\xFF\x01", 7))));
}

template <class T>
std::uint64_t digest_of(T value) {
    Hasher hasher;
    hasher.add(value);
    return hasher.digest();
}

// A guard that stands at -0 has walked another way than one at +0; the next division shows it.
TEST(Hash, TellsMinusZeroFromZeroAndKeepsNaNsApart) {
    EXPECT_NE(digest_of(0.0f), digest_of(-0.0f));
    EXPECT_EQ(digest_of(std::bit_cast<float>(0x7FC00001u)), digest_of(std::bit_cast<float>(0x7FC00001u)));
    EXPECT_NE(digest_of(std::bit_cast<float>(0x7FC00001u)), digest_of(std::bit_cast<float>(0x7FC00000u)));
}

TEST(Hash, OrderAndGroupingOfFieldsCount) {
    EXPECT_NE(digest_of(glm::vec3(1, 2, 3)), digest_of(glm::vec3(3, 2, 1)));
    Hasher ab_c, a_bc;
    ab_c.add(std::string_view("ab"));
    ab_c.add(std::string_view("c"));
    a_bc.add(std::string_view("a"));
    a_bc.add(std::string_view("bc"));
    EXPECT_NE(ab_c.digest(), a_bc.digest());
}

TEST(Hash, ADigestMayBeTakenOnTheWayAndCopiesGoTheirOwnWay) {
    Hasher hasher;
    hasher.add(1.0f);
    const std::uint64_t first = hasher.digest();
    EXPECT_EQ(hasher.digest(), first);
    Hasher copy = hasher;
    copy.add(2.0f);
    EXPECT_EQ(hasher.digest(), first);
    hasher.add(2.0f);
    EXPECT_EQ(hasher.digest(), copy.digest());
}

TEST(Hash, IsShownAsSixteenDigits) {
    EXPECT_EQ(hex16(0), "0000000000000000");
    EXPECT_EQ(hex16(0xDEADBEEF12345678u), "deadbeef12345678");
}

}  // namespace
}  // namespace gh

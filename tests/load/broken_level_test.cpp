// A level comes from a stranger. Whatever is wrong with it is one sentence, never a crash.
#include "level_bytes.h"
#include "load/limits.h"
#include "support/random.h"

#include <gmock/gmock.h>

#include <limits>

namespace gh {
namespace {

using test::Bytes;
using test::refusal;
using test::tiny_level_glb;
using test::with;
using ::testing::HasSubstr;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(BrokenLevel, SaysWhatFileAndWhatIsWrong) {
    EXPECT_EQ(refusal({}), "tiny.glb: is empty");
    EXPECT_EQ(refusal(test::as_bytes("What is this?")), "tiny.glb: is neither a .glb nor a .gltf file");
    EXPECT_THAT(refusal(with(tiny_level_glb(), test::raw(std::uint32_t{2}), test::raw(std::uint32_t{1}))),
                HasSubstr("version 1"));
    EXPECT_THAT(refusal(with(tiny_level_glb(), "\"version\":\"2.0\"", "\"version\":\"1.0\"")),
                HasSubstr("version '1.0'"));
    EXPECT_THAT(refusal(with(tiny_level_glb(), "\"nodes\":[", "\"nodes\"![")), HasSubstr("tiny.glb: "));
}

TEST(BrokenLevel, NamesAnIndexOutOfRange) {
    const std::uint16_t first_triangle[] = {0, 2, 1, 0, 3, 2}, broken[] = {0, 2, 1, 0, 9999, 2};
    EXPECT_EQ(refusal(with(tiny_level_glb(), test::raw(first_triangle), test::raw(broken))),
              "tiny.glb: mesh number 0 primitive 0: index 9999 is out of range (24 vertices)");
}

TEST(BrokenLevel, NamesAVertexThatIsNoNumber) {
    const float corner[] = {-0.5f, -0.8f, 0.0f};
    const float broken[] = {-0.5f, kNan, 0.0f};
    EXPECT_THAT(refusal(with(tiny_level_glb(), test::raw(corner), test::raw(broken))),
                HasSubstr("POSITION: accessor"));
    EXPECT_THAT(refusal(with(tiny_level_glb(), test::raw(corner), test::raw(broken))),
                HasSubstr("element 0 is not a finite number"));
}

TEST(BrokenLevel, RefusesCountsThatTheFileCannotHold) {
    EXPECT_THAT(refusal(with(tiny_level_glb(), "\"count\":24,", "\"count\":25,")), HasSubstr("do not fit"));
    EXPECT_THAT(refusal(with(tiny_level_glb(), "\"byteOffset\":0,", "\"byteOffset\":9,")),
                HasSubstr("tiny.glb: "));
}

TEST(BrokenLevel, RefusesAFileWithoutATriangle) {
    const std::string empty = R"({"asset":{"version":"2.0"},"nodes":[{"name":"nothing"}]})";
    EXPECT_EQ(refusal(test::as_bytes(empty)), "tiny.glb: has no triangles");
}

TEST(BrokenLevel, RefusesHugeCountsBeforeItAllocatesForThem) {
    // Two thousand million zeros that no byte of the file backs.
    const std::string zeros =
        R"({"asset":{"version":"2.0"},"accessors":[{"componentType":5126,"count":2000000000,)"
        R"("type":"VEC3"}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
        R"("nodes":[{"mesh":0}]})";
    EXPECT_THAT(refusal(test::as_bytes(zeros)),
                ::testing::AnyOf(HasSubstr("zeros are too many"), HasSubstr("vertices together")));
    std::string buffers = R"({"asset":{"version":"2.0"},"buffers":[)";
    for (std::size_t i = 0; i <= load::kMaxBuffers; ++i) buffers += R"({"byteLength":4},)";
    EXPECT_THAT(refusal(test::as_bytes(buffers)), HasSubstr("more than 64 buffers"));
    const std::string deep = R"({"asset":{"version":"2.0"},"extras":)" + std::string(100'000, '[');
    EXPECT_THAT(refusal(test::as_bytes(deep)), HasSubstr("nested more than 64 deep"));
}

TEST(BrokenLevel, RefusesNodesThatHangOnThemselves) {
    const std::string loop =
        R"({"asset":{"version":"2.0"},"nodes":[{"name":"a","children":[1]},{"children":[0]}],)"
        R"("scenes":[{"nodes":[0]}]})";
    EXPECT_EQ(refusal(test::as_bytes(loop)), "tiny.glb: node 'a' hangs on two nodes, or on itself");
}

TEST(BrokenLevel, NamesANodeWhoseTransformIsNotWhole) {
    for (const char* transform : {R"("matrix":[1,0,0])", R"("translation":[1,2])", R"("scale":[1])"}) {
        const std::string node =
            R"({"asset":{"version":"2.0"},"nodes":[{"name":"a",)" + std::string(transform) + "}]}";
        EXPECT_EQ(refusal(test::as_bytes(node)),
                  "tiny.glb: node 'a': its transform has too few or too many numbers");
    }
}

TEST(BrokenLevel, NamesAPictureThatIsMissingOrDamaged) {
    EXPECT_THAT(refusal(with(tiny_level_glb(), "PNG\r\n", "GNP\r\n")),
                HasSubstr("image 'plain' is neither PNG nor JPEG"));
    EXPECT_THAT(refusal(with(tiny_level_glb(), "IHDR", "IHDX")),
                HasSubstr("image 'plain' is damaged: a check sum is wrong"));
    // A JPEG cut off behind its first marker: its decoder has two lines to say of that.
    Bytes cut = with(tiny_level_glb(), "\x89PNG", "\xFF\xD8\xFF\xE0");
    EXPECT_THAT(refusal(cut), HasSubstr("image 'plain' is damaged: "));
    EXPECT_THAT(refusal(cut), ::testing::Not(HasSubstr("\n")));
    const std::string missing =
        R"({"asset":{"version":"2.0"},"images":[{"uri":"gone.png"}],"textures":[{"source":0}],)"
        R"("materials":[{"name":"wood","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}]})";
    EXPECT_EQ(refusal(test::as_bytes(missing)),
              "tiny.glb: material 'wood': image 'gone.png' is missing or empty");
}

TEST(BrokenLevel, ReadsNothingOutsideItsOwnFolder) {
    const std::string escape =
        R"({"asset":{"version":"2.0"},"buffers":[{"uri":"../secret.bin","byteLength":4}]})";
    const Result<world::Level> level = load::load_level_from_memory(test::as_bytes(escape), "tiny.gltf",
                                                                    std::filesystem::temp_directory_path());
    ASSERT_FALSE(level);
    EXPECT_THAT(level.error().sentence, HasSubstr("secret.bin"));
}

TEST(BrokenLevel, TellsTheAuthorWhatHeMistyped) {
    EXPECT_EQ(refusal(with(tiny_level_glb(), "\"kind\":\"spawn\"", "\"kind\":\"spown\"")),
              "tiny.glb: node 'spawn': there is no kind 'spown'");
    EXPECT_EQ(refusal(with(tiny_level_glb(), "\"p1, p2\"", "\"p1, px\"")),
              "tiny.glb: node 'watchman': there is no patrol point 'px'");
    EXPECT_EQ(refusal(with(tiny_level_glb(), "\"surface\":\"oak\"", "\"surface\":\"owl\"")),
              "tiny.glb: material 'oak': there is no surface 'owl'");
    EXPECT_EQ(refusal(with(tiny_level_glb(), "\"roughnessFactor\":0", "\"roughnessFactor\":1")),
              "tiny.glb: node 'mirror': is a mirror without a mirror material (metallic 1, roughness at most "
              "0.05)");
    EXPECT_EQ(refusal(with(tiny_level_glb(), "\"size\":[1,2,1]", "\"size\":[1,0,1]")),
              "tiny.glb: node 'exit': needs a size of three positive numbers");
}

// Every truncation is noticed: a .glb says how long it is.
TEST(BrokenLevel, IsRefusedWhereverItIsCutOff) {
    const Bytes whole = tiny_level_glb();
    for (std::size_t size = 0; size < whole.size(); size += 7) {
        const std::string sentence =
            refusal(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)));
        ASSERT_THAT(sentence, HasSubstr("tiny.glb: ")) << size << " bytes of " << whole.size();
    }
}

// Also when the header is made to agree with the cut.
TEST(BrokenLevel, SurvivesTruncationThatItsHeaderDoesNotBetray) {
    test::Bytes whole = tiny_level_glb();
    for (std::size_t size = 20; size < whole.size(); size += 61) {
        Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
        const auto length = static_cast<std::uint32_t>(size);
        std::memcpy(cut.data() + 8, &length, 4);
        ASSERT_NE(refusal(cut), "") << size;
    }
}

// Some flips make another valid level, the rest a sentence; which is which does not matter here, only that
// there is nothing else. Under the sanitizers this is the test that counts.
TEST(BrokenLevel, SurvivesThousandsOfFlippedBits) {
    const Bytes whole = tiny_level_glb();
    ::test::Random random(20'240'617);
    int refused = 0;
    constexpr int kTries = 3000;
    for (int i = 0; i < kTries; ++i) {
        Bytes broken = whole;
        const std::uint32_t flips = 1 + random.below(3);
        for (std::uint32_t k = 0; k < flips; ++k) {
            broken[random.below(static_cast<std::uint32_t>(broken.size()))] ^=
                static_cast<std::byte>(1u << random.below(8));
        }
        refused += !refusal(broken).empty();
    }
    EXPECT_GT(refused, kTries / 10) << "the flips did not reach anything that is checked";
    EXPECT_LT(refused, kTries) << "nothing but the untouched file loads";
}

// Numbers in the JSON are where sizes and offsets are; digits become other digits and signs.
TEST(BrokenLevel, SurvivesEveryKindOfWrongNumber) {
    const Bytes whole = tiny_level_glb();
    ::test::Random random(7);
    std::vector<std::size_t> digits;
    for (std::size_t i = 20; i < whole.size(); ++i) {
        const char c = static_cast<char>(whole[i]);
        if (c == '\0') break;  // the chunk begins
        if (c >= '0' && c <= '9') digits.push_back(i);
    }
    ASSERT_GT(digits.size(), 500u);
    constexpr std::string_view kOthers = "0123456789-e.";
    for (int i = 0; i < 2000; ++i) {
        Bytes broken = whole;
        for (int k = 0; k < 2; ++k) {
            const std::size_t at = digits[random.below(static_cast<std::uint32_t>(digits.size()))];
            broken[at] =
                static_cast<std::byte>(kOthers[random.below(static_cast<std::uint32_t>(kOthers.size()))]);
        }
        (void)refusal(broken);
    }
}

}  // namespace
}  // namespace gh

// Any glTF can be walked through: text or binary, whatever its pictures, with nothing of ours in it.
#include "level_bytes.h"
#include "load/inspect.h"
#include "world/layers.h"

#include <gmock/gmock.h>

#include <cmath>

namespace gh {
namespace {

using test::expect_near;
using ::testing::HasSubstr;

// A flat JPEG of 4 x 4 pixels, #3399e6.
constexpr const char* kJpeg =
    "/9j/4AAQSkZJRgABAQAAAQABAAD/"
    "2wBDAA0JCgsKCA0LCgsODg0PEyAVExISEyccHhcgLikxMC4pLSwzOko+MzZGNywtQFdBRkxOUlNSMj5aYVpQYEpR"
    "Uk//2wBDAQ4ODhMREyYVFSZPNS01T09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT0//"
    "wAARCAAEAAQDAREA"
    "AhEBAxEB/8QAFAABAAAAAAAAAAAAAAAAAAAAAv/EABQQAQAAAAAAAAAAAAAAAAAAAAD/xAAUAQEAAAAAAAAAAAAAAAAAAAAG/"
    "8QAFBEBAAAAAAAAAAAA"
    "AAAAAAAAAP/aAAwDAQACEQMRAD8ARAPP/9k=";

std::string base64(const std::vector<float>& values) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    std::string text;
    for (std::size_t i = 0; i < values.size() * sizeof(float);
         i += 3) {  // whole triples only: the callers' are
        const unsigned bits = (unsigned{bytes[i]} << 16) | (unsigned{bytes[i + 1]} << 8) | bytes[i + 2];
        for (int shift = 18; shift >= 0; shift -= 6) text += kDigits[(bits >> shift) & 63u];
    }
    return text;
}

// A floor of 20 x 20 m as a .gltf with everything inside it: two triangles, no normals, a JPEG, uvs at half
// scale.
std::string floor_gltf() {
    const std::vector<float> p{-10, 0, -10, -10, 0, 10, 10, 0, 10, -10, 0, -10, 10, 0, 10, 10, 0, -10};
    const std::vector<float> uv{0, 0, 0, 1, 1, 1, 0, 0, 1, 1, 1, 0};
    return R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_texture_transform"],"buffers":[)"
           R"({"byteLength":72,"uri":"data:application/octet-stream;base64,)" +
           base64(p) +
           R"("},)"
           R"({"byteLength":48,"uri":"data:application/octet-stream;base64,)" +
           base64(uv) +
           R"("}],"bufferViews":[)"
           R"({"buffer":0,"byteLength":72},{"buffer":1,"byteLength":48}],"accessors":[)"
           R"({"bufferView":0,"componentType":5126,"count":6,"type":"VEC3"},)"
           R"({"bufferView":1,"componentType":5126,"count":6,"type":"VEC2"}],)"
           R"("images":[{"uri":"data:image/jpeg;base64,)" +
           std::string(kJpeg) +
           R"("}],"textures":[{"source":0,"sampler":0}],)"
           R"("samplers":[{"wrapS":33071,"wrapT":33648}],"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,)"
           R"("extensions":{"KHR_texture_transform":{"offset":[0.25,0],"scale":[0.5,0.5]}}}}}],)"
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],"nodes":[{"mesh":0}]})";
}

TEST(ForeignLevel, IsReadFromTextWithEverythingInside) {
    const Result<world::Level> level = test::load_quickly(test::as_bytes(floor_gltf()));
    ASSERT_TRUE(level) << level.error().sentence;
    const world::Mesh& mesh = level->meshes.at(level->parts.at(0).mesh);
    ASSERT_EQ(mesh.triangles.size(), 2u);
    for (const glm::vec3& normal : mesh.normals) expect_near(normal, {0.0f, 1.0f, 0.0f});
    EXPECT_FLOAT_EQ(mesh.uvs.at(2).x, 0.75f) << "KHR_texture_transform is baked in";
    EXPECT_FLOAT_EQ(mesh.uvs.at(2).y, 0.5f);
    ASSERT_EQ(level->textures.size(), 1u);
    const world::Texture& picture = level->textures[0];
    EXPECT_EQ(picture.wrap_u, world::Wrap::Clamp);
    EXPECT_EQ(picture.wrap_v, world::Wrap::Mirror);
    ASSERT_EQ(picture.rgba.size(), 64u);
    EXPECT_NEAR(picture.rgba[0], 0x33, 4) << "JPEG loses a little";
    EXPECT_NEAR(picture.rgba[1], 0x99, 4);
    EXPECT_NEAR(picture.rgba[2], 0xE6, 4);
    EXPECT_EQ(picture.rgba[3], 255);
}

TEST(ForeignLevel, GetsASunAndAPlaceToStand) {
    const Result<world::Level> level = test::load_quickly(test::as_bytes(floor_gltf()));
    ASSERT_TRUE(level) << level.error().sentence;
    ASSERT_EQ(level->lamps.size(), 1u);
    EXPECT_EQ(level->lamps[0].shape, world::LampShape::Sun);
    EXPECT_LT(level->lamps[0].direction.y, -0.5f) << "it shines down";
    expect_near(level->spawn.position, {0.0f, 0.0f, 0.0f});
    EXPECT_EQ(level->parts[0].layers & world::kEverything, world::kEverything)
        << "all of it can be walked on";
    EXPECT_TRUE(level->guards.empty());
}

// Who brings a sky of his own is not to find a second sun in it.
TEST(ForeignLevel, GetsNoSunWhereNoneIsWanted) {
    const Result<world::Level> level = load::load_level_from_memory(
        test::as_bytes(floor_gltf()), "floor.gltf", {}, {.finds_ways = false, .hangs_sun = false});
    ASSERT_TRUE(level) << level.error().sentence;
    EXPECT_TRUE(level->lamps.empty());
}

// Without its spawn, the tiny level's player must still begin on its floor, under its roof, clear of its
// walls.
TEST(ForeignLevel, BeginsIndoorsAndClearOfTheWalls) {
    const Result<world::Level> level =
        test::load_quickly(test::with(test::tiny_level_glb(), "\"kind\":\"spawn\"", "\"kino\":\"spawn\""));
    ASSERT_TRUE(level) << level.error().sentence;
    const glm::vec3 feet = level->spawn.position;
    EXPECT_NEAR(feet.y, 0.0f, 1e-5f);
    EXPECT_LT(std::abs(feet.x), 4.0f - 0.35f);
    EXPECT_LT(std::abs(feet.z), 3.0f - 0.35f);
    EXPECT_GT(std::abs(feet.z), 0.35f) << "not in the wall between the rooms";
}

TEST(ForeignLevel, IsLitByItsOwnPanelsBeforeASunIsHung) {
    test::Bytes bytes = test::with(test::tiny_level_glb(), "\"kind\":\"lamp\"", "\"kino\":\"lamp\"");
    bytes = test::with(bytes, R"("KHR_lights_punctual":{"light")", R"("KHR_lights_elsewhen":{"light")");
    const Result<world::Level> level = test::load_quickly(bytes);
    ASSERT_TRUE(level) << level.error().sentence;
    ASSERT_EQ(level->lamps.size(), 1u);
    EXPECT_EQ(level->lamps[0].shape, world::LampShape::Sphere);
    EXPECT_EQ(level->lamps[0].name, "bulb");
}

// Two floors, one above the other and a little aside, and a lamp, all of it `far` from the file's origin.
std::string storeys_gltf(const std::string& far) {
    std::string text = floor_gltf();
    const std::string nodes = R"("nodes":[{"mesh":0}])";
    text.replace(text.find(nodes), nodes.size(),
                 R"("nodes":[{"children":[1,2,3],"translation":[)" + far +
                     R"(]},{"mesh":0},{"mesh":0,"translation":[0.1,0.37,0.2]},{"name":"lamp",)"
                     R"("translation":[0.3,2.1,0.7],"extensions":{"KHR_lights_punctual":{"light":0}}}],)"
                     R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","intensity":50}]}},)"
                     R"("scenes":[{"nodes":[0]}])");
    return text;
}

// What stands a thousand kilometres from its file's origin, where floats are 6 cm apart, is the same level as at
// home, to what doubles leave of the file's numbers, and gives the same pictures: they were off by 8e-3 (4e-4 at 100 km).
TEST(ForeignLevel, FarFromItsOwnOriginIsWhatItIsAtHome) {
    const Result<world::Level> home = test::load_quickly(test::as_bytes(storeys_gltf("0,0,0")));
    ASSERT_TRUE(home) << home.error().sentence;
    EXPECT_EQ(home->origin, glm::dvec3(0.0));
    ASSERT_EQ(home->lamps.size(), 1u);
    for (const double far : {1e3, 1e5, 1e6, 5.4e8}) {
        const std::string text = std::to_string(far);
        const Result<world::Level> level =
            test::load_quickly(test::as_bytes(storeys_gltf(text + ",0,-" + text)));
        ASSERT_TRUE(level) << level.error().sentence;
        EXPECT_EQ(level->origin, glm::dvec3(far, 0.0, -far));
        ASSERT_EQ(level->parts.size(), home->parts.size());
        for (std::size_t i = 0; i < home->parts.size(); ++i)
            // The file's numbers are doubles: 1e6 + .1 - 1e6 is .1 to 1e-10, at 5e8 to 6e-8.
            expect_near(level->parts[i].mover_from_part[3], home->parts[i].mover_from_part[3]);
        expect_near(level->lamps.at(0).position, home->lamps[0].position);
        expect_near(level->spawn.position, home->spawn.position);
    }
}

TEST(ForeignLevel, ThatReachesTooFarIsRefused) {
    EXPECT_THAT(test::refusal(test::as_bytes(storeys_gltf("2e9,0,0"))), HasSubstr("out of range"));
    std::string torn = storeys_gltf("5e6,0,0");  // half of it five thousand kilometres from the other
    torn.replace(torn.find("0.1,0.37,0.2"), 12, "-5e6,0.37,0");
    EXPECT_THAT(test::refusal(test::as_bytes(torn)), HasSubstr("out of range"));
}

TEST(ForeignLevel, ThatNeedsWhatWeDoNotReadIsRefused) {
    std::string draco = floor_gltf();
    draco.replace(draco.find("KHR_texture_transform"), 21, "KHR_draco_compression");
    EXPECT_EQ(test::refusal(test::as_bytes(draco)),
              "tiny.glb: requires the extension KHR_draco_compression, which is not read");
}

TEST(Inspect, NamesTheFileThatIsNotThere) {
    const auto page = load::describe_level("/nowhere/at/all.glb");
    ASSERT_FALSE(page);
    EXPECT_THAT(page.error().sentence, HasSubstr("/nowhere/at/all.glb"));
}

TEST(Inspect, TellsOfTheBundledLevelWhatAPlayerMeets) {
    const auto page = load::describe_level(GLASSHOUSE_SOURCE_DIR "/assets/levels/foyer.glb");
    ASSERT_TRUE(page) << page.error().sentence;
    for (const char* word : {"Hall of Mirrors", "lens ", "guard ", "navmesh", "doors", "hash"})
        EXPECT_THAT(page->text, HasSubstr(word));
    EXPECT_EQ(page->errors, 0u) << "a bundled level is fair";
    EXPECT_THAT(page->text, ::testing::Not(HasSubstr("ERROR")));
}

}  // namespace
}  // namespace gh

// glTF's materials: what extensions say arrives, and nonsense arrives as the nearest sense.
#include "level_bytes.h"

#include <gmock/gmock.h>

#include <string>

namespace gh {
namespace {

// A PNG of one red pixel, half transparent or so.
constexpr const char* kPixel =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==";

// A floor of 20 x 20 m made of `materials` (a JSON array whose first one is worn), corners and uvs as hexadecimal would
// be too long: positions (-10, 0, -10), (-10, 0, 10), (10, 0, 10), (10, 0, -10) and uvs (0, 0) ... (1, 0).
std::string gltf_with(const std::string& materials) {
    return R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_materials_unlit","KHR_materials_anisotropy"],)"
           R"("extensionsRequired":["KHR_materials_unlit","KHR_materials_anisotropy"],)"
           R"("buffers":[{"byteLength":92,"uri":"data:application/octet-stream;base64,)"
           "AAAgwQAAAAAAACDBAAAgwQAAAAAAACBBAAAgQQAAAAAAACBBAAAgQQAAAAAAACDB"
           "AAAAAAAAAAAAAAAAAACAPwAAgD8AAIA/AACAPwAAAAAAAAEAAgAAAAIAAwA="
           R"("}],"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":32},)"
           R"({"buffer":0,"byteOffset":80,"byteLength":12}],"accessors":[)"
           R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[-10,0,-10],"max":[10,0,10]},)"
           R"({"bufferView":1,"componentType":5126,"count":4,"type":"VEC2"},)"
           R"({"bufferView":2,"componentType":5123,"count":6,"type":"SCALAR"}],"images":[{"uri":")" +
           std::string(kPixel) +
           R"("}],"samplers":[{"wrapS":33071,"wrapT":33648},{}],"textures":[{"source":0,"sampler":0},)"
           R"({"source":0,"sampler":1}],"materials":)" +
           materials +
           R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0}]}],)"
           R"("nodes":[{"mesh":0}]})";
}

Result<world::Level> level_with(const std::string& materials) {
    return test::load_quickly(test::as_bytes(gltf_with(materials)));
}

TEST(Materials, LayersArriveWithTheirTextures) {
    const Result<world::Level> level = level_with(
        R"([{"extensions":{"KHR_materials_clearcoat":{"clearcoatFactor":0.7,"clearcoatRoughnessFactor":0.2,)"
        R"("clearcoatTexture":{"index":0}},"KHR_materials_sheen":{"sheenColorFactor":[0.1,0.2,0.3],)"
        R"("sheenRoughnessFactor":0.4,"sheenColorTexture":{"index":1}},"KHR_materials_anisotropy":)"
        R"({"anisotropyStrength":0.5,"anisotropyRotation":1.25},"KHR_materials_specular":)"
        R"({"specularFactor":0.25,"specularColorFactor":[2,1,0.5]}}}])");
    ASSERT_TRUE(level) << level.error().sentence;
    const world::Material& m = level->materials.at(0);
    EXPECT_TRUE(m.has_layers);
    EXPECT_FLOAT_EQ(m.layers.coat, 0.7f);
    EXPECT_FLOAT_EQ(m.layers.coat_roughness, 0.2f);
    EXPECT_NE(m.layers.coat_texture, world::kNoIndex);
    EXPECT_FLOAT_EQ(m.layers.sheen_color.z, 0.3f);
    EXPECT_FLOAT_EQ(m.layers.sheen_roughness, 0.4f);
    EXPECT_NE(m.layers.sheen_color_texture, m.layers.coat_texture) << "they wrap otherwise";
    EXPECT_FLOAT_EQ(m.layers.anisotropy, 0.5f);
    EXPECT_FLOAT_EQ(m.layers.anisotropy_rotation, 1.25f);
    EXPECT_FLOAT_EQ(m.specular, 0.25f);
    EXPECT_FLOAT_EQ(m.layers.specular_color.x, 2.0f) << "may be above 1: what comes of it is clamped";
}

TEST(Materials, NumbersOutOfRangeAreClamped) {
    const Result<world::Level> level = level_with(
        R"([{"extensions":{"KHR_materials_clearcoat":{"clearcoatFactor":-3,"clearcoatRoughnessFactor":1e300},)"
        R"("KHR_materials_sheen":{"sheenColorFactor":[-1,7,"red"],"sheenRoughnessFactor":-0.5},)"
        R"("KHR_materials_anisotropy":{"anisotropyStrength":44},"KHR_materials_ior":{"ior":1e30}}}])");
    ASSERT_TRUE(level) << level.error().sentence;
    const world::Material& m = level->materials.at(0);
    EXPECT_EQ(m.layers.coat, 0.0f);
    EXPECT_EQ(m.layers.coat_roughness, 1.0f);
    EXPECT_EQ(m.layers.sheen_color, glm::vec3(0.0f, 1.0f, 0.0f));
    EXPECT_EQ(m.layers.sheen_roughness, 0.0f);
    EXPECT_EQ(m.layers.anisotropy, 1.0f);
}

TEST(Materials, ATextureThatIsNotThereIsASentence) {
    const Result<world::Level> level = level_with(
        R"([{"name":"velvet","extensions":{"KHR_materials_sheen":{"sheenColorTexture":{"index":9}}}}])");
    ASSERT_FALSE(level);
    EXPECT_THAT(level.error().sentence, ::testing::HasSubstr("velvet"));
    EXPECT_THAT(level.error().sentence, ::testing::HasSubstr("texture 9 does not exist"));
}

TEST(Materials, UnlitShinesInItsColourAndMirrorsNothing) {
    const Result<world::Level> level = level_with(
        R"([{"pbrMetallicRoughness":{"baseColorFactor":[0.2,0.4,0.6,0.5],"baseColorTexture":{"index":0},)"
        R"("metallicFactor":1},"alphaMode":"BLEND","extensions":{"KHR_materials_unlit":{}}}])");
    ASSERT_TRUE(level) << level.error().sentence;
    const world::Material& m = level->materials.at(0);
    EXPECT_EQ(m.emission, glm::vec3(0.2f, 0.4f, 0.6f));
    EXPECT_EQ(m.base_color, glm::vec4(0.0f, 0.0f, 0.0f, 0.5f));
    EXPECT_EQ(m.emission_texture, m.base_color_texture);
    EXPECT_EQ(m.metallic, 0.0f);
    EXPECT_EQ(m.ior, 1.0f);
}

// One transform for all goes into the mesh; two that differ stay with the material, and the mesh keeps its own.
TEST(Materials, TextureTransformsThatDifferAreKeptApart) {
    const std::string turned =
        R"("extensions":{"KHR_texture_transform":{"offset":[0.25,0],"scale":[0.5,2]}})";
    const Result<world::Level> alike =
        level_with(R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,)" + turned +
                   R"(}},"emissiveTexture":{"index":0,)" + turned + "}}]");
    ASSERT_TRUE(alike) << alike.error().sentence;
    EXPECT_TRUE(alike->materials.at(0).uv_transforms.empty());
    EXPECT_FLOAT_EQ(alike->meshes.at(0).uvs.at(2).x, 0.75f);
    const Result<world::Level> apart = level_with(
        R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,)" + turned +
        R"(}},"emissiveTexture":{"index":0},"extensions":{"KHR_materials_clearcoat":{"clearcoatFactor":1,)"
        R"("clearcoatTexture":{"index":1,)" +
        turned + "}}}}]");
    ASSERT_TRUE(apart) << apart.error().sentence;
    const auto& transforms = apart->materials.at(0).uv_transforms;
    ASSERT_EQ(transforms.size(), world::kTextureSlots);
    EXPECT_FLOAT_EQ(apart->meshes.at(0).uvs.at(2).x, 1.0f);
    for (const world::TextureSlot slot : {world::TextureSlot::BaseColor, world::TextureSlot::Coat}) {
        const glm::vec2 at = transforms[static_cast<std::size_t>(slot)] * glm::vec3(1.0f, 1.0f, 1.0f);
        EXPECT_FLOAT_EQ(at.x, 0.75f);
        EXPECT_FLOAT_EQ(at.y, 2.0f);
    }
    EXPECT_EQ(transforms[static_cast<std::size_t>(world::TextureSlot::Emission)], glm::mat3x2(1.0f));
}

}  // namespace
}  // namespace gh

// glTF's materials: what extensions say arrives, and nonsense arrives as the nearest sense.
#include "level_bytes.h"

#include <gmock/gmock.h>

#include <iterator>
#include <string>
#include <utility>

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
    const Result<world::Level> below = level_with(R"([{"normalTexture":{"index":-5}}])");
    ASSERT_FALSE(below);
    EXPECT_THAT(below.error().sentence, ::testing::HasSubstr("texture -5 does not exist"));
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

// The remark that has both in it, or none.
std::string remark_with(const world::Level& level, const std::string& item, const std::string& value) {
    for (const std::string& remark : level.remarks) {
        if (remark.find(item) != std::string::npos && remark.find(value) != std::string::npos) return remark;
    }
    return {};
}

// A viewer goes on, but says what it took for what.
TEST(Materials, NonsenseIsToldAndCountsAsTheNearestSense) {
    const Result<world::Level> level = level_with(
        R"([{"name":"odd","pbrMetallicRoughness":{"roughnessFactor":7,"metallicFactor":-3,)"
        R"("baseColorFactor":[9,0.5,-1,1],"baseColorTexture":{"index":0,"extensions":)"
        R"({"KHR_texture_transform":{"scale":[1e30,"wide"]}}}},"alphaMode":"GLOW","alphaCutoff":-1,"occlusionTexture":)"
        R"({"index":0,"strength":5},"normalTexture":{"index":0,"scale":1e9},"emissiveFactor":[1,1,1],)"
        R"("extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":-2},"KHR_materials_ior":)"
        R"({"ior":0.5},"KHR_materials_volume":{"attenuationDistance":0,"thicknessFactor":-4},)"
        R"("KHR_materials_clearcoat":{"clearcoatFactor":"much"}}}])");
    ASSERT_TRUE(level) << level.error().sentence;
    const world::Material& m = level->materials.at(0);
    EXPECT_EQ(m.roughness, 1.0f);
    EXPECT_EQ(m.metallic, 0.0f);
    EXPECT_EQ(m.base_color, glm::vec4(1.0f, 0.5f, 0.0f, 1.0f));
    EXPECT_EQ(m.alpha_cutoff, 0.0f);
    EXPECT_EQ(m.normal_scale, 100.0f);
    EXPECT_EQ(m.emission, glm::vec3(0.0f));
    EXPECT_EQ(m.ior, 1.0f);
    EXPECT_EQ(m.attenuation_distance, rc::kInfinity);
    const std::pair<const char*, const char*> told[] = {{"alphaMode", "GLOW"},
                                                        {"roughnessFactor", "7"},
                                                        {"metallicFactor", "-3"},
                                                        {"baseColorFactor[0]", "9"},
                                                        {"baseColorFactor[2]", "-1"},
                                                        {"scale[0]", "1e+30"},
                                                        {"scale[1]", "no number"},
                                                        {"alphaCutoff", "-1"},
                                                        {"occlusionTexture", "5"},
                                                        {"normalTexture", "1000000000"},
                                                        {"emissiveStrength", "-2"},
                                                        {"ior", "0.5"},
                                                        {"attenuationDistance", "absorbed"},
                                                        {"thicknessFactor", "-4"},
                                                        {"clearcoatFactor", "no number"}};
    for (const auto& [item, value] : told) {
        const std::string remark = remark_with(*level, item, value);
        EXPECT_THAT(remark, ::testing::StartsWith("material 'odd': ")) << item << " " << value;
    }
    EXPECT_EQ(level->remarks.size(), std::size(told)) << "what is sense is not told";
}

TEST(Materials, WhatTheSpecificationAllowsIsNotToldOf) {
    const Result<world::Level> level = level_with(
        R"([{"alphaMode":"MASK","alphaCutoff":1.5,"extensions":{"KHR_materials_ior":{"ior":0},)"
        R"("KHR_materials_transmission":{"transmissionFactor":1},"KHR_materials_volume":{"thicknessFactor":2}}}])");
    ASSERT_TRUE(level) << level.error().sentence;
    EXPECT_TRUE(level->remarks.empty()) << level->remarks.front();
    const world::Material& m = level->materials.at(0);
    EXPECT_GT(m.alpha_cutoff, 1.0f) << "all of it is a hole";
    EXPECT_EQ(m.ior, 0.0f);
    EXPECT_EQ(m.transmission, 0.0f) << "it mirrors all, and nothing enters";
}

// A picture of numbers is read as it is, of colours by sRGB's curve: used as both it is two textures.
TEST(Materials, OnePictureAsColourAndAsNumbersIsTwoTextures) {
    const Result<world::Level> level = level_with(
        R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":0}},)"
        R"("emissiveTexture":{"index":0},"normalTexture":{"index":0}}])");
    ASSERT_TRUE(level) << level.error().sentence;
    const world::Material& m = level->materials.at(0);
    EXPECT_EQ(level->textures.size(), 2u);
    EXPECT_EQ(m.base_color_texture, m.emission_texture);
    EXPECT_EQ(m.metallic_roughness_texture, m.normal_texture);
    EXPECT_NE(m.base_color_texture, m.normal_texture);
}

TEST(Materials, TexturesOfGlassAndOfVarnishBumpsArrive) {
    const Result<world::Level> level = level_with(
        R"([{"extensions":{"KHR_materials_transmission":{"transmissionFactor":0.5,"transmissionTexture":)"
        R"({"index":1}},"KHR_materials_clearcoat":{"clearcoatFactor":1,"clearcoatNormalTexture":)"
        R"({"index":0,"scale":0.25}}}}])");
    ASSERT_TRUE(level) << level.error().sentence;
    const world::Material& m = level->materials.at(0);
    EXPECT_NE(m.transmission_texture, world::kNoIndex);
    EXPECT_NE(m.layers.coat_normal_texture, world::kNoIndex);
    EXPECT_FLOAT_EQ(m.layers.coat_normal_scale, 0.25f);
}

TEST(Materials, UvSetsThatDifferAreTold) {
    const Result<world::Level> level = level_with(
        R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}},"emissiveTexture":{"index":0,"texCoord":1}}])");
    ASSERT_TRUE(level) << level.error().sentence;
    EXPECT_NE(remark_with(*level, "more than one uv set", "TEXCOORD_0"), "");
    const Result<world::Level> missing = level_with(R"([{"normalTexture":{"index":0,"texCoord":3}}])");
    ASSERT_TRUE(missing) << missing.error().sentence;
    EXPECT_NE(remark_with(*missing, "has no TEXCOORD_3", "TEXCOORD_0"), "");
}

// With `from` in the place of what stands in for it.
Result<world::Level> level_changed(const std::string& from, const std::string& to) {
    std::string text = gltf_with("[{}]");
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    return test::load_quickly(test::as_bytes(text));
}

TEST(Materials, ColoursOfCornersArriveWithOrWithoutAlpha) {
    // The positions will do for colours: only their places in the file count here.
    const Result<world::Level> level = level_changed(R"("TEXCOORD_0":1})", R"("TEXCOORD_0":1,"COLOR_0":0})");
    ASSERT_TRUE(level) << level.error().sentence;
    const world::Mesh& mesh = level->meshes.at(0);
    ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
    for (const glm::vec4& color : mesh.colors) {
        EXPECT_EQ(color.x, color.x > 0.0f ? 10.0f : 0.0f) << "light can not be taken away";
        EXPECT_EQ(color.w, 1.0f);
    }
}

TEST(Materials, AnExtensionThatIsPassedOverIsTold) {
    const Result<world::Level> level =
        level_changed(R"("extensionsUsed":[)", R"("extensionsUsed":["KHR_materials_iridescence",)");
    ASSERT_TRUE(level) << level.error().sentence;
    EXPECT_NE(remark_with(*level, "uses the extension", "KHR_materials_iridescence"), "");
}

Result<world::Level> level_with_camera(const std::string& camera, const std::string& node) {
    return level_changed(R"("nodes":[{"mesh":0}])", R"("cameras":[)" + camera + R"(],"nodes":[{"mesh":0},{)" +
                                                        R"("name":"eye","camera":0)" + node + "}]");
}

Result<world::Level> level_with_light(const std::string& light) {
    return level_changed(R"("nodes":[{"mesh":0}])",
                         R"("extensions":{"KHR_lights_punctual":{"lights":[)" + light +
                             R"(]}},"nodes":[{"mesh":0},{"name":"bulb","extensions":)" +
                             R"({"KHR_lights_punctual":{"light":0}}}])");
}

TEST(Materials, LampsOutOfRangeAreTold) {
    const Result<world::Level> dark = level_with_light(R"({"type":"point","intensity":-5,"range":-1})");
    ASSERT_TRUE(dark) << dark.error().sentence;
    EXPECT_NE(remark_with(*dark, "node 'bulb': intensity -5 ", "counts as 0"), "");
    EXPECT_NE(remark_with(*dark, "node 'bulb': range -1 ", "passed over"), "");
    EXPECT_EQ(dark->remarks.size(), 2u);
    const Result<world::Level> spot =
        level_with_light(R"({"type":"spot","intensity":683,"spot":{"innerConeAngle":2,"outerConeAngle":1}})");
    ASSERT_TRUE(spot) << spot.error().sentence;
    EXPECT_NE(remark_with(*spot, "innerConeAngle 2 ", "counts as 1"), "");
    EXPECT_EQ(spot->lamps.at(0).intensity, glm::vec3(1.0f)) << "683 lm a watt";
    const Result<world::Level> unknown = level_with_light(R"({"type":"laser"})");
    ASSERT_FALSE(unknown);
    EXPECT_THAT(unknown.error().sentence,
                ::testing::HasSubstr("node 'bulb': there is no light of type 'laser'"));
}

TEST(Materials, CamerasOutOfRangeAreTold) {
    const auto perspective = [](const std::string& yfov) {
        return level_with_camera(R"({"type":"perspective","perspective":{"znear":0.1,"yfov":)" + yfov + "}}",
                                 "");
    };
    const Result<world::Level> narrow = perspective("0"), wide = perspective("4"), fine = perspective("0.6");
    ASSERT_TRUE(narrow && wide && fine);
    EXPECT_NE(remark_with(*narrow, "camera 'eye': yfov 0 ", "0.01"), "");
    EXPECT_NE(remark_with(*wide, "camera 'eye': yfov 4 ", "3"), "");
    EXPECT_TRUE(fine->remarks.empty());
    EXPECT_EQ(fine->viewpoints.at(0).roll, 0.0f);
    const Result<world::Level> flat = level_with_camera(
        R"({"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"znear":0.1,"zfar":9}})", "");
    ASSERT_TRUE(flat);
    EXPECT_NE(remark_with(*flat, "camera 'eye'", "orthographic"), "");
}

// Leaning by 30 degrees to its left: what is up for it lies to the left of what is up.
TEST(Materials, ACameraThatLeansLeans) {
    const Result<world::Level> level =
        level_with_camera(R"({"type":"perspective","perspective":{"znear":0.1,"yfov":0.6}})",
                          R"(,"rotation":[0,0,0.25881904510252074,0.9659258262890683])");
    ASSERT_TRUE(level);
    EXPECT_NEAR(level->viewpoints.at(0).roll, 0.5235988f, 1e-6f);
}

}  // namespace
}  // namespace gh

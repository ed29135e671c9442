#include "load/gltf_materials.h"

#include "base/det_math.h"
#include "load/gltf_extras.h"
#include "load/gltf_file.h"
#include "load/gltf_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace gh::load {
namespace {

using tinygltf::Value;

constexpr Range kRadiance{0.0, 1.0e9};

// What light does in and on it, as far as factors go.
void read_factors(const tinygltf::Material& from, const NumberReader& numbers, world::Material& to) {
    const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
    for (std::size_t i = 0; i < 4 && i < pbr.baseColorFactor.size(); ++i) {
        to.base_color[static_cast<glm::length_t>(i)] =
            numbers.within(fmt::format("baseColorFactor[{}]", i), pbr.baseColorFactor[i], kShare);
    }
    to.metallic = numbers.within("metallicFactor", pbr.metallicFactor, kShare);
    to.roughness = numbers.within("roughnessFactor", pbr.roughnessFactor, kShare);
    // Above 1 all of it is a hole.
    to.alpha_cutoff = numbers.within("alphaCutoff", from.alphaCutoff, {0.0, 1.0e9});
    to.alpha_mode = from.alphaMode == "MASK"    ? world::AlphaMode::Mask
                    : from.alphaMode == "BLEND" ? world::AlphaMode::Blend
                                                : world::AlphaMode::Opaque;
    if (to.alpha_mode == world::AlphaMode::Opaque && from.alphaMode != "OPAQUE")
        numbers.remark(fmt::format("there is no alphaMode '{}', and it is opaque", from.alphaMode));
    to.is_double_sided = from.doubleSided;
    const double strength = numbers.exact_number(
        extension(from.extensions, "KHR_materials_emissive_strength"), "emissiveStrength", 1.0, kRadiance);
    for (std::size_t i = 0; i < 3 && i < from.emissiveFactor.size(); ++i) {
        to.emission[static_cast<glm::length_t>(i)] =
            numbers.within(fmt::format("emissiveFactor[{}] x emissiveStrength", i),
                           from.emissiveFactor[i] * strength, kRadiance);
    }
}

constexpr double kMostIor = 5.0;  // what render computes with

// An index of 0 is glTF's word for what mirrors all light that its colour of reflection lets it: nothing enters.
void read_glass(const tinygltf::ExtensionMap& extensions, const NumberReader& numbers, world::Material& to) {
    to.transmission = numbers.number(extension(extensions, "KHR_materials_transmission"),
                                     "transmissionFactor", 0.0, kShare);
    const Value* ior = member(extension(extensions, "KHR_materials_ior"), "ior");
    if (ior != nullptr && ior->IsNumber() && ior->GetNumberAsDouble() == 0.0) {
        to.ior = to.transmission = 0.0f;
    } else {
        to.ior = numbers.number(extension(extensions, "KHR_materials_ior"), "ior", 1.5, {1.0, kMostIor});
    }
    to.specular =
        numbers.number(extension(extensions, "KHR_materials_specular"), "specularFactor", 1.0, kShare);
    const Value* volume = extension(extensions, "KHR_materials_volume");
    to.attenuation_color = numbers.color(volume, "attenuationColor", 1.0, kShare);
    const Value* distance = member(volume, "attenuationDistance");
    if (distance == nullptr) return;
    if (distance->IsNumber() && distance->GetNumberAsDouble() > 0.0) {
        to.attenuation_distance = numbers.number(volume, "attenuationDistance", 0.0, {1.0e-6, 1.0e9});
    } else {
        numbers.remark("attenuationDistance is no number above 0, so nothing is absorbed");
    }
}

constexpr Range kPlaces{-1.0e6, 1.0e6}, kUvSets{0.0, 7.0};

// uv' = offset + rotation(scale * uv); turning by an angle is counter-clockwise in glTF's v-down frame.
UvUse read_uv_use(const tinygltf::TextureInfo& info, const NumberReader& numbers) {
    UvUse use;
    use.set = static_cast<int>(numbers.within("texCoord", info.texCoord, kUvSets));
    const Value* transform = extension(info.extensions, "KHR_texture_transform");
    if (transform == nullptr) return use;
    const float angle = numbers.number(transform, "rotation", 0.0, kPlaces);
    const glm::vec2 s{numbers.element(transform, "scale", 0, 1.0, kPlaces),
                      numbers.element(transform, "scale", 1, 1.0, kPlaces)};
    const det::SinCos turn = det::sin_cos(angle);
    use.uv_from_file[0] = glm::vec2(turn.cos, -turn.sin) * s.x;
    use.uv_from_file[1] = glm::vec2(turn.sin, turn.cos) * s.y;
    use.uv_from_file[2] = {numbers.element(transform, "offset", 0, 0.0, kPlaces),
                           numbers.element(transform, "offset", 1, 0.0, kPlaces)};
    use.set = static_cast<int>(numbers.number(transform, "texCoord", use.set, kUvSets));
    use.is_plain = use.uv_from_file == glm::mat3x2(1.0f);
    return use;
}

// A texture inside an extension; tinygltf reads only the core's.
tinygltf::TextureInfo texture_info(const Value* object, const char* key, const NumberReader& numbers) {
    tinygltf::TextureInfo info;
    const Value* texture = member(object, key);
    if (texture == nullptr) return info;
    info.index = static_cast<int>(numbers.number(texture, "index", -1.0, {-1.0, 1.0e9}));
    info.texCoord = static_cast<int>(numbers.number(texture, "texCoord", 0.0, kUvSets));
    const Value* extensions = member(texture, "extensions");
    if (const Value* transform = member(extensions, "KHR_texture_transform"))
        info.extensions.emplace("KHR_texture_transform", *transform);
    return info;
}

// All textures of a material, one a slot.
using TextureInfos = std::array<tinygltf::TextureInfo, world::kTextureSlots>;

TextureInfos texture_infos(const tinygltf::Material& from, const NumberReader& numbers) {
    const Value* specular = extension(from.extensions, "KHR_materials_specular");
    const Value* coat = extension(from.extensions, "KHR_materials_clearcoat");
    const Value* sheen = extension(from.extensions, "KHR_materials_sheen");
    const Value* anisotropy = extension(from.extensions, "KHR_materials_anisotropy");
    const Value* transmission = extension(from.extensions, "KHR_materials_transmission");
    tinygltf::TextureInfo normal;
    normal.index = from.normalTexture.index;
    normal.texCoord = from.normalTexture.texCoord;
    normal.extensions = from.normalTexture.extensions;
    return {from.pbrMetallicRoughness.baseColorTexture,
            from.pbrMetallicRoughness.metallicRoughnessTexture,
            normal,
            from.emissiveTexture,
            texture_info(specular, "specularTexture", numbers),
            texture_info(specular, "specularColorTexture", numbers),
            texture_info(coat, "clearcoatTexture", numbers),
            texture_info(coat, "clearcoatRoughnessTexture", numbers),
            texture_info(sheen, "sheenColorTexture", numbers),
            texture_info(sheen, "sheenRoughnessTexture", numbers),
            texture_info(anisotropy, "anisotropyTexture", numbers),
            texture_info(coat, "clearcoatNormalTexture", numbers),
            texture_info(transmission, "transmissionTexture", numbers)};
}

// All textures of a material share one set of uvs in the game, that of the first it has. Their transforms go into the
// mesh if they are all the same, and are the material's otherwise.
UvUse uv_use(const TextureInfos& infos, const NumberReader& numbers, world::Material& material) {
    std::vector<glm::mat3x2> transforms(infos.size(), glm::mat3x2(1.0f));
    std::optional<UvUse> first;
    bool agree = true, is_one_set = true;
    for (std::size_t i = 0; i < infos.size(); ++i) {
        if (infos[i].index < 0) continue;
        const UvUse use = read_uv_use(infos[i], numbers);
        transforms[i] = use.uv_from_file;
        if (!first) first = use;
        agree = agree && use.uv_from_file == first->uv_from_file;
        is_one_set = is_one_set && use.set == first->set;
    }
    if (!first) return {};
    if (!is_one_set)
        numbers.remark(fmt::format(
            "its textures lie by more than one uv set, and all are shown by TEXCOORD_{}", first->set));
    if (agree) return *first;
    material.uv_transforms = std::move(transforms);
    return {.uv_from_file = glm::mat3x2(1.0f), .set = first->set, .is_plain = true};
}

Result<void> read_textures(const TextureInfos& infos, TextureSet& textures, world::Material& to) {
    world::Layers& layers = to.layers;
    const std::array<std::uint32_t*, world::kTextureSlots> ids = {
        &to.base_color_texture,      &to.metallic_roughness_texture,
        &to.normal_texture,          &to.emission_texture,
        &layers.specular_texture,    &layers.specular_color_texture,
        &layers.coat_texture,        &layers.coat_roughness_texture,
        &layers.sheen_color_texture, &layers.sheen_roughness_texture,
        &layers.anisotropy_texture,  &layers.coat_normal_texture,
        &to.transmission_texture};
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const bool is_color = world::holds_colors(static_cast<world::TextureSlot>(i));
        const Result<std::uint32_t> texture = textures.use(infos[i].index, is_color);
        if (!texture) return texture.error();
        *ids[i] = *texture;
    }
    return {};
}

constexpr Range kNormalScales{-100.0, 100.0};

void read_layers(const tinygltf::ExtensionMap& extensions, const NumberReader& numbers, world::Material& to) {
    world::Layers& layers = to.layers;
    const Value* specular = extension(extensions, "KHR_materials_specular");
    const Value* coat = extension(extensions, "KHR_materials_clearcoat");
    const Value* sheen = extension(extensions, "KHR_materials_sheen");
    const Value* anisotropy = extension(extensions, "KHR_materials_anisotropy");
    // More than 1 is allowed, since what comes of it is clamped again: f0 is at most 1.
    layers.specular_color = numbers.color(specular, "specularColorFactor", 1.0, {0.0, 1.0e3});
    layers.coat = numbers.number(coat, "clearcoatFactor", 0.0, kShare);
    layers.coat_roughness = numbers.number(coat, "clearcoatRoughnessFactor", 0.0, kShare);
    layers.coat_normal_scale =
        numbers.number(member(coat, "clearcoatNormalTexture"), "scale", 1.0, kNormalScales);
    layers.sheen_color = numbers.color(sheen, "sheenColorFactor", 0.0, kShare);
    layers.sheen_roughness = numbers.number(sheen, "sheenRoughnessFactor", 0.0, kShare);
    layers.anisotropy = numbers.number(anisotropy, "anisotropyStrength", 0.0, kShare);
    layers.anisotropy_rotation = numbers.number(anisotropy, "anisotropyRotation", 0.0, kPlaces);
    to.has_layers = specular != nullptr || layers.coat > 0.0f || layers.sheen_color != glm::vec3(0.0f) ||
                    layers.anisotropy > 0.0f;
}

// Black, without any gloss, and shining in its base colour by itself. Alpha stays with the base colour's texture.
void make_unlit(world::Material& material) {
    material.emission = glm::vec3(material.base_color);
    material.emission_texture = material.base_color_texture;
    if (!material.uv_transforms.empty())
        material.uv_transforms[static_cast<std::size_t>(world::TextureSlot::Emission)] =
            material.uv_transforms[static_cast<std::size_t>(world::TextureSlot::BaseColor)];
    material.base_color = glm::vec4(0.0f, 0.0f, 0.0f, material.base_color.w);
    material.metallic = material.transmission = 0.0f;
    material.roughness = material.ior = 1.0f;
    material.normal_texture = material.metallic_roughness_texture = world::kNoIndex;
    material.transmission_texture = world::kNoIndex;
    material.has_layers = false;
}

Result<world::Surface> read_surface(const tinygltf::Material& from, const world::Material& material) {
    const Result<std::string> name = text_or(from.extras, "surface", "");
    if (!name) return name.error();
    if (name->empty()) {
        if (material.transmission > 0.0f) return world::Surface::Glass;
        return material.metallic > 0.5f ? world::Surface::Metal : world::Surface::Plaster;
    }
    const std::optional<world::Surface> surface = world::surface_from_name(*name);
    if (!surface) return Error{fmt::format("there is no surface '{}'", *name)};
    return *surface;
}

// What no path needs is read all the same, for the sake of who mistyped it.
void check_unused(const tinygltf::Material& from, const NumberReader& numbers) {
    static_cast<void>(numbers.within("occlusionTexture.strength", from.occlusionTexture.strength, kShare));
    static_cast<void>(numbers.number(extension(from.extensions, "KHR_materials_volume"), "thicknessFactor",
                                     0.0, {0.0, 1.0e9}));
}

Result<world::Material> read_material(const tinygltf::Material& from, const NumberReader& numbers,
                                      TextureSet& textures, UvUse& uvs) {
    world::Material material;
    material.name = from.name;
    read_factors(from, numbers, material);
    read_glass(from.extensions, numbers, material);
    read_layers(from.extensions, numbers, material);
    check_unused(from, numbers);
    const TextureInfos infos = texture_infos(from, numbers);
    if (const Result<void> read = read_textures(infos, textures, material); !read) return read.error();
    material.normal_scale = numbers.within("normalTexture.scale", from.normalTexture.scale, kNormalScales);
    uvs = uv_use(infos, numbers, material);
    if (extension(from.extensions, "KHR_materials_unlit") != nullptr) make_unlit(material);
    const Result<float> priority = number_or(from.extras, "priority", 0.0f);
    if (!priority) return priority.error();
    constexpr float kMostPriority = 1000.0f;
    if (!(std::abs(*priority) <= kMostPriority))
        return Error{fmt::format("priority {} is not between -1000 and 1000", *priority)};
    material.priority = static_cast<std::int16_t>(std::lround(*priority));
    const Result<world::Surface> surface = read_surface(from, material);
    if (!surface) return surface.error();
    material.surface = *surface;
    return material;
}

// glTF's own default is a white metal, which shows black in a night scene: unpainted plaster is what is
// meant.
world::Material unpainted() {
    world::Material material;
    material.name = "(none)";
    material.base_color = glm::vec4(0.8f, 0.8f, 0.8f, 1.0f);
    material.is_double_sided = true;
    return material;
}

}  // namespace

Result<MaterialSet> read_materials(const tinygltf::Model& model, TextureSet& textures) {
    MaterialSet set;
    for (std::size_t i = 0; i < model.materials.size(); ++i) {
        UvUse uvs;
        const std::string whose = "material " + name_or_number(model.materials[i].name, i);
        const NumberReader numbers(whose, set.remarks);
        Result<world::Material> material = read_material(model.materials[i], numbers, textures, uvs);
        if (!material) return Error{fmt::format("{}: {}", whose, material.error().sentence)};
        set.materials.push_back(std::move(*material));
        set.uvs.push_back(uvs);
    }
    set.materials.push_back(unpainted());
    set.uvs.emplace_back();
    return set;
}

}  // namespace gh::load

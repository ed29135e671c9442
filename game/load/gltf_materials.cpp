#include "load/gltf_materials.h"

#include "base/det_math.h"
#include "load/gltf_extras.h"
#include "load/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace gh::load {
namespace {

using tinygltf::Value;

float clamped(double value, double low, double high) {
    return static_cast<float>(std::clamp(value, low, high));  // JSON knows no NaN
}

// A member of an extension object, or nothing.
const Value* member(const Value* object, const char* key) {
    return object != nullptr && object->IsObject() && object->Has(key) ? &object->Get(key) : nullptr;
}

const Value* extension(const tinygltf::ExtensionMap& extensions, const char* name) {
    const auto found = extensions.find(name);
    return found == extensions.end() ? nullptr : &found->second;
}

double number(const Value* object, const char* key, double fallback) {
    const Value* value = member(object, key);
    return value != nullptr && value->IsNumber() ? value->GetNumberAsDouble() : fallback;
}

double element(const Value* array, int i, double fallback) {
    if (array == nullptr || !array->IsArray() || static_cast<std::size_t>(i) >= array->ArrayLen())
        return fallback;
    return array->Get(i).IsNumber() ? array->Get(i).GetNumberAsDouble() : fallback;
}

constexpr double kMostRadiance = 1.0e9;

// What light does in and on it, as far as factors go.
void read_factors(const tinygltf::Material& from, world::Material& to) {
    const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
    for (std::size_t i = 0; i < 4 && i < pbr.baseColorFactor.size(); ++i) {
        to.base_color[static_cast<glm::length_t>(i)] = clamped(pbr.baseColorFactor[i], 0.0, 1.0);
    }
    to.metallic = clamped(pbr.metallicFactor, 0.0, 1.0);
    to.roughness = clamped(pbr.roughnessFactor, 0.0, 1.0);
    to.alpha_cutoff = clamped(from.alphaCutoff, 0.0, 1.0);
    to.alpha_mode = from.alphaMode == "MASK"    ? world::AlphaMode::Mask
                    : from.alphaMode == "BLEND" ? world::AlphaMode::Blend
                                                : world::AlphaMode::Opaque;
    to.is_double_sided = from.doubleSided;
    const double strength =
        number(extension(from.extensions, "KHR_materials_emissive_strength"), "emissiveStrength", 1.0);
    for (std::size_t i = 0; i < 3 && i < from.emissiveFactor.size(); ++i) {
        to.emission[static_cast<glm::length_t>(i)] =
            clamped(from.emissiveFactor[i] * strength, 0.0, kMostRadiance);
    }
}

void read_glass(const tinygltf::ExtensionMap& extensions, world::Material& to) {
    to.transmission = clamped(
        number(extension(extensions, "KHR_materials_transmission"), "transmissionFactor", 0.0), 0.0, 1.0);
    to.ior = clamped(number(extension(extensions, "KHR_materials_ior"), "ior", 1.5), 1.0, 5.0);
    to.specular =
        clamped(number(extension(extensions, "KHR_materials_specular"), "specularFactor", 1.0), 0.0, 1.0);
    const Value* volume = extension(extensions, "KHR_materials_volume");
    const Value* color = member(volume, "attenuationColor");
    for (int i = 0; i < 3; ++i) {
        to.attenuation_color[static_cast<glm::length_t>(i)] = clamped(element(color, i, 1.0), 0.0, 1.0);
    }
    const double distance = number(volume, "attenuationDistance", 0.0);
    if (distance > 0.0) to.attenuation_distance = clamped(distance, 1.0e-6, 1.0e9);
}

// uv' = offset + rotation(scale * uv); turning by an angle is counter-clockwise in glTF's v-down frame.
UvUse read_uv_use(const tinygltf::TextureInfo& info) {
    UvUse use;
    use.set = std::clamp(info.texCoord, 0, 7);
    const Value* transform = extension(info.extensions, "KHR_texture_transform");
    if (transform == nullptr) return use;
    constexpr double kMost = 1.0e6;
    const float angle = clamped(number(transform, "rotation", 0.0), -kMost, kMost);
    const Value* scale = member(transform, "scale");
    const Value* offset = member(transform, "offset");
    const glm::vec2 s{clamped(element(scale, 0, 1.0), -kMost, kMost),
                      clamped(element(scale, 1, 1.0), -kMost, kMost)};
    const det::SinCos turn = det::sin_cos(angle);
    use.uv_from_file[0] = glm::vec2(turn.cos, -turn.sin) * s.x;
    use.uv_from_file[1] = glm::vec2(turn.sin, turn.cos) * s.y;
    use.uv_from_file[2] = {clamped(element(offset, 0, 0.0), -kMost, kMost),
                           clamped(element(offset, 1, 0.0), -kMost, kMost)};
    use.set = static_cast<int>(std::clamp(number(transform, "texCoord", use.set), 0.0, 7.0));
    use.is_plain = use.uv_from_file == glm::mat3x2(1.0f);
    return use;
}

// A texture inside an extension; tinygltf reads only the core's.
tinygltf::TextureInfo texture_info(const Value* object, const char* key) {
    tinygltf::TextureInfo info;
    const Value* texture = member(object, key);
    if (texture == nullptr) return info;
    info.index = static_cast<int>(std::clamp(number(texture, "index", -1.0), -1.0, 1.0e9));
    info.texCoord = static_cast<int>(std::clamp(number(texture, "texCoord", 0.0), 0.0, 7.0));
    const Value* extensions = member(texture, "extensions");
    if (const Value* transform = member(extensions, "KHR_texture_transform"))
        info.extensions.emplace("KHR_texture_transform", *transform);
    return info;
}

// All textures of a material, one a slot.
using TextureInfos = std::array<tinygltf::TextureInfo, world::kTextureSlots>;

TextureInfos texture_infos(const tinygltf::Material& from) {
    const Value* specular = extension(from.extensions, "KHR_materials_specular");
    const Value* coat = extension(from.extensions, "KHR_materials_clearcoat");
    const Value* sheen = extension(from.extensions, "KHR_materials_sheen");
    const Value* anisotropy = extension(from.extensions, "KHR_materials_anisotropy");
    tinygltf::TextureInfo normal;
    normal.index = from.normalTexture.index;
    normal.texCoord = from.normalTexture.texCoord;
    normal.extensions = from.normalTexture.extensions;
    return {from.pbrMetallicRoughness.baseColorTexture,
            from.pbrMetallicRoughness.metallicRoughnessTexture,
            normal,
            from.emissiveTexture,
            texture_info(specular, "specularTexture"),
            texture_info(specular, "specularColorTexture"),
            texture_info(coat, "clearcoatTexture"),
            texture_info(coat, "clearcoatRoughnessTexture"),
            texture_info(sheen, "sheenColorTexture"),
            texture_info(sheen, "sheenRoughnessTexture"),
            texture_info(anisotropy, "anisotropyTexture")};
}

// All textures of a material share one set of uvs in the game, that of the first it has. Their transforms go into the
// mesh if they are all the same, and are the material's otherwise.
UvUse uv_use(const TextureInfos& infos, world::Material& material) {
    std::vector<glm::mat3x2> transforms(infos.size(), glm::mat3x2(1.0f));
    std::optional<UvUse> first;
    bool agree = true;
    for (std::size_t i = 0; i < infos.size(); ++i) {
        if (infos[i].index < 0) continue;
        const UvUse use = read_uv_use(infos[i]);
        transforms[i] = use.uv_from_file;
        if (!first) first = use;
        agree = agree && use.uv_from_file == first->uv_from_file;
    }
    if (!first) return {};
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
        &layers.anisotropy_texture};
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const Result<std::uint32_t> texture = textures.use(infos[i].index);
        if (!texture) return texture.error();
        *ids[i] = *texture;
    }
    return {};
}

glm::vec3 color(const Value* object, const char* key, double fallback, double most) {
    const Value* value = member(object, key);
    glm::vec3 result;
    for (int i = 0; i < 3; ++i)
        result[static_cast<glm::length_t>(i)] = clamped(element(value, i, fallback), 0.0, most);
    return result;
}

void read_layers(const tinygltf::ExtensionMap& extensions, world::Material& to) {
    world::Layers& layers = to.layers;
    const Value* specular = extension(extensions, "KHR_materials_specular");
    const Value* coat = extension(extensions, "KHR_materials_clearcoat");
    const Value* sheen = extension(extensions, "KHR_materials_sheen");
    const Value* anisotropy = extension(extensions, "KHR_materials_anisotropy");
    // More than 1 is allowed, since what comes of it is clamped again: f0 is at most 1.
    layers.specular_color = color(specular, "specularColorFactor", 1.0, 1.0e3);
    layers.coat = clamped(number(coat, "clearcoatFactor", 0.0), 0.0, 1.0);
    layers.coat_roughness = clamped(number(coat, "clearcoatRoughnessFactor", 0.0), 0.0, 1.0);
    layers.sheen_color = color(sheen, "sheenColorFactor", 0.0, 1.0);
    layers.sheen_roughness = clamped(number(sheen, "sheenRoughnessFactor", 0.0), 0.0, 1.0);
    layers.anisotropy = clamped(number(anisotropy, "anisotropyStrength", 0.0), 0.0, 1.0);
    layers.anisotropy_rotation = clamped(number(anisotropy, "anisotropyRotation", 0.0), -1.0e6, 1.0e6);
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

Result<world::Material> read_material(const tinygltf::Material& from, TextureSet& textures, UvUse& uvs) {
    world::Material material;
    material.name = from.name;
    read_factors(from, material);
    read_glass(from.extensions, material);
    read_layers(from.extensions, material);
    const TextureInfos infos = texture_infos(from);
    if (const Result<void> read = read_textures(infos, textures, material); !read) return read.error();
    material.normal_scale = clamped(from.normalTexture.scale, -100.0, 100.0);
    uvs = uv_use(infos, material);
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
        Result<world::Material> material = read_material(model.materials[i], textures, uvs);
        if (!material) {
            return Error{fmt::format("material {}: {}", name_or_number(model.materials[i].name, i),
                                     material.error().sentence)};
        }
        set.materials.push_back(std::move(*material));
        set.uvs.push_back(uvs);
    }
    set.materials.push_back(unpainted());
    set.uvs.emplace_back();
    return set;
}

}  // namespace gh::load

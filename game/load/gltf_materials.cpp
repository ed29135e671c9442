#include "load/gltf_materials.h"

#include "base/det_math.h"
#include "load/gltf_extras.h"
#include "load/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>

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

// All textures of a material share one set of uvs in the game: that of the first it has.
UvUse first_uv_use(const tinygltf::Material& material) {
    if (material.pbrMetallicRoughness.baseColorTexture.index >= 0) {
        return read_uv_use(material.pbrMetallicRoughness.baseColorTexture);
    }
    if (material.pbrMetallicRoughness.metallicRoughnessTexture.index >= 0) {
        return read_uv_use(material.pbrMetallicRoughness.metallicRoughnessTexture);
    }
    if (material.emissiveTexture.index >= 0) return read_uv_use(material.emissiveTexture);
    tinygltf::TextureInfo normal;
    normal.texCoord = material.normalTexture.texCoord;
    normal.extensions = material.normalTexture.extensions;
    return read_uv_use(normal);
}

Result<void> read_textures(const tinygltf::Material& from, TextureSet& textures, world::Material& to) {
    const struct {
        int gltf;
        std::uint32_t* id;
    } wanted[] = {{from.pbrMetallicRoughness.baseColorTexture.index, &to.base_color_texture},
                  {from.pbrMetallicRoughness.metallicRoughnessTexture.index, &to.metallic_roughness_texture},
                  {from.normalTexture.index, &to.normal_texture},
                  {from.emissiveTexture.index, &to.emission_texture}};
    for (const auto& [gltf, id] : wanted) {
        const Result<std::uint32_t> texture = textures.use(gltf);
        if (!texture) return texture.error();
        *id = *texture;
    }
    to.normal_scale = clamped(from.normalTexture.scale, -100.0, 100.0);
    return {};
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

Result<world::Material> read_material(const tinygltf::Material& from, TextureSet& textures) {
    world::Material material;
    material.name = from.name;
    read_factors(from, material);
    read_glass(from.extensions, material);
    if (const Result<void> read = read_textures(from, textures, material); !read) return read.error();
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
        Result<world::Material> material = read_material(model.materials[i], textures);
        if (!material) {
            return Error{fmt::format("material {}: {}", name_or_number(model.materials[i].name, i),
                                     material.error().sentence)};
        }
        set.materials.push_back(std::move(*material));
        set.uvs.push_back(first_uv_use(model.materials[i]));
    }
    set.materials.push_back(unpainted());
    set.uvs.emplace_back();
    return set;
}

}  // namespace gh::load

#include "load/gltf_textures.h"

#include "load/gltf_accessor.h"
#include "load/gltf_file.h"
#include "load/image_decode.h"
#include "load/limits.h"

#include <fmt/format.h>

namespace gh::load {
namespace {

world::Wrap to_wrap(int gltf_wrap) {
    switch (gltf_wrap) {
        case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
            return world::Wrap::Clamp;
        case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
            return world::Wrap::Mirror;
        default:
            return world::Wrap::Repeat;
    }
}

}  // namespace

Result<std::uint32_t> TextureSet::use(int gltf_texture, bool is_color) {
    if (gltf_texture == -1) return world::kNoIndex;
    const auto texture_id = static_cast<std::size_t>(gltf_texture);
    if (gltf_texture < 0 || texture_id >= model_.textures.size())
        return Error{fmt::format("texture {} does not exist", gltf_texture)};
    const tinygltf::Texture& texture = model_.textures[texture_id];
    if (texture.source < 0 || static_cast<std::size_t>(texture.source) >= model_.images.size()) {
        return Error{fmt::format("texture {} has no picture", texture_id)};
    }
    world::Wrap u = world::Wrap::Repeat, v = world::Wrap::Repeat;
    if (texture.sampler >= 0) {
        const auto sampler_id = static_cast<std::size_t>(texture.sampler);
        if (sampler_id >= model_.samplers.size())
            return Error{fmt::format("sampler {} does not exist", sampler_id)};
        u = to_wrap(model_.samplers[sampler_id].wrapS);
        v = to_wrap(model_.samplers[sampler_id].wrapT);
    }
    const auto key = std::make_tuple(texture.source, u, v, is_color);
    if (const auto known = known_.find(key); known != known_.end()) return known->second;

    Result<world::Texture> decoded = decode(static_cast<std::size_t>(texture.source));
    if (!decoded) return decoded.error();
    decoded->wrap_u = u;
    decoded->wrap_v = v;
    bytes_ += decoded->rgba.size();
    const auto id = static_cast<std::uint32_t>(textures_.size());
    textures_.push_back(std::move(*decoded));
    known_.emplace(key, id);
    return id;
}

Result<world::Texture> TextureSet::decode(std::size_t image_id) const {
    const tinygltf::Image& image = model_.images[image_id];
    const std::string name = image.name.empty() ? image.uri : image.name;
    const auto refuse = [&](const std::string& why) {
        return Error{fmt::format("image {} {}", name_or_number(name, image_id), why)};
    };
    std::span<const unsigned char> bytes = image.image;
    if (image.bufferView >= 0) {
        const Result<std::span<const unsigned char>> view = view_bytes(model_, image.bufferView);
        if (!view) return refuse("cannot be read: " + view.error().sentence);
        bytes = *view;
    }
    if (bytes.empty()) return refuse("is missing or empty");
    Result<Pixels> pixels = decode_image(bytes, kMaxTextureBytes - bytes_);
    if (!pixels) return refuse(pixels.error().sentence);
    world::Texture texture;
    texture.name = name;
    texture.width = pixels->width;
    texture.height = pixels->height;
    texture.rgba = std::move(pixels->rgba);
    return texture;
}

}  // namespace gh::load

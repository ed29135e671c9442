// load/gltf_textures.h - the textures that materials really use, each picture decoded once.
//
// Cost      decoding, about 100 ns a pixel for PNG; the same picture with two ways of wrapping is kept twice.
#pragma once

#include "base/result.h"
#include "world/level.h"

#include <tiny_gltf.h>

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace gh::load {

class TextureSet {
  public:
    explicit TextureSet(const tinygltf::Model& model) : model_(model) {}

    // The Level's texture for a glTF texture index; kNoIndex for -1. Of a picture used for colours here and for numbers
    // there, which are encoded otherwise, there are two.
    [[nodiscard]] Result<std::uint32_t> use(int gltf_texture, bool is_color);
    [[nodiscard]] std::vector<world::Texture> take() { return std::move(textures_); }

  private:
    [[nodiscard]] Result<world::Texture> decode(std::size_t image_id) const;

    const tinygltf::Model& model_;
    std::vector<world::Texture> textures_;
    // By picture, wrapping, and whether it holds colours.
    std::map<std::tuple<int, world::Wrap, world::Wrap, bool>, std::uint32_t> known_;
    std::size_t bytes_ = 0;
};

}  // namespace gh::load

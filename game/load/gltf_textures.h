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

    // The Level's texture for a glTF texture index; kNoIndex for -1.
    [[nodiscard]] Result<std::uint32_t> use(int gltf_texture);
    [[nodiscard]] std::vector<world::Texture> take() { return std::move(textures_); }

  private:
    [[nodiscard]] Result<world::Texture> decode(std::size_t image_id) const;

    const tinygltf::Model& model_;
    std::vector<world::Texture> textures_;
    std::map<std::tuple<int, world::Wrap, world::Wrap>, std::uint32_t> known_;  // picture and wrapping
    std::size_t bytes_ = 0;
};

}  // namespace gh::load

#include "render/texture_lookups.h"

#include "base/contracts.h"

#include <algorithm>

namespace gh::render {

void TextureLookUps::add(const MipTexture& texture, const TexturePlace& place, const MetCone& cone) {
    EXPECTS(count_ < kPatches);
    const std::size_t i = count_++;
    textures_[i] = &texture;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        patches_.direction[axis][i] = cone.direction[axis];
        patches_.normal[axis][i] = cone.normal[axis];
        patches_.u_gradient[axis][i] = place.gradients.u[axis];
        patches_.v_gradient[axis][i] = place.gradients.v[axis];
    }
    patches_.cone_width[i] = cone.width;
    const glm::vec2 size = texture.size();
    for (glm::length_t axis = 0; axis < 2; ++axis) {
        patches_.uv[axis][i] = place.uv[axis];
        patches_.size[axis][i] = size[axis];
    }
    patches_.last_level[i] = static_cast<float>(texture.level_count() - 1);
}

void TextureLookUps::work_out(float max_taps) {
    place_taps(patches_, count_, std::min(max_taps, static_cast<float>(kMostTaps)));
    std::array<TapQuery, kPatches> queries;
    for (std::size_t i = 0; i < count_; ++i) {
        const auto fine = static_cast<std::size_t>(patches_.level[i]);
        TapQuery& query = queries[i] = textures_[i]->query(fine);
        query.blend = patches_.level[i] - static_cast<float>(fine);
        query.taps = static_cast<int>(patches_.taps[i]);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            query.uv[axis] = patches_.first[axis][i];
            query.step[axis] = patches_.step[axis][i];
        }
    }
    average_taps(queries.data(), count_, &values_[0].x);
}

}  // namespace gh::render

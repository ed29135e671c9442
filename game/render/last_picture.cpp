#include "render/last_picture.h"

#include "base/contracts.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

// Of the way from the eye: how far a surface leaves its own plane within a pixel. A thing behind another lies farther off.
constexpr float kOffPlane = 0.02f;

}  // namespace

LastPicture::LastPicture(const Image& radiance, const GuidePlanes& guide, glm::ivec2 size)
    : radiance_(radiance),
      guide_(guide),
      size_(size),
      per_pixel_(glm::vec2(radiance.width, radiance.height) / glm::vec2(size)),
      picture_from_world_(glm::inverse(glm::mat3(guide.right, guide.down, guide.corner))) {
    EXPECTS(size.x >= 1 && size.y >= 1 && radiance.width >= size.x && radiance.height >= size.y);
    EXPECTS(guide.part.size() == static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
}

std::optional<glm::vec3> LastPicture::seen(const glm::vec3& position, std::uint32_t part) const {
    const glm::vec3 from_eye = position - guide_.eye;
    const glm::vec3 there = picture_from_world_ * from_eye;
    const glm::vec2 point = glm::vec2(there) / there.z;
    // Written so that NaN is out of sight.
    if (!(there.z > 0.0f && point.x >= 0.0f && point.y >= 0.0f && point.x < static_cast<float>(size_.x) &&
          point.y < static_cast<float>(size_.y)))
        return std::nullopt;
    const auto pixel = static_cast<std::size_t>(point.y) * static_cast<std::size_t>(size_.x) +
                       static_cast<std::size_t>(point.x);
    if ((guide_.part[pixel] & ~GuidePlanes::kUnmirrored) != part) return std::nullopt;
    const float off = glm::dot(guide_.position[pixel] - position, guide_.geometric[pixel]);
    if (!(std::abs(off) <= kOffPlane * glm::length(from_eye))) return std::nullopt;
    return radiance_at(point * per_pixel_);
}

glm::vec3 LastPicture::radiance_at(const glm::vec2& point) const {
    const glm::vec2 most(radiance_.width - 1, radiance_.height - 1);
    const glm::vec2 from_first = glm::clamp(point - 0.5f, glm::vec2(0.0f), most);
    const int x = std::min(static_cast<int>(from_first.x), std::max(radiance_.width - 2, 0));
    const int y = std::min(static_cast<int>(from_first.y), std::max(radiance_.height - 2, 0));
    const glm::vec2 share = from_first - glm::vec2(x, y);
    const glm::vec3* const above = &radiance_.pixels[radiance_.index(x, y)];
    const glm::vec3* const below = y + 1 < radiance_.height ? above + radiance_.width : above;
    const int right = x + 1 < radiance_.width ? 1 : 0;
    return glm::mix(glm::mix(above[0], above[right], share.x), glm::mix(below[0], below[right], share.x),
                    share.y);
}

}  // namespace gh::render

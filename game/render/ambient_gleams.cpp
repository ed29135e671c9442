#include "render/ambient_gleams.h"

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kKeptOff = 1.2f;  // radii from a gleam: nearer to it every direction finds it by itself

}  // namespace

AimedAtAll gleams_around(const SceneView& view, const glm::vec3& eye) {
    AimedAtAll found;
    for (const SeenGleam& seen : view.prepared.gleams.at(eye)) {
        const Gleam& gleam = view.prepared.gleams.gleams[seen.gleam];
        const std::uint32_t lamp =
            gleam.lamp != world::kNoIndex ? gleam.lamp : view.prepared.parts[gleam.part].lamp;
        const glm::vec3 way = gleam.ball.centre - eye;
        const float distance2 = glm::dot(way, way), radius2 = gleam.ball.radius * gleam.ball.radius;
        if (lamp == world::kNoIndex || !(distance2 > kKeptOff * kKeptOff * radius2)) continue;
        const float sin2 = radius2 / distance2;
        found.gleam[found.count++] = {gleam.ball, lamp, way / std::sqrt(distance2),
                                      sin2 / (1.0f + std::sqrt(1.0f - sin2))};
    }
    return found;
}

bool is_left_out(std::span<const AimedAt> gleams, std::uint32_t lamp, const glm::vec3& position) {
    return std::any_of(gleams.begin(), gleams.end(),
                       [&](const AimedAt& g) { return g.lamp == lamp && g.holds(position); });
}
bool is_within_any(std::span<const AimedAt> gleams, const glm::vec3& position) {
    return std::any_of(gleams.begin(), gleams.end(), [&](const AimedAt& g) { return g.holds(position); });
}

}  // namespace gh::render

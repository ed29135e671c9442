#include "app/reshading.h"

#include "base/contracts.h"

#include <glm/geometric.hpp>

namespace gh::app {

namespace {

constexpr int kSide = 3;             // pixels of a block that one sample speaks for
constexpr float kSamePlace = 1e-3f;  // of the distance

float luminance(const glm::vec3& c) {
    return (0.2126f * c.x + 0.7152f * c.y) + 0.0722f * c.z;
}

// Calls work(x, y) for every pixel that is asked again.
template <class Work>
void for_all_asked(const Image& picture, const glm::ivec2& first, const Work& work) {
    for (int y = first.y; y < picture.height; y += kSide) {
        for (int x = first.x; x < picture.width; x += kSide) work(x, y);
    }
}

void fit_blocks(const Image& picture, filter::Plane& plane) {
    plane.resize((picture.width + kSide - 1) / kSide, (picture.height + kSide - 1) / kSide);
}

}  // namespace

// Whether a path met again what it had met.
bool Reshading::is_at(const Seen& seen, std::uint32_t part, const glm::vec3& position) const {
    if (part != seen.part) return false;
    if (part == render::FilmPlanes::kSky) return true;
    return glm::distance(position, seen.position) <= kSamePlace * glm::distance(position, camera_.position);
}

void Reshading::note(const render::Camera& camera, const render::PathSettings& settings, std::uint32_t frame,
                     const render::Film& film) {
    EXPECTS(settings.every == 1 && settings.fills_planes);
    camera_ = camera;
    settings_ = settings;
    settings_.every = kSide;
    // Another pixel of each block in every frame, in an order that leaves no streaks.
    constexpr int kOrder[9] = {4, 0, 8, 2, 6, 5, 1, 7, 3};
    const int pixel = kOrder[frame % 9];
    settings_.first = {pixel % kSide, pixel / kSide};
    frame_ = frame;
    if (again_.radiance.width != film.radiance.width || again_.radiance.height != film.radiance.height)
        again_.radiance = Image(film.radiance.width, film.radiance.height);
    fit_blocks(film.radiance, samples_.then);
    seen_.clear();
    for_all_asked(film.radiance, settings_.first, [&](int x, int y) {
        samples_.then.at(x / kSide, y / kSide) = luminance(film.radiance.at(x, y));
        seen_.push_back({film.planes.part.at(x, y), film.planes.position.get(x, y)});
    });
    is_known_ = true;
}

void Reshading::ask_again(const render::SceneView& scene, const Jobs& jobs, filter::Plane& change) {
    change = {};
    if (!is_known_) return;
    render::SceneView now = scene;
    now.before = nullptr;
    render::render_path(now, camera_, settings_, frame_, jobs, again_);
    fit_blocks(again_.radiance, samples_.now);
    auto seen = seen_.begin();
    for_all_asked(again_.radiance, settings_.first, [&](int x, int y) {
        const bool is_same = is_at(*seen++, again_.planes.part.at(x, y), again_.planes.position.get(x, y));
        float& before = samples_.then.at(x / kSide, y / kSide);
        if (!is_same) before = 0.0f;
        samples_.now.at(x / kSide, y / kSide) = is_same ? luminance(again_.radiance.at(x, y)) : 0.0f;
    });
    samples_.side = kSide;
    filter::gradients(samples_, again_.radiance.width, again_.radiance.height, jobs, change);
}

}  // namespace gh::app

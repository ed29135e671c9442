#include "app/reshading.h"

#include "base/contracts.h"

namespace gh::app {

namespace {

constexpr int kSide = 3;  // pixels of a block that one sample speaks for

float luminance(const glm::vec3& c) {
    return (0.2126f * c.x + 0.7152f * c.y) + 0.0722f * c.z;
}

void gather(const Image& picture, const glm::ivec2& first, filter::Plane& luminances) {
    luminances.resize((picture.width + kSide - 1) / kSide, (picture.height + kSide - 1) / kSide);
    for (int y = first.y; y < picture.height; y += kSide) {
        for (int x = first.x; x < picture.width; x += kSide)
            luminances.at(x / kSide, y / kSide) = luminance(picture.at(x, y));
    }
}

}  // namespace

void Reshading::note(const render::Camera& camera, const render::PathSettings& settings, std::uint32_t frame,
                     const render::Film& film) {
    EXPECTS(settings.every == 1);
    camera_ = camera;
    settings_ = settings;
    settings_.fills_planes = false;
    settings_.every = kSide;
    // Another pixel of each block in every frame, in an order that leaves no streaks.
    constexpr int kOrder[9] = {4, 0, 8, 2, 6, 5, 1, 7, 3};
    const int pixel = kOrder[frame % 9];
    settings_.first = {pixel % kSide, pixel / kSide};
    frame_ = frame;
    if (again_.radiance.width != film.radiance.width || again_.radiance.height != film.radiance.height)
        again_.radiance = Image(film.radiance.width, film.radiance.height);
    gather(film.radiance, settings_.first, samples_.then);
    is_known_ = true;
}

void Reshading::ask_again(const render::SceneView& scene, const Jobs& jobs, filter::Plane& change) {
    change = {};
    if (!is_known_) return;
    render::SceneView now = scene;
    now.before = nullptr;
    render::render_path(now, camera_, settings_, frame_, jobs, again_);
    gather(again_.radiance, settings_.first, samples_.now);
    samples_.side = kSide;
    filter::gradients(samples_, again_.radiance.width, again_.radiance.height, jobs, change);
}

}  // namespace gh::app

#include "app/plane_view.h"

#include "base/contracts.h"
#include "filter/tone_map.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace gh::app {

namespace {

constexpr float kNear = 4.0f;          // metres at which depth is half as bright
constexpr float kMostMotion = 8.0f;    // pixels a frame, of full colour
constexpr float kMostHistory = 32.0f;  // frames
constexpr float kMostRays = 16.0f;     // a pixel

// What is little is blue, then red, yellow, white: 0 ... 1.
glm::vec3 heat(float share) {
    static constexpr std::array<glm::vec3, 5> kColors = {
        glm::vec3(0.0f, 0.0f, 0.05f), glm::vec3(0.1f, 0.15f, 0.8f), glm::vec3(0.85f, 0.1f, 0.15f),
        glm::vec3(1.0f, 0.85f, 0.1f), glm::vec3(1.0f)};
    const float at = std::clamp(share, 0.0f, 1.0f) * static_cast<float>(kColors.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), kColors.size() - 2);
    return glm::mix(kColors[low], kColors[low + 1], at - static_cast<float>(low));
}

// Of a point in the picture that a lens takes, in pixels.
glm::vec2 seen_at(const glm::mat3& picture_from_world, const glm::vec3& eye, const glm::vec3& p) {
    const glm::vec3 at = picture_from_world * (p - eye);
    return glm::vec2(at) / at.z;
}

struct Lenses {
    glm::mat3 now, before;  // picture from world
};

Lenses lenses_of(const SeenPlanes& seen) {
    const render::FilmPlanes& film = seen.film;
    return {glm::inverse(glm::mat3(film.right, film.down, film.corner)),
            glm::inverse(glm::mat3(seen.before.right, seen.before.down, seen.before.corner))};
}

glm::vec3 motion_color(const SeenPlanes& seen, const Lenses& lenses, int x, int y) {
    const glm::vec2 now = seen_at(lenses.now, seen.film.eye, seen.film.position.get(x, y));
    const glm::vec2 then = seen_at(lenses.before, seen.before.eye, seen.film.previous.get(x, y));
    const glm::vec2 moved = (now - then) / kMostMotion;
    return {0.5f + 0.5f * moved.x, 0.5f + 0.5f * moved.y, 0.5f};
}

// In what a screen takes, [0, 1]; what is not a number is black there.
glm::vec3 color_at(PlaneView view, const SeenPlanes& seen, const Lenses& lenses, float exposure, int x,
                   int y) {
    const render::FilmPlanes& film = seen.film;
    if (view == PlaneView::Rays) return heat(film.rays.at(x, y) / kMostRays);
    if (film.part.at(x, y) == render::FilmPlanes::kSky) return glm::vec3(0.0f);
    switch (view) {
        case PlaneView::Albedo: {
            const glm::vec3 albedo = glm::clamp(film.albedo.get(x, y), 0.0f, 1.0f);
            return {filter::srgb_from_linear(albedo.x), filter::srgb_from_linear(albedo.y),
                    filter::srgb_from_linear(albedo.z)};
        }
        case PlaneView::Normal:
            return film.normal.get(x, y) * 0.5f + 0.5f;
        case PlaneView::Depth:
            return glm::vec3(kNear / (kNear + glm::distance(film.eye, film.position.get(x, y))));
        case PlaneView::Motion:
            return motion_color(seen, lenses, x, y);
        case PlaneView::Variance:
            return heat(std::sqrt(std::max(0.0f, seen.variance.at(x, y))) * exposure);
        case PlaneView::History:
            return heat(seen.history.at(x, y) / kMostHistory);
        default:
            return glm::vec3(0.0f);
    }
}

std::uint8_t byte_of(float value) {
    if (!(value > 0.0f)) return 0;
    const float half_up = std::min(value, 1.0f) * 255.0f + 0.5f;
    return static_cast<std::uint8_t>(half_up);
}

void paint_light(const Plane3& light, float exposure, const Jobs& jobs, Image8& out) {
    Image image;
    filter::image_from(light, image);
    filter::tone_map(image, exposure, 0, jobs, out);
}

}  // namespace

PlaneView next_of(PlaneView view) {
    return static_cast<PlaneView>((static_cast<int>(view) + 1) % kPlaneViews);
}

const char* words_of(PlaneView view) {
    static constexpr std::array<const char*, kPlaneViews> kWords = {
        "the picture",
        "albedo: the colour light is multiplied by",
        "normals: red right, green up, blue towards south",
        "depth: the nearer the brighter, grey at 4 m",
        "motion since the last frame: grey still, red right, green down, full at 8 pixels",
        "direct light, one sample a pixel",
        "indirect light, one sample a pixel",
        "light off gloss, one sample a pixel",
        "deviation of the direct light's mean: blue little, white as much as white",
        "frames remembered: blue few, white 32",
        "rays a pixel: blue few, white 16"};
    return kWords[static_cast<std::size_t>(view)];
}

void paint_plane(PlaneView view, const SeenPlanes& seen, float exposure, const Jobs& jobs, Image8& out) {
    const render::FilmPlanes& film = seen.film;
    EXPECTS(view != PlaneView::Picture && !film.part.empty());
    if (view == PlaneView::Direct) return paint_light(film.direct, exposure, jobs, out);
    if (view == PlaneView::Indirect) return paint_light(film.indirect, exposure, jobs, out);
    if (view == PlaneView::Specular) return paint_light(film.specular, exposure, jobs, out);
    const int width = film.part.width(), height = film.part.height();
    if (out.width != width || out.height != height || out.channels != 3) out = Image8(width, height);
    const Lenses lenses = lenses_of(seen);
    jobs.run(static_cast<std::size_t>(height), [&](std::size_t row, int) {
        for (int x = 0; x < width; ++x) {
            const glm::vec3 color = color_at(view, seen, lenses, exposure, x, static_cast<int>(row));
            std::uint8_t* const bytes = out.at(x, static_cast<int>(row));
            for (glm::length_t c = 0; c < 3; ++c) bytes[c] = byte_of(color[c]);
        }
    });
}

}  // namespace gh::app

// The part of a tile that tells filters what each pixel shows: the first surface that scatters, seen through mirrors and
// clear glass as if it lay straight ahead.
#include "render/path_tile.h"
#include "render/sane.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <bit>
#include <cmath>

namespace gh::render {

namespace {

// What stands still may be one part, and yet brass beside plaster: filters have to keep them apart.
std::uint32_t thing_at(const world::Level& level, const ShadingPoint& at) {
    const auto material = static_cast<std::uint32_t>(at.material - level.materials.data());
    return std::rotl(material, 20) ^ at.part;
}

// Two places in a pixel lie on one face, be it round, if their normals are no further apart than that cosine, and one lies
// no further off the other's plane than that share of the way.
constexpr float kOneFace = 0.9f, kOnPlane = 0.01f;

}  // namespace

template <unsigned kFeatures>
void PathTile<kFeatures>::begin_planes() {
    if (!kHasPlanes || !frame_.settings.fills_planes) return;
    unfolding_.assign(static_cast<std::size_t>(columns_ * rows_), {});
    beside_.assign(static_cast<std::size_t>(columns_ * rows_), {});
}

template <unsigned kFeatures>
void PathTile<kFeatures>::note_ray(std::uint16_t pixel) {
    if (!kHasPlanes || !frame_.settings.fills_planes) return;
    const glm::ivec2 at = film_pixel(pixel);
    film_->planes.rays.at(at.x, at.y) += 1.0f;
}

// Something in the way of the eye that turns it.
template <unsigned kFeatures>
void PathTile<kFeatures>::note_mirror(const Path& path, const ShadingPoint& at, bool passes) {
    Unfolding& unfolding = unfolding_[path.pixel];
    unfolding.length += glm::distance(path.ray.origin, at.surface.position);
    if (passes) return;
    const glm::vec3& n = at.normal;
    unfolding.turned = unfolding.turned * (glm::mat3(1.0f) - 2.0f * glm::outerProduct(n, n));
}

template <unsigned kFeatures>
glm::vec3 PathTile<kFeatures>::position_before(const ShadingPoint& at, const rc::Hit& hit) const {
    if (frame_.view.before == nullptr) return at.surface.position;
    const rc::Scene& scene = *frame_.view.before->scene;
    if (hit.instance >= scene.instance_count()) return at.surface.position;
    const std::array<glm::vec3, 3> corner = scene.triangle(hit.instance, hit.primitive);
    const glm::vec3 local = corner[0] + (corner[1] - corner[0]) * hit.u + (corner[2] - corner[0]) * hit.v;
    return scene.instance(hit.instance).world_from_instance * glm::vec4(local, 1.0f);
}

template <unsigned kFeatures>
void PathTile<kFeatures>::note_surface(const Path& path, const ShadingPoint& at, const rc::Hit& hit,
                                       const Bsdf& bsdf) {
    if (!fills_planes(path)) return;
    Unfolding& unfolding = unfolding_[path.pixel];
    if (unfolding.shown > 0) return;
    unfolding.shown = 1;
    unfolding.position = at.surface.position;
    unfolding.geometric = at.geometric;
    FilmPlanes& planes = film_->planes;
    const glm::ivec2 i = film_pixel(path.pixel);
    glm::vec3 position = at.surface.position;
    if (path.depth + path.passes > 0) {
        const glm::vec3 way = frame_.lens.ray(picture_point(path)).direction;
        const float length = unfolding.length + glm::distance(path.ray.origin, at.surface.position);
        position = frame_.lens.position() + way * length;
    }
    planes.part.at(i.x, i.y) = thing_at(frame_.view.level, at);
    planes.position.set(i.x, i.y, position);
    planes.previous.set(i.x, i.y,
                        position + unfolding.turned * (position_before(at, hit) - at.surface.position));
    planes.normal.set(i.x, i.y, unfolding.turned * at.smooth);
    planes.geometric.set(i.x, i.y, unfolding.turned * at.geometric);
    planes.albedo.set(i.x, i.y, bsdf.diffuse_albedo());
    planes.gloss.set(i.x, i.y, bsdf.gloss_albedo());
    planes.roughness.at(i.x, i.y) = sane(at.roughness, 0.0f, 1.0f);
}

// Whether a further sample shows another thing than the planes tell of, or another face of it. Light of the inside of a
// shade, a thousand times that of the wall beside it, is none of the wall's: filters would spread it all over.
template <unsigned kFeatures>
bool PathTile<kFeatures>::shows_another(const Path& path, const ShadingPoint& at, const Bsdf& bsdf) {
    if (!frame_.settings.fills_planes || path.sample == 0 || !path.is_leading) return false;
    Unfolding& unfolding = unfolding_[path.pixel];
    FilmPlanes& planes = film_->planes;
    const glm::ivec2 i = film_pixel(path.pixel);
    if (unfolding.shown == 0 || planes.part.at(i.x, i.y) != thing_at(frame_.view.level, at)) return true;
    const float step = glm::dot(at.surface.position - unfolding.position, unfolding.geometric);
    if (!(glm::dot(at.geometric, unfolding.geometric) > kOneFace) ||
        !(std::abs(step) < kOnPlane * glm::distance(path.ray.origin, at.surface.position)))
        return true;
    ++unfolding.shown;
    planes.albedo.set(i.x, i.y, planes.albedo.get(i.x, i.y) + bsdf.diffuse_albedo());
    planes.gloss.set(i.x, i.y, planes.gloss.get(i.x, i.y) + bsdf.gloss_albedo());
    return false;
}

// How far off the thing is that the main surface mirrors.
template <unsigned kFeatures>
void PathTile<kFeatures>::note_reflection(const Path& path, float t) {
    if (!fills_planes(path) || !path.is_first_leg || path.channel != Channel::Specular) return;
    const glm::ivec2 at = film_pixel(path.pixel);
    film_->planes.reflected.at(at.x, at.y) = t;
}

// What of the pixel's light is not that of the surface the planes tell of passes unfiltered. Where that surface fills a
// share of the pixel only, its colours are that share's: light is what falls on it, as on its neighbours.
template <unsigned kFeatures>
void PathTile<kFeatures>::note_light(std::uint16_t pixel, std::uint32_t samples) {
    const auto& light = sums_[pixel].light;
    const auto& beside = beside_[pixel].light;
    glm::dvec3 clean = light[static_cast<std::size_t>(Channel::Clean)];
    const auto own = [&](Channel which) {
        const auto i = static_cast<std::size_t>(which);
        clean += beside[i];
        return light[i] - beside[i];
    };
    const glm::dvec3 direct = own(Channel::Direct), indirect = own(Channel::Indirect);
    glm::dvec3 specular = own(Channel::Specular);
    const double share = static_cast<double>(unfolding_[pixel].shown) / static_cast<double>(samples);
    const glm::dvec3& mirrored = light[static_cast<std::size_t>(Channel::Mirrored)];
    specular += mirrored * share;
    clean += mirrored * (1.0 - share);
    const glm::ivec2 at = film_pixel(pixel);
    const auto mean = [&](const glm::dvec3& sum) { return glm::vec3(sum / static_cast<double>(samples)); };
    FilmPlanes& planes = film_->planes;
    const auto share_out = [&](Plane3& colour) {
        colour.set(at.x, at.y, colour.get(at.x, at.y) / static_cast<float>(samples));
    };
    planes.direct.set(at.x, at.y, mean(direct));
    planes.indirect.set(at.x, at.y, mean(indirect));
    planes.specular.set(at.x, at.y, mean(specular));
    planes.clean.set(at.x, at.y, mean(clean));
    share_out(planes.albedo);
    share_out(planes.gloss);
}

}  // namespace gh::render

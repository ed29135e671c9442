// render/film.h - what a renderer fills: the picture, what it took, and, if asked to, what filters need to know.
#pragma once

#include "base/image.h"
#include "base/plane.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace gh::render {

// Rays asked for by purpose, for the profiler. Summed over tiles in index order: the same for any thread count.
struct KeptLightTree;

struct FrameStats {
    std::uint64_t primary_rays = 0;    // from the eye
    std::uint64_t reflected_rays = 0;  // off mirrors, polished floors, glass
    std::uint64_t refracted_rays = 0;  // into or through glass and past transparent texels
    std::uint64_t shadow_rays = 0;     // to lamps
    std::uint64_t glass_shadow_rays =
        0;                           // the same once more, where glass or cut-out leaves may stand in between
    std::uint64_t ambient_rays = 0;  // short ones that find corners
    std::uint64_t lit_pixels = 0;    // no rays: pixels whose light was worked out, not blended from others'

    [[nodiscard]] std::uint64_t total() const {
        return primary_rays + reflected_rays + refracted_rays + shadow_rays + glass_shadow_rays +
               ambient_rays;
    }
    FrameStats& operator+=(const FrameStats& other);
};

// The surface that each pixel shows and its light by how it behaves, for filters that follow it from frame to frame. Every
// plane means what the plane of that name in filter/gbuffer.h means: mirrors and clear glass are looked through, unfolded:
// what is seen there lies on the straight line through the pixel, at the whole length of the way. Where several samples of a
// pixel show several things, planes tell of the first one's, and albedo and gloss are of its share of the pixel, so that
// light by albedo is what falls on it; light on the others is in `clean`.
struct FilmPlanes {
    static constexpr std::uint32_t kSky = 0xFFFFFFFFu;

    glm::vec3 eye{0.0f}, corner{0.0f}, right{0.0f}, down{0.0f};  // of the lens
    // kSky: no surface. The same thing has the same number in every frame; another image of it may have another.
    PlaneU32 part;
    Plane3 position, previous;
    Plane3 geometric, normal;  // towards the eye
    Plane3 albedo, gloss;
    Plane roughness, reflected;
    Plane rays;                                // traced for the pixel, shadow rays among them
    Plane3 direct, indirect, specular, clean;  // they sum to the picture

    // The surfaces become sky; light of a picture of the same size stays what it was.
    void resize(int width, int height);
};

// What a guide (guide.h) says of each pixel, row by row: the same as the film's planes of these names.
struct GuidePlanes {
    static constexpr std::uint32_t kSky = FilmPlanes::kSky;
    // In a part's number: it is polished, and what it mirrors was out of sight (guide_gleams.h).
    static constexpr std::uint32_t kUnmirrored = 0x40000000u;

    glm::vec3 eye{0.0f}, corner{0.0f}, right{0.0f}, down{0.0f};
    std::vector<std::uint32_t> part;
    std::vector<glm::vec3> position, previous, geometric, albedo;
    Image clean;
    std::vector<std::uint8_t> outshone;  // 1: a lamp's highlight is in `clean`, or would be if nothing were before it
};

struct Film {
    Image radiance;  // linear, scene-referred; its size is the picture's size
    FrameStats stats;
    FilmPlanes planes;  // empty unless asked for
    // What the path tracer found out about lamps for the last picture, to be used again while none changes; never part
    // of an answer.
    std::shared_ptr<const KeptLightTree> light_tree;

    Film() = default;
    Film(int width, int height) : radiance(width, height) {}
};

}  // namespace gh::render

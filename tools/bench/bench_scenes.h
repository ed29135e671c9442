// bench_scenes.h - what benchmarks look at: generated scenes, or a file's triangles made one mesh.
//
// The generated ones are the same floats on every run (bench_generated.cpp): metres, +y up, seeds fixed.
#pragma once

#include "raycore/mesh.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace gh::world {
struct Level;
}

namespace bench {

struct Camera {
    glm::vec3 position{0.0f};
    float yaw = 0.0f;    // radians; 0 looks along -z, positive turns left
    float pitch = 0.0f;  // radians, positive up
    float fov = 1.2f;    // vertical, radians
};

struct BenchScene {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    Camera camera;
    glm::vec3 lamp_low{0.0f}, lamp_high{0.0f};  // shadow rays end in this box

    [[nodiscard]] rc::MeshView view() const { return {positions, triangles}; }
};

// A hall with fluted columns, statues, coffers and panelling: 226 k triangles, most of them long and thin.
[[nodiscard]] BenchScene make_interior();

// Hills strewn with boulders, seen from eye height: a million triangles of much the same size.
[[nodiscard]] BenchScene make_landscape();

// "Teapot in a stadium": a million triangles a fraction of a millimetre wide on a plinth between few tens of metres wide.
[[nodiscard]] BenchScene make_stadium();

// A level's parts as one mesh, as they stand before the first tick; aimed by its first camera if it has one.
[[nodiscard]] BenchScene flatten(const gh::world::Level& level);

// Nothing when the file can not be read; the sentence is on stderr.
[[nodiscard]] std::optional<BenchScene> read_scene(const std::string& path);

}  // namespace bench

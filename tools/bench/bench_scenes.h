// bench_scenes.h - what benchmarks look at: a procedural interior, or a file's triangles made one mesh.
#pragma once

#include "raycore/mesh.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

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

// A hall with fluted columns, statues, coffers and panelling: 270 k triangles, many of them long and thin.
[[nodiscard]] BenchScene make_interior();

// Nothing when the file can not be read; the sentence is on stderr.
[[nodiscard]] std::optional<BenchScene> read_scene(const std::string& path);

}  // namespace bench

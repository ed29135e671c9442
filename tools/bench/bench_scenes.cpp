#include "bench_scenes.h"

#include "load/level_loader.h"
#include "spatial/transforms.h"
#include "world/initial_state.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

namespace bench {

namespace {

void aim(BenchScene& scene) {
    glm::vec3 low(1e30f), high(-1e30f);
    for (const glm::vec3& p : scene.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::vec3 size = high - low;
    scene.camera.position = low + size * glm::vec3(0.5f, 0.45f, 0.75f);
    scene.lamp_low = low + size * glm::vec3(0.3f, 0.7f, 0.3f);
    scene.lamp_high = low + size * glm::vec3(0.7f, 0.9f, 0.7f);
}

}  // namespace

BenchScene flatten(const gh::world::Level& level) {
    BenchScene scene;
    scene.name = level.name;
    const gh::world::State state = gh::world::initial_state(level, 1);
    for (std::size_t i = 0; i < level.parts.size(); ++i) {
        if (gh::spatial::layers_of_part(level, state, i) == 0) continue;
        const gh::world::Mesh& mesh = level.meshes[level.parts[i].mesh];
        const glm::mat4x3 world_from_part = gh::spatial::world_from_part(level, state, i);
        const auto base = static_cast<std::uint32_t>(scene.positions.size());
        for (const glm::vec3& p : mesh.positions)
            scene.positions.push_back(gh::spatial::point_through(world_from_part, p));
        for (const glm::uvec3& t : mesh.triangles) scene.triangles.push_back(t + glm::uvec3(base));
    }
    aim(scene);
    if (!level.viewpoints.empty()) {
        const gh::world::Viewpoint& v = level.viewpoints.front();
        scene.camera = {v.position, v.yaw, v.pitch, v.fov_y};
    }
    return scene;
}

namespace {

// Vertex count, triangle count, positions, indices: what a script can write in two lines.
std::optional<BenchScene> read_raw(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::uint32_t counts[2] = {};
    file.read(reinterpret_cast<char*>(counts), sizeof(counts));
    BenchScene scene;
    scene.name = path;
    if (!file || counts[0] > 1u << 28 || counts[1] > 1u << 28) return std::nullopt;
    scene.positions.resize(counts[0]);
    scene.triangles.resize(counts[1]);
    file.read(reinterpret_cast<char*>(scene.positions.data()),
              std::streamsize(counts[0] * sizeof(glm::vec3)));
    file.read(reinterpret_cast<char*>(scene.triangles.data()),
              std::streamsize(counts[1] * sizeof(glm::uvec3)));
    if (!file) return std::nullopt;
    aim(scene);
    return scene;
}

}  // namespace

std::optional<BenchScene> read_scene(const std::string& path) {
    if (path.ends_with(".raw")) {
        std::optional<BenchScene> scene = read_raw(path);
        if (!scene) std::fprintf(stderr, "%s: not a raw mesh\n", path.c_str());
        return scene;
    }
    const gh::Result<gh::world::Level> level = gh::load::load_level(path, {.finds_ways = false});
    if (!level) {
        std::fprintf(stderr, "%s\n", level.error().sentence.c_str());
        return std::nullopt;
    }
    return flatten(*level);
}

}  // namespace bench

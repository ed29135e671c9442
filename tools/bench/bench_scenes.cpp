#include "bench_scenes.h"

#include "load/level_loader.h"
#include "support/shapes.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

namespace bench {

namespace {

constexpr float kTau = 6.2831853f;

// A fluted shaft: quads as tall as the column and a few millimetres wide, the worst that architecture has.
test::Mesh make_column(const glm::vec3& foot, float height, float radius, std::uint32_t flutes,
                       std::uint32_t rings) {
    test::Mesh mesh;
    const std::uint32_t around = 8 * flutes;
    for (std::uint32_t j = 0; j <= rings; ++j) {
        for (std::uint32_t i = 0; i < around; ++i) {
            const float angle = kTau * float(i) / float(around);
            const float r = radius * (1.0f - 0.06f * std::abs(std::sin(0.5f * float(flutes) * angle)));
            mesh.positions.push_back(
                foot + glm::vec3(r * std::cos(angle), height * float(j) / float(rings), r * std::sin(angle)));
        }
    }
    for (std::uint32_t j = 0; j < rings; ++j) {
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t a = j * around + i, b = j * around + (i + 1) % around;
            mesh.triangles.emplace_back(a, a + around, b);
            mesh.triangles.emplace_back(b, a + around, b + around);
        }
    }
    return mesh;
}

}  // namespace

BenchScene make_interior() {
    test::Random random(2026);
    test::Mesh all = test::make_box({-12, 0, -30}, {12, 8, 30});
    for (int side = -1; side <= 1; side += 2) {
        for (int i = 0; i < 14; ++i) {
            const glm::vec3 foot(float(side) * 7.0f, 0, -27.0f + 4.1f * float(i));
            test::append(all, make_column(foot, 7.4f, 0.45f, 20, 2));
            test::append(
                all, test::make_box(foot - glm::vec3(0.6f, 0, 0.6f), foot + glm::vec3(0.6f, 0.25f, 0.6f)));
            const glm::vec3 plinth(float(side) * 9.8f, 0, foot.z + 2.0f);
            test::append(
                all, test::make_box(plinth - glm::vec3(0.4f, 0, 0.4f), plinth + glm::vec3(0.4f, 1.1f, 0.4f)));
            test::append(all, test::make_ball(plinth + glm::vec3(0, 1.7f, 0), 0.6f, 30));
        }
    }
    for (int i = 0; i < 260; ++i) {  // coffers, skirting, benches: boxes, most of them thin slats
        const glm::vec3 at(random.between(-11, 11), random.below(2) ? 7.6f : random.between(0, 0.5f),
                           random.between(-29, 29));
        const bool along_x = random.below(2) == 0;
        const glm::vec3 half = along_x ? glm::vec3(random.between(0.5f, 4), 0.03f, 0.03f)
                                       : glm::vec3(0.03f, 0.03f, random.between(0.5f, 4));
        test::append(all, test::make_box(at - half, at + half));
    }
    test::append(all, test::make_sheet(11.5f, 0.01f, 40));
    return {"interior",
            std::move(all.positions),
            std::move(all.triangles),
            {{0.5f, 1.7f, 26.0f}, 0.15f, 0.03f, 1.2f},
            {-6, 6.5f, -28},
            {6, 7.5f, 28}};
}

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

// All that stands still, and what moves where it rests, as one mesh.
BenchScene flatten(const gh::world::Level& level) {
    BenchScene scene;
    scene.name = level.name;
    for (const gh::world::Part& part : level.parts) {
        if (part.layers == 0) continue;
        const gh::world::Mesh& mesh = level.meshes[part.mesh];
        const auto base = static_cast<std::uint32_t>(scene.positions.size());
        const glm::mat4x3& m = part.mover_from_part;
        for (const glm::vec3& p : mesh.positions)
            scene.positions.push_back(((m[0] * p.x + m[1] * p.y) + m[2] * p.z) + m[3]);
        for (const glm::uvec3& t : mesh.triangles) scene.triangles.push_back(t + glm::uvec3(base));
    }
    aim(scene);
    if (!level.viewpoints.empty()) {
        const gh::world::Viewpoint& v = level.viewpoints.front();
        scene.camera = {v.position, v.yaw, v.pitch, v.fov_y};
    }
    return scene;
}

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

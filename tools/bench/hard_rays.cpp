#include "hard_rays.h"

#include "support/shapes.h"

#include <glm/geometric.hpp>

#include <limits>
#include <memory>

namespace bench {

namespace {

using test::Mesh;
using test::Random;
using Shared = std::shared_ptr<const Mesh>;

BenchScene scene_of(const Mesh& mesh) {
    return {"hard", mesh.positions, mesh.triangles, {}, {}, {}};
}

const glm::uvec3& a_triangle(const Mesh& mesh, Random& random) {
    return mesh.triangles[random.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
}

glm::vec3 a_vertex(const Mesh& mesh, Random& random) {
    return mesh.positions[a_triangle(mesh, random)[random.below(3)]];
}

glm::vec3 an_edge_point(const Mesh& mesh, Random& random, float share) {
    const glm::uvec3& t = a_triangle(mesh, random);
    const std::uint32_t side = random.below(3);
    const glm::vec3 a = mesh.positions[t[side]], b = mesh.positions[t[(side + 1) % 3]];
    return a + (b - a) * share;
}

rc::Ray towards(const glm::vec3& from, const glm::vec3& to) {
    return {.origin = from, .direction = to - from};
}

HardCase at_vertices(const char* name, double share, const glm::vec3& centre, float radius, float spread) {
    const Shared ball = std::make_shared<Mesh>(test::make_ball(centre, radius, 24));
    return {name, share, scene_of(*ball), [=](Random& random) {
                return towards(centre + random.in_cube(spread * radius), a_vertex(*ball, random));
            }};
}

HardCase at_edges() {
    const Shared ball = std::make_shared<Mesh>(test::make_ball(glm::vec3(0.0f), 1.0f, 24));
    return {"edge midpoints", 1.0, scene_of(*ball), [=](Random& random) {
                return towards(random.in_cube(0.4f), an_edge_point(*ball, random, 0.5f));
            }};
}

constexpr float kHalf = 4.0f;
constexpr std::uint32_t kCells = 64;

// Within the sheet: what its border does is not a leak.
float a_lattice_place(Random& random) {
    return -kHalf + 2.0f * kHalf / kCells * static_cast<float>(1 + random.below(kCells - 1));
}

HardCase axis_parallel() {
    return {"axis-parallel, onto a tiled floor", 0.1, scene_of(test::make_sheet(kHalf, 0.0f, kCells)),
            [](Random& random) {
                const float zero = random.below(2) == 0 ? 0.0f : -0.0f;
                return rc::Ray{.origin = {a_lattice_place(random), 2.0f, a_lattice_place(random)},
                               .direction = {zero, -1.0f, -zero}};
            }};
}

// Up and down slanted rays that stay in a plane x = k of the floor's lattice: each meets the floor on an edge.
HardCase in_planes() {
    return {"in the planes of a lattice", 0.1, scene_of(test::make_sheet(kHalf, 0.0f, kCells)),
            [](Random& random) {
                const float x = a_lattice_place(random);
                const glm::vec3 from(x, random.between(0.5f, 2.0f), random.between(-3, 3));
                return towards(from, glm::vec3(x, 0.0f, random.between(-3.9f, 3.9f)));
            }};
}

// A floor of strips a metre long and three micrometres wide.
HardCase slivers() {
    constexpr std::uint32_t kStrips = 2000;
    Mesh mesh;
    for (std::uint32_t i = 0; i <= kStrips; ++i) {
        const float x = static_cast<float>(i) * 3e-6f;
        mesh.positions.insert(mesh.positions.end(), {{x, 0.0f, 0.0f}, {x, 0.0f, 1.0f}});
        if (i == 0) continue;
        const std::uint32_t a = 2 * i - 2;
        mesh.triangles.emplace_back(a, a + 1, a + 2);
        mesh.triangles.emplace_back(a + 2, a + 1, a + 3);
    }
    return {"onto slivers, aspect 3e5", 0.1, scene_of(mesh), [](Random& random) {
                const glm::vec3 to(random.between(1e-5f, 5.9e-3f), 0.0f, random.between(0.01f, 0.99f));
                return towards(to + glm::vec3(random.between(-1, 1), 1.0f, random.between(-1, 1)), to);
            }};
}

// A closed ball inside another whose vertices are NaN, infinite, or out of all range: only the first may be met.
HardCase bad_vertices() {
    Mesh mesh = test::make_ball(glm::vec3(0.0f), 1.0f, 16);
    const Shared good = std::make_shared<Mesh>(mesh);
    Mesh bad = test::make_ball(glm::vec3(0.0f), 0.5f, 8);
    Random random(3);
    for (glm::vec3& p : bad.positions) {
        const float ruin[] = {std::numeric_limits<float>::quiet_NaN(), rc::kInfinity, -rc::kInfinity};
        p[random.below(3)] = ruin[random.below(3)];
    }
    test::append(mesh, bad);
    return {"NaN and infinite vertices inside", 0.1, scene_of(mesh),
            [good](Random& r) { return towards(r.in_cube(0.3f), an_edge_point(*good, r, r.unit())); }};
}

}  // namespace

std::vector<HardCase> hard_cases() {
    std::vector<HardCase> cases;
    cases.push_back(at_vertices("vertices, from inside", 1.0, glm::vec3(0.0f), 1.0f, 0.4f));
    cases.push_back(at_edges());
    cases.push_back(at_vertices("vertices, from the very centre", 0.1, glm::vec3(0.0f), 1.0f, 0.0f));
    cases.push_back(at_vertices("vertices, radius 1e-4", 0.25, glm::vec3(0.0f), 1e-4f, 0.4f));
    cases.push_back(
        at_vertices("vertices, radius 100 at 1e6 m", 0.25, glm::vec3(1e6f, -1e6f, 1e6f), 100.0f, 0.4f));
    cases.push_back(axis_parallel());
    cases.push_back(in_planes());
    cases.push_back(slivers());
    cases.push_back(bad_vertices());
    return cases;
}

}  // namespace bench

// The scenes that need no file.
#include "bench_scenes.h"
#include "support/shapes.h"

#include <glm/geometric.hpp>

#include <cmath>

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

float hill_height(float x, float z) {
    return 3.0f * std::sin(0.11f * x) * std::cos(0.07f * z) + 0.8f * std::sin(0.53f * x + 0.9f * z) +
           0.12f * std::sin(2.9f * x) * std::sin(3.7f * z);
}

BenchScene scene_of(const char* name, test::Mesh&& mesh, const Camera& camera, const glm::vec3& lamp_low,
                    const glm::vec3& lamp_high) {
    return {name, std::move(mesh.positions), std::move(mesh.triangles), camera, lamp_low, lamp_high};
}

// A ring of seats: steps of a circle, each quad tens of metres wide.
test::Mesh make_bowl(float inner, float outer, int steps, int around) {
    test::Mesh mesh;
    for (int j = 0; j <= steps; ++j) {
        const float share = float(j) / float(steps), radius = inner + (outer - inner) * share;
        for (int i = 0; i < around; ++i) {
            const float angle = kTau * float(i) / float(around);
            mesh.positions.emplace_back(radius * std::cos(angle), 25.0f * share * share,
                                        radius * std::sin(angle));
        }
    }
    const auto at = [&](int j, int i) { return static_cast<std::uint32_t>(j * around + i % around); };
    for (int j = 0; j < steps; ++j) {
        for (int i = 0; i < around; ++i) {
            mesh.triangles.emplace_back(at(j, i), at(j + 1, i), at(j, i + 1));
            mesh.triangles.emplace_back(at(j, i + 1), at(j + 1, i), at(j + 1, i + 1));
        }
    }
    return mesh;
}

}  // namespace

BenchScene make_landscape() {
    test::Random random(1859);
    test::Mesh all = test::make_sheet(60.0f, 0.0f, 620);
    for (glm::vec3& p : all.positions) p.y = hill_height(p.x, p.z);
    for (int i = 0; i < 600; ++i) {
        const float x = random.between(-58, 58), z = random.between(-58, 58),
                    size = random.between(0.2f, 0.9f);
        test::Mesh boulder = test::make_ball(glm::vec3(0.0f), size, 7);
        for (glm::vec3& p : boulder.positions) {
            p *= 1.0f + 0.2f * std::sin(7.0f * p.x / size + float(i)) * std::sin(5.0f * p.z / size);
            p += glm::vec3(x, hill_height(x, z) + 0.4f * size, z);
        }
        test::append(all, boulder);
    }
    const Camera camera{{2.0f, hill_height(2.0f, 40.0f) + 1.8f, 40.0f}, 0.2f, -0.12f, 1.1f};
    return scene_of("landscape", std::move(all), camera, {-30, 20, -30}, {30, 26, 10});
}

BenchScene make_stadium() {
    test::Mesh all = make_bowl(40.0f, 95.0f, 6, 24);
    test::append(all, test::make_sheet(40.0f, 0.0f, 2));
    test::append(all, test::make_box({-0.3f, 0, -0.3f}, {0.3f, 1.0f, 0.3f}));
    test::Mesh pot =
        test::make_ball(glm::vec3(0.0f), 0.15f, 340);  // belly, with a spout and a handle pulled out of it
    for (glm::vec3& p : pot.positions) {
        const glm::vec3 d = p / 0.15f;
        const float spout = std::max(0.0f, d.x - 0.93f), handle = std::max(0.0f, -d.x - 0.9f);
        p *= 1.0f + 9.0f * spout + 5.0f * handle + 0.01f * std::sin(40.0f * d.y);
        p.y = 0.8f * p.y + 0.3f * spout;
        p += glm::vec3(0, 1.13f, 0);
    }
    test::append(all, pot);
    const Camera camera{{0.1f, 1.35f, 0.75f}, 0.0f, -0.2f, 1.0f};
    return scene_of("stadium", std::move(all), camera, {-20, 30, -20}, {20, 32, 20});
}

}  // namespace bench

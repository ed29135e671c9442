#include "bench_casts.h"

#include "bench_rays.h"
#include "support/random.h"

#include "raycore/bodies.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <functional>

namespace bench {

namespace {

constexpr std::size_t kBodies = 4000, kFewestBodies = 16;
constexpr double kLongEnoughMs = 200.0;  // of a round

struct Bodies {
    float metre = 1.0f;             // a hundredth of the scene's size stands for 60 cm
    std::vector<glm::vec3> places;  // off the surfaces that the camera sees
    std::vector<glm::vec3> ways;    // of length 1
};

Bodies place_bodies(const BenchScene& scene, const rc::Scene& built) {
    test::Random random(9);
    Bodies bodies;
    const rc::Box box = built.bounds();
    bodies.metre = glm::length(box.max - box.min) / 60.0f;
    const std::vector<RaySet> sets = make_ray_sets(scene, built, 4);
    const std::vector<rc::Ray>& from_surfaces = sets.back().rays;  // diffuse bounces
    for (std::size_t i = 0; i < kBodies && !from_surfaces.empty(); ++i) {
        const rc::Ray& ray = from_surfaces[random.below(static_cast<std::uint32_t>(from_surfaces.size()))];
        bodies.places.push_back(ray.origin + ray.direction * (0.5f * bodies.metre));
        bodies.ways.push_back(random.direction());
    }
    return bodies;
}

void report_question(Report& report, const char* name, int rounds, const Bodies& bodies,
                     const std::function<bool(std::size_t)>& question) {
    std::size_t met = 0, n = std::min(kFewestBodies, bodies.places.size());
    const auto ask = [&](int) {
        met = 0;
        for (std::size_t i = 0; i < n; ++i) met += question(i);
    };
    // Fewer where one question takes milliseconds: a man beside a teapot of a million triangles touches most of them.
    for (double start = thread_ms(); n < bodies.places.size(); start = thread_ms()) {
        ask(0);
        if (2.0 * (thread_ms() - start) > kLongEnoughMs) break;
        n = std::min(2 * n, bodies.places.size());
    }
    const Samples us = measure(thread_ms, rounds, n, ask);
    Samples per_second;
    for (const double ms : us.ms) per_second.ms.push_back(1e-6 / (ms * 1e-3));
    report.row(name).spread(per_second, 3).number(us.at(0.5) * 1e3);
    report.number(100.0 * static_cast<double>(met) / static_cast<double>(n), 0);
}

}  // namespace

void bench_casts(Report& report, const BenchScene& scene, int rounds) {
    rc::SceneBuilder builder;
    builder.add({rc::build_blas(scene.view(), {rc::BuildQuality::High})});
    const auto built = builder.commit();
    const Bodies b = place_bodies(scene, *built);
    const float m = b.metre;
    report.table("bodies in " + scene.name, "question", {"million a second [quartiles]", "us each", "% met"});
    if (b.places.empty()) {
        report.note("the camera sees nothing to put bodies at");
        return;
    }
    const auto ask = [&](const char* name, const std::function<bool(std::size_t)>& question) {
        report_question(report, name, rounds, b, question);
    };
    const auto axis = [&](std::size_t i) {
        return rc::Segment{b.places[i], b.places[i] + glm::vec3(0, 1.2f * m, 0)};
    };
    rc::CastHit out[8];
    ask("ball of 10 cm, a tick of 1 m", [&](std::size_t i) {
        return rc::sphere_cast(*built, b.places[i], 0.1f * m, b.ways[i] * m, rc::kAllLayers).has_value();
    });
    ask("ball of 10 cm, thrown 10 m", [&](std::size_t i) {
        return rc::sphere_cast(*built, b.places[i], 0.1f * m, b.ways[i] * (10 * m), rc::kAllLayers)
            .has_value();
    });
    ask("character, a step of 10 cm", [&](std::size_t i) {
        return rc::capsule_cast(*built, axis(i), 0.3f * m, b.ways[i] * (0.1f * m), rc::kAllLayers)
            .has_value();
    });
    ask("ball of 30 cm at rest", [&](std::size_t i) {
        return rc::sphere_overlaps(*built, b.places[i], 0.3f * m, rc::kAllLayers, out) != 0;
    });
    ask("character at rest", [&](std::size_t i) {
        return rc::capsule_overlaps(*built, axis(i), 0.3f * m, rc::kAllLayers, out) != 0;
    });
    ask("turned crate of 60 cm at rest", [&](std::size_t i) {
        const glm::vec3 x = b.ways[i], y = glm::normalize(glm::cross(x, glm::vec3(x.y, x.z, -x.x)));
        return rc::box_overlaps(*built, {b.places[i], glm::vec3(0.3f * m), {x, y, glm::cross(x, y)}},
                                rc::kAllLayers, out) != 0;
    });
    ask("closest point", [&](std::size_t i) {
        return rc::closest_point(*built, b.places[i], rc::kInfinity, rc::kAllLayers).has_value();
    });
    ask("closest point within 30 cm", [&](std::size_t i) {
        return rc::closest_point(*built, b.places[i], 0.3f * m, rc::kAllLayers).has_value();
    });
}

}  // namespace bench

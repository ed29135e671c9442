#include "bench_refit.h"

#include "bench_race.h"
#include "load/level_loader.h"
#include "raycore_side.h"
#include "spatial/pose.h"
#include "spatial/skinning.h"
#include "support/random.h"
#include "support/shapes.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace bench {

namespace {

struct Pose {
    std::string name;
    std::vector<glm::vec3> positions;
};

// A mesh where its tree is built, and where it goes.
struct Mover {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    std::vector<Pose> poses;
};

// Swings by waves of ever more height, then is crumpled: every point drawn to one of a few by ever more.
Mover make_cloth() {
    test::Mesh sheet = test::make_sheet(1.0f, 0.0f, 128);
    Mover cloth{"cloth, 33 k", sheet.positions, sheet.triangles, {}};
    for (const float height : {0.03f, 0.1f, 0.3f, 1.0f}) {
        Pose pose{"waves of " + std::to_string(height).substr(0, 4) + " m", sheet.positions};
        for (glm::vec3& p : pose.positions) p.y = height * std::sin(5.0f * p.x) * std::cos(4.0f * p.z);
        cloth.poses.push_back(std::move(pose));
    }
    for (const float share : {0.02f, 0.05f, 0.1f, 0.25f, 0.5f}) {
        test::Random random(8);
        std::vector<glm::vec3> knots(12);
        for (glm::vec3& knot : knots) knot = random.in_cube(0.5f);
        Pose pose{"crumpled by " + std::to_string(share).substr(0, 4), sheet.positions};
        for (std::size_t i = 0; i < pose.positions.size(); ++i) {
            const glm::vec3& p = sheet.positions[i];
            const auto knot = static_cast<std::size_t>(6.0f + 5.9f * std::sin(3.0f * p.x + 2.0f * p.z));
            pose.positions[i] = p * (1.0f - share) + knots[knot] * share;
        }
        cloth.poses.push_back(std::move(pose));
    }
    return cloth;
}

// Pieces of a ball, each its own way.
Mover make_shards() {
    const test::Mesh ball = test::make_ball(glm::vec3(0.0f), 1.0f, 90);
    Mover shards{"shards, 32 k", {}, {}, {}};
    for (const glm::uvec3& triangle : ball.triangles) {
        const auto first = static_cast<std::uint32_t>(shards.positions.size());
        for (glm::length_t c = 0; c < 3; ++c) shards.positions.push_back(ball.positions[triangle[c]]);
        shards.triangles.emplace_back(first, first + 1, first + 2);
    }
    for (const float way : {0.005f, 0.01f, 0.02f, 0.05f, 0.1f, 0.3f, 1.0f}) {
        test::Random random(5);
        Pose pose{"flown " + std::to_string(way).substr(0, 5) + " m", shards.positions};
        for (std::size_t i = 0; i < pose.positions.size(); i += 3) {
            const glm::vec3 by = random.in_cube(way);
            for (std::size_t c = 0; c < 3; ++c) pose.positions[i + c] += by;
        }
        shards.poses.push_back(std::move(pose));
    }
    return shards;
}

// Built as the model rests, then through the clip; nothing when the level has no guard.
std::vector<Mover> make_guards() {
    const auto level =
        gh::load::load_level(GLASSHOUSE_SOURCE_DIR "/assets/levels/foyer.glb", {.finds_ways = false});
    if (!level || level->models.empty()) return {};
    const gh::world::Model& model = level->models[0];
    const gh::world::Mesh& mesh = level->meshes[model.mesh];
    Mover guard{
        "guard, " + std::to_string(mesh.triangles.size() / 1000) + " k", mesh.positions, mesh.triangles, {}};
    std::vector<glm::mat4x3> skin(model.joints.size());
    for (const auto& [name, clip] :
         {std::pair("walks", gh::world::ClipId::Walk), std::pair("runs", gh::world::ClipId::Run),
          std::pair("reaches", gh::world::ClipId::Reach)}) {
        for (const float seconds : {0.25f, 0.5f}) {
            gh::spatial::PoseKey key;
            key.clip = clip;
            key.clip_time = seconds;
            gh::spatial::pose_body(model, key, skin);
            gh::world::PosedMesh posed;
            gh::spatial::skin_mesh(mesh, skin, posed);
            guard.poses.push_back(
                {std::string(name) + ", " + std::to_string(seconds).substr(0, 4) + " s", posed.positions});
        }
    }
    return {std::move(guard)};
}

std::shared_ptr<const rc::Scene> scene_of(std::shared_ptr<const rc::Blas> blas) {
    rc::SceneBuilder builder;
    builder.add({.blas = std::move(blas)});
    return builder.commit();
}

// From around the mesh at points in its box: what eyes, lamps and footsteps ask of a body.
std::vector<rc::Ray> rays_at(const rc::Box& box, std::size_t count) {
    test::Random random(17);
    const glm::vec3 centre = 0.5f * (box.min + box.max), half = 0.5f * (box.max - box.min);
    std::vector<rc::Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 from = centre + glm::normalize(random.in_cube(1.0f)) * (2.0f * glm::length(half));
        const glm::vec3 at = centre + random.in_cube(1.0f) * half;
        rays.push_back({.origin = from, .direction = at - from});
    }
    return rays;
}

struct Figures {
    Samples refit, build;        // ms of the thread
    Samples old_tree, new_tree;  // ns a ray
    Samples slower;              // old / new, round by round
    double growth = 1.0;         // since the tree was built: what a game can ask
    double excess = 1.0;         // over a new tree's: what it would like to know
    bool agrees = true;
};

Figures judge(const Mover& mover, const Pose& pose, const RefitOptions& options) {
    Figures figures;
    const std::shared_ptr<rc::Blas> blas = rc::build_blas({mover.positions, mover.triangles});
    std::shared_ptr<rc::Blas> fresh;
    for (int round = 0; round < options.rounds; ++round) {
        double start = thread_ms();
        rc::refit_blas(*blas, pose.positions);
        figures.refit.ms.push_back(thread_ms() - start);
        start = thread_ms();
        fresh = rc::build_blas({pose.positions, mover.triangles});
        figures.build.ms.push_back(thread_ms() - start);
    }
    figures.growth = static_cast<double>(blas->refit_degradation());
    figures.excess = static_cast<double>(blas->sah_cost()) / static_cast<double>(fresh->sah_cost());
    const std::vector<rc::Ray> rays = rays_at(blas->bounds(), options.rays);
    const auto old_scene = scene_of(blas), new_scene = scene_of(fresh);
    const auto ask = [&](const rc::Scene& scene, Samples& samples) {
        const double start = thread_ms();
        const Answer answer = ask_single(scene, rays, false);
        samples.ms.push_back((thread_ms() - start) * 1e6 / static_cast<double>(rays.size()));
        return answer;
    };
    for (int round = 0; round < options.rounds; ++round) {
        const Answer old_answer = ask(*old_scene, figures.old_tree),
                     new_answer = ask(*new_scene, figures.new_tree);
        figures.agrees = figures.agrees && old_answer.hash == new_answer.hash;
        figures.slower.ms.push_back(figures.old_tree.ms.back() / figures.new_tree.ms.back());
    }
    return figures;
}

void report_mover(Report& report, const Mover& mover, const RefitOptions& options) {
    for (const Pose& pose : mover.poses) {
        const Figures f = judge(mover, pose, options);
        const double spared = f.old_tree.at(0.5) - f.new_tree.at(0.5),
                     dearer = f.build.at(0.5) - f.refit.at(0.5);
        report.row(mover.name + ": " + pose.name).number(f.growth).number(f.excess).number(f.slower.at(0.5));
        report.number(f.old_tree.at(0.5), 0).number(f.new_tree.at(0.5), 0);
        report.number(f.refit.at(0.5), 3).number(f.build.at(0.5), 2);
        spared > 0.05 * f.new_tree.at(0.5) ? report.number(dearer * 1e6 / spared * 1e-3, 0) : report.none();
        if (!f.agrees) report.note(mover.name + ", " + pose.name + ": ANSWERS DIFFER");
    }
}

}  // namespace

void bench_refit(Report& report, const RefitOptions& options) {
    report.table("refitted trees beside new ones, one thread, default quality", "who moved",
                 {"SAH since built", "SAH, old / new", "time, old / new", "ns a ray, old", "new", "refit ms",
                  "build ms", "k rays a tick for a build to pay"});
    report_mover(report, make_cloth(), options);
    for (const Mover& guard : make_guards()) report_mover(report, guard, options);
    report_mover(report, make_shards(), options);
}

}  // namespace bench

#include "bench_senses.h"

#include "base/hash.h"
#include "base/random.h"
#include "figures.h"
#include "sense/exposure.h"
#include "sense/hearing.h"
#include "sense/sight.h"
#include "spatial/stage.h"
#include "spatial/wardrobe.h"
#include "world/initial_state.h"

#include <optional>

namespace bench {
namespace {

using namespace gh;

// Where somebody may stand: the spawn and every patrol point.
std::vector<glm::vec3> places_of(const world::Level& level) {
    std::vector<glm::vec3> places = {level.spawn.position};
    for (const world::Guard& guard : level.guards) {
        for (const world::PatrolPoint& point : guard.patrol) places.push_back(point.position);
    }
    return places;
}

void bench_stage(const std::shared_ptr<const world::Level>& level, int rounds) {
    print_head("spatial, core time");
    std::optional<spatial::Stage> stage;
    print_row("Stage: every tree of the level", measure(cpu_ms, 3, 1, [&](int) { stage.emplace(level); }));
    world::State state = world::initial_state(*level, 1);
    const auto walk = [&](int tick) {
        for (world::GuardState& guard : state.guards) {
            guard.clip = world::ClipId::Walk;
            guard.clip_time = 0.016f * static_cast<float>(tick);
        }
    };
    print_row("commit, every guard walking", measure(cpu_ms, rounds * 10, 1, [&](int tick) {
                  walk(tick);
                  (void)stage->commit(state);
              }));
    print_row("commit, nobody bends (transforms and TLAS)",
              measure(cpu_ms, rounds * 10, 1, [&](int) { (void)stage->commit(state); }));
    if (level->models.empty()) return;
    const world::Model& model = level->models[0];
    const auto wardrobe = std::make_shared<spatial::Wardrobe>(model, level->meshes[model.mesh]);
    std::unique_ptr<spatial::PosedBody> body = wardrobe->take();
    const auto pose = [&](int tick) {
        wardrobe->pose({.clip_time = 0.016f * static_cast<float>(tick), .clip = world::ClipId::Walk}, *body);
    };
    print_row("one guard: pose, skin, refit", measure(cpu_ms, rounds * 10, 1, pose));
    std::printf("  (%zu vertices, %zu triangles, refit costs %.2f of a build in the last pose)\n",
                level->meshes[model.mesh].positions.size(), level->meshes[model.mesh].triangles.size(),
                static_cast<double>(body->blas->refit_degradation()));
}

void bench_light(const world::Level& level, const world::Snapshot& now,
                 std::span<const sense::BodyPoints> bodies, int rounds) {
    Hasher hash;
    float least = 1.0f, most = 0.0f;
    const Samples samples = measure(cpu_ms, rounds, bodies.size(), [&](int round) {
        for (const sense::BodyPoints& body : bodies) {
            const sense::Exposure exposure = sense::exposure(level, now, body);
            if (round != 0) continue;
            hash.add(exposure.level);
            least = std::min(least, exposure.level);
            most = std::max(most, exposure.level);
        }
    });
    print_row("exposure of a body", samples, hash.digest());
    std::printf("  (%zu lamps; %.2f to %.2f at %zu places)\n", level.lamps.size(), static_cast<double>(least),
                static_cast<double>(most), bodies.size());
}

void look(const world::Snapshot& now, std::span<const sense::Eye> eyes, const sense::BodyPoints& points,
          bool in_mirrors, std::span<sense::Sighting> seen) {
    sense::Body body{.point = points};
    body.lit.fill(1.0f);
    if (in_mirrors) {
        sense::mirror_sight(*now.scene, now.panes, eyes, body, seen);
    } else {
        sense::sight(*now.scene, eyes, body, seen);
    }
}

void bench_eyes(const world::Snapshot& now, std::span<const glm::vec3> places,
                std::span<const sense::BodyPoints> bodies, int rounds) {
    std::vector<sense::Eye> eyes;
    for (const glm::vec3& place : places) {
        eyes.push_back({.position = place + glm::vec3(0.0f, 1.68f, 0.0f),
                        .forward = {0.0f, 0.0f, -1.0f},
                        .cos_half_fov = -1.0f,
                        .range = 35.0f});  // looks everywhere: the dearest case
    }
    std::vector<sense::Sighting> seen(eyes.size());
    for (const bool in_mirrors : {false, true}) {
        Hasher hash;
        const Samples samples = measure(cpu_ms, rounds, bodies.size() * eyes.size(), [&](int round) {
            for (const sense::BodyPoints& points : bodies) {
                look(now, eyes, points, in_mirrors, seen);
                if (round != 0) continue;
                for (const sense::Sighting& s : seen) hash.add(s.seen);
            }
        });
        print_row(in_mirrors ? "sight in mirrors, one eye" : "sight, one eye", samples, hash.digest());
    }
}

void bench_ears(const world::Level& level, const world::Snapshot& now, std::span<const glm::vec3> places,
                int rounds) {
    Hasher hash;
    const glm::vec3 ear_height(0.0f, 1.65f, 0.0f), foot_height(0.0f, 0.05f, 0.0f);
    const Samples samples = measure(cpu_ms, rounds, places.size() * places.size(), [&](int round) {
        for (const glm::vec3& from : places) {
            for (const glm::vec3& to : places) {
                const sense::Transmission heard =
                    sense::hear(level, *now.scene, from + foot_height, to + ear_height);
                if (round == 0) hash.add(heard.band_db[1]);
            }
        }
    });
    print_row("hearing, one noise and ear", samples, hash.digest());
}

}  // namespace

void bench_stage_and_senses(const std::shared_ptr<const world::Level>& level, int rounds) {
    bench_stage(level, rounds);
    spatial::Stage stage(level);
    const world::Snapshot now = stage.commit(world::initial_state(*level, 1));
    const std::vector<glm::vec3> places = places_of(*level);
    std::vector<sense::BodyPoints> bodies;
    for (const glm::vec3& place : places) {
        world::PlayerState player;
        player.position = place;
        bodies.push_back(sense::body_points(player));
    }
    print_head("sense, core time of a call");
    bench_light(*level, now, bodies, rounds);
    bench_eyes(now, places, bodies, rounds);
    bench_ears(*level, now, places, rounds);
}

}  // namespace bench

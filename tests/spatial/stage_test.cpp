// The stage shows each tick as a pure function of Level and State, and never touches what somebody still looks at.
#include "spatial/stage.h"

#include "base/hash.h"
#include "base/jobs.h"
#include "base/random.h"
#include "spatial/wardrobe.h"
#include "support/small_level.h"

#include "raycore/query.h"

#include <gtest/gtest.h>

#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace gh::spatial {
namespace {

constexpr float kReach = 8.0f;

// A floor, a door, a lens, stones and two guards.
std::shared_ptr<const world::Level> gallery() {
    test::SmallLevel small;
    const std::uint32_t plaster = small.add_material(world::Surface::Plaster);
    small.add_box({-8.0f, -0.1f, -8.0f}, {8.0f, 0.0f, 8.0f}, plaster);
    const std::uint32_t leaf = small.add_box({0.0f, 0.0f, -0.02f}, {1.0f, 2.0f, 0.02f}, plaster);
    small.hang_door(leaf, {-3.0f, 0.0f, 0.0f});
    const std::uint32_t lens = small.add_box(glm::vec3(-0.1f), glm::vec3(0.1f), plaster);
    small.part(lens).mover = world::Mover::Lens;
    world::Lens place;
    place.world_from_lens = test::moved_by({0.0f, 1.2f, -4.0f});
    small.level.lenses.push_back(place);
    small.level.stone_part_begin = static_cast<std::uint32_t>(small.level.parts.size());
    for (std::uint32_t i = 0; i < world::kMaxStones; ++i) {
        const std::uint32_t stone = small.add_box(glm::vec3(-0.05f), glm::vec3(0.05f), plaster);
        small.part(stone).mover = world::Mover::Stone;
        small.part(stone).mover_index = i;
    }
    test::add_doll(small, {2.0f, 0.0f, 0.0f}, plaster);
    test::add_doll(small, {-1.0f, 0.0f, 3.0f}, plaster);
    return std::make_shared<world::Level>(small.level);
}

// The gallery at some moment of its life.
world::State moment(const world::Level& level, std::uint32_t tick) {
    world::State state;
    state.tick = tick;
    const float t = static_cast<float>(tick) * world::kTickSeconds;
    state.doors[0].angle = 0.4f * t;
    state.stones[3].is_present = tick % 2 == 0 ? 1 : 0;
    state.stones[3].position = {1.0f - t, 1.5f, -1.0f};
    for (std::size_t g = 0; g < level.guards.size(); ++g) {
        world::GuardState& guard = state.guards[g];
        guard.position = level.guards[g].position + glm::vec3(0.0f, 0.0f, 0.3f * t);
        guard.yaw = 0.7f * t;
        guard.head_yaw = -0.2f * t;
        guard.clip = world::ClipId::Walk;
        guard.clip_before = world::ClipId::Look;
        guard.clip_time = t;
        guard.clip_before_time = 0.3f;
        guard.clip_blend = tick < 20 ? 0.05f * static_cast<float>(tick) : 1.0f;
    }
    return state;
}

// Everything the world says to a bundle of rays, and what it says of itself.
std::uint64_t answers(const world::Snapshot& now) {
    Hasher hash;
    Random random(99);
    for (int i = 0; i < 400; ++i) {
        const auto anywhere = [&] {
            return glm::vec3(random.in_range(-5.0f, 5.0f), random.in_range(0.05f, 2.2f),
                             random.in_range(-5.0f, 5.0f));
        };
        const glm::vec3 from = anywhere();
        const rc::Ray ray{.origin = from, .direction = anywhere() - from, .t_max = kReach};
        const rc::Hit hit = rc::closest_hit(*now.scene, ray, world::kEverything).value_or(rc::Hit{});
        hash.add(hit.t);
        hash.add(hit.u);
        hash.add(hit.v);
        hash.add(hit.primitive);
        hash.add(hit.instance);
    }
    for (const auto& posed : now.posed) {
        if (!posed) continue;
        for (const glm::vec3& p : posed->positions) hash.add(p);
        for (const glm::vec3& n : posed->normals) hash.add(n);
    }
    for (const glm::vec3& eye : now.guard_eyes) hash.add(eye);
    for (const glm::vec3& look : now.guard_looks) hash.add(look);
    return hash.digest();
}

TEST(Stage, RewindingTheStateGivesTheSameAnswersAgain) {
    const auto level = gallery();
    Stage stage(level);
    std::vector<std::uint64_t> first;
    for (std::uint32_t tick = 0; tick < 60; ++tick)
        first.push_back(answers(stage.commit(moment(*level, tick))));
    for (std::uint32_t tick = 60; tick-- > 0;) {
        EXPECT_EQ(answers(stage.commit(moment(*level, tick))), first[tick]) << "backwards, tick " << tick;
    }
    Stage fresh(level);
    EXPECT_EQ(answers(fresh.commit(moment(*level, 41))), first[41]) << "without any past";
    EXPECT_NE(first[3], first[4]) << "the moments do not differ, so nothing was tested";
}

TEST(Stage, TheSameBitsForOneTwoAndEightThreads) {
    const auto level = gallery();
    std::vector<std::uint64_t> alone;
    for (const int threads : {1, 2, 8}) {
        const Jobs jobs(threads);
        std::vector<std::uint64_t> all;
        jobs.run_in([&] {
            Stage stage(level);
            for (std::uint32_t tick = 0; tick < 12; ++tick)
                all.push_back(answers(stage.commit(moment(*level, tick), jobs)));
        });
        if (alone.empty()) alone = all;
        EXPECT_EQ(all, alone) << threads << " threads";
    }
}

TEST(Stage, ASnapshotIsNotChangedByLaterOnes) {
    const auto level = gallery();
    std::optional<Stage> stage(level);
    std::vector<world::Snapshot> kept;
    std::vector<std::uint64_t> were;
    for (std::uint32_t tick = 0; tick < 8; ++tick) {
        kept.push_back(stage->commit(moment(*level, tick)));
        were.push_back(answers(kept.back()));
    }
    for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(answers(kept[i]), were[i]) << "tick " << i;
    stage.reset();
    for (std::size_t i = 0; i < kept.size(); ++i)
        EXPECT_EQ(answers(kept[i]), were[i]) << "after the stage is gone";
}

TEST(Stage, AGuardThatStandsStillKeepsItsTree) {
    const auto level = gallery();
    Stage stage(level);
    world::State state = moment(*level, 30);
    const world::Snapshot before = stage.commit(state);
    state.guards[0].position.x += 0.5f;  // slides, but bends nothing
    state.guards[1].clip_time += 0.1f;
    const world::Snapshot after = stage.commit(state);
    const std::uint32_t first = static_cast<std::uint32_t>(level->parts.size() - 2);
    EXPECT_EQ(before.posed[first], after.posed[first]);
    EXPECT_EQ(before.scene->instance(first).blas, after.scene->instance(first).blas);
    EXPECT_NE(before.posed[first + 1], after.posed[first + 1]);
}

TEST(Stage, AGuardsTreeMeetsRaysWhereItsSkinIs) {
    const auto level = gallery();
    Stage stage(level);
    (void)stage.commit(moment(*level, 0));
    const world::State state = moment(*level, 30);
    const world::Snapshot now = stage.commit(state);
    const std::uint32_t part = static_cast<std::uint32_t>(level->parts.size() - 1);
    const world::PosedMesh& posed = *now.posed[part];
    const std::vector<glm::uvec3>& triangles = level->meshes[level->parts[part].mesh].triangles;
    // Built from scratch over the posed skin, at the same place: the refitted tree must give the same hits.
    rc::SceneBuilder builder;
    builder.add({.blas = rc::build_blas({.positions = posed.positions, .triangles = triangles}),
                 .world_from_instance = now.scene->instance(part).world_from_instance});
    const auto rebuilt = builder.commit();
    int hits = 0;
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 from(random.in_range(-3.0f, 1.0f), random.in_range(0.0f, 2.0f),
                             random.in_range(1.0f, 5.0f));
        const glm::vec3 to =
            state.guards[1].position + glm::vec3(random.in_range(-0.3f, 0.3f), random.in_range(0.0f, 1.9f),
                                                 random.in_range(-0.3f, 0.3f));
        const rc::Ray ray{.origin = from, .direction = to - from};
        const auto a = rc::closest_hit(*rebuilt, ray, rc::kAllLayers);
        const auto b = rc::closest_hit(*now.scene, ray, world::Light);
        if (b && b->instance != part) continue;  // something else stands in front
        ASSERT_EQ(a.has_value(), b.has_value());
        if (!a) continue;
        ++hits;
        EXPECT_EQ(a->primitive, b->primitive);
        EXPECT_EQ(a->t, b->t);
    }
    EXPECT_GT(hits, 500);
}

TEST(Stage, StonesAndLensesVanishWhenTheyAreGone) {
    const auto level = gallery();
    Stage stage(level);
    world::State state;
    state.guards[0].position = {7.0f, 0.0f, 7.0f};
    state.guards[1].position = {7.0f, 0.0f, 6.0f};
    const rc::Ray at_lens{.origin = {0.0f, 1.2f, 0.0f}, .direction = {0.0f, 0.0f, -1.0f}, .t_max = 6.0f};
    const rc::Ray at_stone{.origin = {4.0f, 0.5f, -6.0f}, .direction = {0.0f, 0.0f, 1.0f}, .t_max = 4.0f};
    const auto meets = [&](const rc::Ray& ray) {
        return rc::any_hit(*stage.commit(state).scene, ray, world::kEverything);
    };
    EXPECT_TRUE(meets(at_lens));
    EXPECT_FALSE(meets(at_stone));
    state.stones[0].position = {4.0f, 0.5f, -4.0f};
    EXPECT_FALSE(meets(at_stone)) << "a stone still in the pocket";
    state.stones[0].is_present = 1;
    EXPECT_TRUE(meets(at_stone));
    state.lens_taken[0] = 1;
    EXPECT_FALSE(meets(at_lens));
}

// The renderer draws one tick, on its own thread, while the next is committed, and lets go of it when it likes.
TEST(Stage, ATickMayBeReadAndDroppedWhileTheNextIsMade) {
    const auto level = gallery();
    std::vector<std::uint64_t> expected;
    {
        Stage alone(level);
        for (std::uint32_t tick = 0; tick < 24; ++tick)
            expected.push_back(answers(alone.commit(moment(*level, tick))));
    }
    Stage stage(level);
    std::mutex mutex;
    std::shared_ptr<const world::Snapshot> latest;
    bool is_over = false;
    int drawn = 0, wrong = 0;
    std::thread renderer([&] {
        for (bool goes_on = true; goes_on;) {
            std::shared_ptr<const world::Snapshot> mine;
            {
                const std::lock_guard lock(mutex);
                mine = latest;
                goes_on = !is_over;
            }
            if (!mine) continue;
            ++drawn;
            wrong += answers(*mine) != expected[mine->state.tick];
        }
    });
    for (std::uint32_t tick = 0; tick < 24; ++tick) {
        auto now = std::make_shared<const world::Snapshot>(stage.commit(moment(*level, tick)));
        const std::lock_guard lock(mutex);
        latest = std::move(now);
        is_over = tick == 23;
    }
    renderer.join();
    EXPECT_GT(drawn, 0);
    EXPECT_EQ(wrong, 0);
}

TEST(Wardrobe, BodiesNobodyLooksAtAreWornAgain) {
    const auto level = gallery();
    const auto wardrobe = std::make_shared<Wardrobe>(level->models[0], level->meshes[level->models[0].mesh]);
    std::shared_ptr<const PosedBody> now, before;  // the game holds a tick or two
    for (int tick = 0; tick < 50; ++tick) {
        std::unique_ptr<PosedBody> body = wardrobe->take();
        wardrobe->pose({.clip_time = 0.02f * static_cast<float>(tick), .clip = world::ClipId::Walk}, *body);
        before = now;
        now = wardrobe->publish(std::move(body));
    }
    EXPECT_EQ(wardrobe->bodies_made(), 3u);
}

}  // namespace
}  // namespace gh::spatial

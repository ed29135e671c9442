// A sheet that hangs a hair above a floor: light must not start behind it. How thin may a gap be?
#include "support/brute_force.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

using test::Mesh;
using test::Random;

// Two sheets of half a metre's reach, `gap` apart, as one mesh under one instance, so that the gap is in their own frame.
std::shared_ptr<const rc::Scene> scene_with_gap(float gap, const glm::mat4x3& place) {
    Mesh both = test::make_sheet(0.5f, 0.0f, 4);
    test::append(both, test::make_sheet(0.6f, gap, 5));  // other joints than the floor's
    rc::SceneBuilder builder;
    builder.add({rc::build_blas(both.view()), place});
    return builder.commit();
}

// A quarter turn about x and a bit: nothing lies along an axis any more.
glm::mat4x3 turned(float angle, const glm::vec3& offset) {
    const float c = std::cos(angle), s = std::sin(angle);
    glm::mat4x3 place(1, 0, 0, 0, c, s, 0, -s, c, 0, 0, 0);
    place[3] = offset;
    return place;
}

// Rays from the floor up, half of them grazing: how many of a thousand do not meet the sheet above.
int leaks(float gap, const glm::mat4x3& place) {
    const auto scene = scene_with_gap(gap, place);
    Random random(71);
    int leaked = 0;
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 local(random.between(-0.3f, 0.3f), 0.0f, random.between(-0.3f, 0.3f));
        const glm::vec3 below = place * glm::vec4(local + glm::vec3(0.1f, -0.4f, 0.2f), 1.0f);
        const glm::vec3 at = place * glm::vec4(local, 1.0f);
        const auto hit = rc::closest_hit(*scene, {.origin = below, .direction = at - below}, rc::kAllLayers);
        if (!hit || hit->primitive >= 32) return 1000;  // the floor, seen from below
        glm::vec3 way = random.direction();
        way.y = i % 2 == 0 ? std::abs(way.y) + 1e-3f : std::abs(way.y) * 4.0f * gap + gap;
        const glm::vec3 up = place * glm::vec4(way, 0.0f);
        // The sheet is wide enough for every way that climbs a gap within 0.2 m.
        if (glm::length(glm::vec3(way.x, 0, way.z)) * gap > 0.2f * way.y) continue;
        leaked += !rc::any_hit(*scene, rc::spawn_ray(scene->surface(*hit), up), rc::kAllLayers);
    }
    return leaked;
}

float smallest_tight_gap(const glm::mat4x3& place) {
    float tight = 1.0f;
    for (float gap = 0.1f; gap > 1e-8f; gap *= 0.5f) {
        if (leaks(gap, place) > 0) break;
        tight = gap;
    }
    return tight;
}

// The aim is 1e-5 of the sheet's size, wherever it stands and however it is turned.
TEST(ThinGap, NoRayStartsBehindASheetAHundredThousandthOfItsSizeAway) {
    const float level = smallest_tight_gap(glm::mat4x3(1.0f));
    const float askew = smallest_tight_gap(turned(0.7f, glm::vec3(0.0f)));
    RecordProperty("smallest_gap_level_millionths_of_size", std::to_string(1e6f * level));
    RecordProperty("smallest_gap_turned_millionths_of_size", std::to_string(1e6f * askew));
    EXPECT_LE(level, 1e-5f);
    EXPECT_LE(askew, 1e-5f);
}

// Away from the world's origin its floats decide: a point of the world is known to 2^-24 of its coordinates, and the
// way off a surface is a few of those.
TEST(ThinGap, FarAwayTheGapIsAsThinAsTheWorldsFloatsAllow) {
    for (const float distance : {10.0f, 1e3f, 3e4f}) {
        const float tight = smallest_tight_gap(turned(0.7f, glm::vec3(distance, 0.3f * distance, -distance)));
        RecordProperty("smallest_gap_at_" + std::to_string(static_cast<int>(distance)) + "_m",
                       std::to_string(tight));
        EXPECT_LE(tight, 60.0f * distance * 0x1p-24f) << distance;
    }
}

}  // namespace

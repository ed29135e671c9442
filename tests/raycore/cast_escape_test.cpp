// Nothing thrown leaves a closed room. Sweeps that iterate to a cap lose 482, 112 or 8 of 2000 stones; these
// may lose none. Each stone goes on from where it touched, so that every cast but the first starts in
// contact.
#include "support/brute_force.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace test {
namespace {

constexpr int kStones = 5'000;
constexpr int kBounces = 10;
constexpr float kTick = 1.0f / 60.0f;

// 1 to 1000 m/s, each factor as likely as another.
float a_speed(Random& random) {
    return std::pow(10.0f, 3.0f * random.unit());
}

struct Escapes {
    int escaped = 0, casts = 0, contacts = 0;
    float worst = 0.0f;  // how far outside
};

// `outside` says how far beyond the walls a centre is; a stone stays below -radius, rounding aside.
template <class Cast, class Outside>
Escapes throw_stones(std::uint64_t seed, const glm::vec3& centre, float spread, float rounding, Cast&& cast,
                     Outside&& outside) {
    Random random(seed);
    Escapes result;
    for (int stone = 0; stone < kStones; ++stone) {
        const float radius = random.below(4) == 0 ? 0.005f : random.between(0.02f, 0.2f);
        glm::vec3 at = centre + random.in_cube(spread);
        for (int bounce = 0; bounce < kBounces; ++bounce) {
            // Alternately a tick and a second of flight.
            const float seconds = bounce % 2 == 0 ? kTick : 1.0f;
            const glm::vec3 way = random.direction() * (a_speed(random) * seconds);
            const std::optional<rc::CastHit> hit = cast(at, radius, way);
            ++result.casts;
            if (hit) {
                ++result.contacts;
                at += way * hit->t;
                // Float positions overlap a wall by rounding; a game's skin would take care of it, here the
                // normal does.
                at += hit->normal * (hit->depth + rounding);
            } else {
                at += way;
            }
            const float beyond = outside(at) + radius;
            result.worst = std::max(result.worst, beyond);
            if (beyond > 4.0f * rounding + 2e-7f * glm::length(way)) {
                ++result.escaped;
                break;
            }
        }
    }
    return result;
}

template <class Outside>
Escapes throw_balls(const TestScene& scene, std::uint64_t seed, const glm::vec3& centre, float spread,
                    float rounding, Outside&& outside) {
    const auto cast = [&](const glm::vec3& at, float radius, const glm::vec3& way) {
        return rc::sphere_cast(scene.scene(), at, radius, way, rc::kAllLayers);
    };
    return throw_stones(seed, centre, spread, rounding, cast, outside);
}

TEST(CastEscape, NoStoneLeavesABallOfManyTriangles) {
    TestScene scene;
    scene.add(make_ball(glm::vec3(0.0f), 3.0f, 6));
    scene.commit();
    // The faces of the ball lie a little inside its sphere: outside is measured from the nearest face's
    // plane.
    const Mesh ball = make_ball(glm::vec3(0.0f), 3.0f, 6);
    const auto outside = [&](const glm::vec3& p) {
        float farthest = -3.0f;
        for (const glm::uvec3& t : ball.triangles) {
            const glm::vec3 a = ball.positions[t.x];
            glm::vec3 n = glm::cross(ball.positions[t.y] - a, ball.positions[t.z] - a);
            n *= (glm::dot(n, a) < 0.0f ? -1.0f : 1.0f) / glm::length(n);
            farthest = std::max(farthest, glm::dot(n, p - a));
        }
        return farthest;
    };
    const Escapes result = throw_balls(scene, 1, glm::vec3(0.0f), 1.0f, 2e-6f, outside);
    EXPECT_EQ(result.escaped, 0) << "of " << result.casts << "; farthest " << result.worst;
    EXPECT_GT(result.casts, 49'000);
    EXPECT_GT(result.contacts, 20'000);
}

// Walls of no thickness at all, and so thin that a fast stone passes them in a millionth of a tick.
TEST(CastEscape, NoStoneLeavesABoxWithThinWalls) {
    TestScene scene;
    const glm::vec3 half(4.0f, 1.5f, 2.5f);
    scene.add(make_box(-half, half));
    scene.add(make_box(-half - 0.001f, half + 0.001f));
    scene.commit();
    const auto outside = [&](const glm::vec3& p) {
        const glm::vec3 beyond = glm::abs(p) - half;
        return std::max({beyond.x, beyond.y, beyond.z});
    };
    const Escapes result = throw_balls(scene, 2, glm::vec3(0.0f), 1.2f, 2e-6f, outside);
    EXPECT_EQ(result.escaped, 0) << "of " << result.casts << "; farthest " << result.worst;
    EXPECT_GT(result.casts, 49'000);
    EXPECT_GT(result.contacts, 20'000);
}

TEST(CastEscape, NoStoneLeavesABoxTenKilometresAway) {
    TestScene scene;
    const glm::vec3 half(4.0f, 1.5f, 2.5f), centre(1e4f, 20.0f, -1e4f);
    scene.add(make_box(-half, half),
              glm::mat4x3(glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), centre));
    scene.commit();
    const auto outside = [&](const glm::vec3& p) {
        const glm::vec3 beyond = glm::abs(p - centre) - half;
        return std::max({beyond.x, beyond.y, beyond.z});
    };
    const Escapes result =
        throw_balls(scene, 3, centre, 1.2f, 2e-3f, outside);  // a float's step is 1 mm there
    EXPECT_EQ(result.escaped, 0) << "of " << result.casts << "; farthest " << result.worst;
    EXPECT_GT(result.contacts, 20'000);
}

TEST(CastEscape, NoCharacterLeavesABoxLyingDownOrStanding) {
    TestScene scene;
    const glm::vec3 half(4.0f, 1.5f, 2.5f);
    scene.add(make_box(-half, half));
    scene.commit();
    const glm::vec3 axes[] = {{0, 1.2f, 0}, {0.9f, 0, 0}, {0.3f, -0.5f, 0.4f}};
    glm::vec3 axis = axes[0];
    int turn = 0;
    // The far end of the axis is as much inside as the near one.
    const auto outside = [&](const glm::vec3& p) {
        const glm::vec3 beyond = glm::max(glm::abs(p), glm::abs(p + axis)) - half;
        return std::max({beyond.x, beyond.y, beyond.z});
    };
    Escapes sum;
    for (const glm::vec3& a : axes) {
        axis = a;
        const Escapes result = throw_stones(
            static_cast<std::uint64_t>(4 + turn++), -0.5f * axis, 0.5f, 2e-6f,
            [&](const glm::vec3& at, float radius, const glm::vec3& way) {
                return rc::capsule_cast(scene.scene(), {at, at + axis}, radius, way, rc::kAllLayers);
            },
            outside);
        EXPECT_EQ(result.escaped, 0) << "of " << result.casts << "; farthest " << result.worst;
        sum.contacts += result.contacts;
    }
    EXPECT_GT(sum.contacts, 60'000);
}

}  // namespace
}  // namespace test

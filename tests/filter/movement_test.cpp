// How far each pixel came, and which of them moved by themselves: a mean that is looked for elsewhere is another pixel's,
// and a guard whose light nobody tells of is found by that he moves.
#include "filter/movement.h"

#include "filter/isa.h"
#include "filter/reproject.h"
#include "filter/wall.h"

#include <gtest/gtest.h>

#include <utility>

namespace gh {
namespace {

using filter::Movement;
using test::lens_at, test::on_wall;

constexpr int kAcross = 70, kDown = 12;
constexpr std::uint32_t kWall = 7;
constexpr int kThingFrom = 33, kThingTo = 40;  // columns of a thing in row kThingRow
constexpr int kThingRow = 5, kSkyRow = 9, kBehindRow = 2;

// A wall of which one thing moved by itself, two pixels to the right, a row of sky, and one that came from behind the eye.
filter::GBuffer seen(const filter::Pinhole& lens) {
    filter::GBuffer surfaces;
    surfaces.lens = lens;
    surfaces.fit(kAcross, kDown);
    surfaces.previous.fit(kAcross, kDown);
    for (int y = 0; y < kDown; ++y) {
        for (int x = 0; x < kAcross; ++x) {
            const glm::vec3 p = on_wall(lens, glm::vec2(x, y) + 0.3f);
            const bool is_thing = y == kThingRow && x >= kThingFrom && x < kThingTo;
            surfaces.part.at(x, y) = y == kSkyRow ? filter::kNoSurface : kWall;
            surfaces.position.set(x, y, y == kSkyRow ? glm::vec3(0.0f) : p);
            surfaces.normal.set(x, y, {0, 0, 1});
            glm::vec3 previous = is_thing ? p - 2.0f * lens.right : p * (1.0f + 1e-6f);  // rounding
            if (y == kBehindRow) previous.z = 1.0f;
            surfaces.previous.set(x, y, y == kSkyRow ? glm::vec3(0.0f) : previous);
        }
    }
    return surfaces;
}

// The eye has gone three pixels to the right; the sky does not follow it.
filter::Pinhole lens_before() {
    return lens_at({0, 0}, kAcross, kDown);
}
filter::GBuffer now() {
    const filter::Pinhole before = lens_before();
    return seen(lens_at(glm::vec2(3.0f * before.right.x, 0.0f), kAcross, kDown));
}

Movement found(int threads = 1) {
    Movement movement;
    const filter::GBuffer surfaces = now();
    filter::run_rows(kDown, Jobs(threads),
                     movement_rows(surfaces, lens_before(), {kAcross, kDown}, movement));
    return movement;
}

TEST(Movement, FollowsTheEyeTheThingsAndTheSky) {
    const Movement movement = found();
    for (int y = 0; y < kDown; ++y) {
        for (int x = 0; x < kAcross; ++x) {
            const bool is_thing = y == kThingRow && x >= kThingFrom && x < kThingTo;
            const float along = y == kSkyRow      ? 0.0f
                                : y == kBehindRow ? Movement::kUnseen
                                : is_thing        ? 1.0f
                                                  : 3.0f;
            ASSERT_EQ(movement.x.at(x, y), along) << x << ' ' << y;
            ASSERT_EQ(movement.y.at(x, y), y == kBehindRow ? Movement::kUnseen : 0.0f) << x << ' ' << y;
        }
    }
}

TEST(Movement, TellsWhatMovedByItselfFromWhatTheEyeWalksPast) {
    const Movement movement = found();
    for (int y = 0; y < kDown; ++y) {
        const filter::RowSpan span = movement.itself[static_cast<std::size_t>(y)];
        const int begin = y == kThingRow ? 32 : 0, end = y == kThingRow ? 48 : y == kBehindRow ? 80 : 0;
        EXPECT_EQ(span.begin, begin) << y;
        EXPECT_EQ(span.end, end) << y;
    }
}

TEST(Movement, IsTheSameByTheWayWithAnyThreadsOnAnyInstructionSet) {
    const Movement plain = found();
    for (const std::string& isa : filter::isa_names()) {
        ASSERT_TRUE(filter::use_isa(isa));
        const filter::GBuffer surfaces = now(), last = seen(lens_before());
        filter::SeenSurfaces before{lens_before(), {}, last.part};
        filter::Guides guides;
        filter::make_guides(last, Jobs(1), before.guides);
        filter::make_guides(surfaces, Jobs(1), guides);
        filter::Taps taps;
        Movement by_the_way;
        filter::run_rows(
            kDown, Jobs(3),
            reproject_rows(surfaces, guides, before, filter::Motion::OfSurface, taps, &by_the_way));
        const Movement alone = found(3);
        for (const Movement* other : {&std::as_const(by_the_way), &alone}) {
            for (int y = 0; y < kDown; ++y) {
                const auto line = static_cast<std::size_t>(y);
                EXPECT_EQ(other->itself[line].begin, plain.itself[line].begin) << isa;
                EXPECT_EQ(other->itself[line].end, plain.itself[line].end) << isa;
                for (int x = 0; x < kAcross; ++x) {
                    ASSERT_EQ(other->x.at(x, y), plain.x.at(x, y)) << isa;
                    ASSERT_EQ(other->y.at(x, y), plain.y.at(x, y)) << isa;
                }
            }
        }
    }
    ASSERT_TRUE(filter::use_isa(""));
}

}  // namespace
}  // namespace gh

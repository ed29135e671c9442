// Geometry that collapses, flies away, turns inside out or vanishes for a tick: the refitted tree answers every question
// as one built anew does, for every quality of tree.
#include "support/isas.h"

#include "raycore/bodies.h"
#include "raycore/every_way.h"

#include <cmath>
#include <functional>
#include <limits>

namespace test {
namespace {

using Move = std::function<glm::vec3(const glm::vec3&)>;

struct Fate {
    const char* name;
    Move move;
    glm::vec3 centre;  // where it is then
    float half;
    bool is_met;  // whether most rays meet it
};

std::vector<Fate> fates() {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    return {
        {"stays", [](const glm::vec3& p) { return p; }, glm::vec3(0), 2, true},
        {"collapses to a point", [](const glm::vec3&) { return glm::vec3(0.5f); }, glm::vec3(0.5f), 1, false},
        {"collapses to a line", [](const glm::vec3& p) { return glm::vec3(p.x, 0, 0); }, glm::vec3(0), 2,
         false},
        {"is pressed flat", [](const glm::vec3& p) { return glm::vec3(p.x, 0, p.z); }, glm::vec3(0), 2, true},
        {"flies a thousand kilometres", [](const glm::vec3& p) { return p + glm::vec3(1e6f, -1e6f, 0); },
         glm::vec3(1e6f, -1e6f, 0), 2, true},
        {"shrinks to 1e-30", [](const glm::vec3& p) { return p * 1e-30f; }, glm::vec3(0), 2e-30f, true},
        {"grows to 1e15", [](const glm::vec3& p) { return p * 1e15f; }, glm::vec3(0), 2e15f, true},
        {"turns inside out", [](const glm::vec3& p) { return -p; }, glm::vec3(0), 2, true},
        {"is scattered",
         [](const glm::vec3& p) {
             const float s = p.x * 12.9898f + p.y * 78.233f + p.z * 37.719f;
             return 3.0f *
                    glm::vec3(s - std::floor(s), 7 * s - std::floor(7 * s), 13 * s - std::floor(13 * s));
         },
         glm::vec3(1.5f), 2, true},
        {"half of it is NaN", [](const glm::vec3& p) { return p.y > 0 ? glm::vec3(kNan) : p; }, glm::vec3(0),
         2, true},
        {"leaves every range", [](const glm::vec3& p) { return p * 1e30f; }, glm::vec3(0), 2, false},
    };
}

class HardRefit : public ::testing::TestWithParam<rc::BuildQuality> {};

std::shared_ptr<const rc::Scene> scene_of(std::shared_ptr<const rc::Blas> blas) {
    rc::SceneBuilder builder;
    builder.add({std::move(blas)});
    return builder.commit();
}

// Rays through every way of asking, then bodies; how many rays met.
int expect_same_answers(const rc::Scene& refitted, const rc::Scene& anew, const Mesh& mesh,
                        const Fate& fate) {
    Random random(101);
    const std::vector<rc::Ray> rays = searching_rays(random, mesh, fate.centre, fate.half, 400);
    int met = 0;
    std::vector<rc::Hit> a(rays.size()), b(rays.size());
    std::vector<std::uint8_t> any(rays.size());
    for (const rc::Isa isa : supported_isas()) {
        const IsaScope scope(isa);
        rc::closest_hits(refitted, rays, rc::kAllLayers, a);
        rc::closest_hits(anew, rays, rc::kAllLayers, b);
        rc::any_hits(refitted, rays, rc::kAllLayers, any);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            EXPECT_TRUE(same_bits(a[i], b[i])) << fate.name << ", ray " << i << " on " << rc::isa_name(isa);
            EXPECT_EQ(any[i] != 0, !b[i].is_miss()) << fate.name;
            met += !b[i].is_miss();
        }
    }
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 from = fate.centre + random.in_cube(fate.half), way = random.in_cube(fate.half);
        const auto x = rc::sphere_cast(refitted, from, 0.05f * fate.half, way, rc::kAllLayers),
                   y = rc::sphere_cast(anew, from, 0.05f * fate.half, way, rc::kAllLayers);
        EXPECT_EQ(x.has_value(), y.has_value()) << fate.name;
        if (x && y) {
            EXPECT_TRUE(x->t == y->t && x->primitive == y->primitive && x->point == y->point) << fate.name;
        }
        const auto p = rc::closest_point(refitted, from, rc::kInfinity, rc::kAllLayers),
                   q = rc::closest_point(anew, from, rc::kInfinity, rc::kAllLayers);
        EXPECT_EQ(p.has_value(), q.has_value()) << fate.name;
        if (p && q) {
            EXPECT_TRUE(p->distance == q->distance && p->primitive == q->primitive) << fate.name;
        }
    }
    return met;
}

TEST_P(HardRefit, AnswersEveryQuestionAsATreeBuiltAnew) {
    Mesh mesh = make_ball(glm::vec3(0.0f), 1.5f, 6);
    append(mesh, make_box(glm::vec3(-1.9f, -1, -1), glm::vec3(-1.6f, 1, 1)));
    append(mesh, make_sheet(1.9f, -1.2f, 3));
    const auto blas = rc::build_blas(mesh.view(), {GetParam(), true});
    std::vector<Fate> all = fates();
    all.push_back(all.front());  // and back again, in one tree, one after the other
    for (const Fate& fate : all) {
        Mesh moved = mesh;
        for (glm::vec3& p : moved.positions) p = fate.move(p);
        rc::refit_blas(*blas, moved.positions);
        const auto refitted = scene_of(blas), anew = scene_of(rc::build_blas(moved.view(), {GetParam()}));
        const int met = expect_same_answers(*refitted, *anew, moved, fate);
        if (fate.is_met) {
            EXPECT_GT(met, 100) << fate.name;
        } else {
            EXPECT_EQ(met, 0) << fate.name;
        }
        EXPECT_TRUE(std::isfinite(blas->sah_cost())) << fate.name;
        EXPECT_FALSE(std::isnan(blas->refit_degradation())) << fate.name;
    }
}

INSTANTIATE_TEST_SUITE_P(EveryQuality, HardRefit, ::testing::ValuesIn(kQualities), quality_test_name);

}  // namespace
}  // namespace test

// Casts, overlaps and closest points in scenes chosen to break a tree: each answer is, in every bit, the best of what
// every triangle answers when it is alone in the world.
#include "raycore/bodies.h"
#include "raycore/every_way.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace test {
namespace {

constexpr rc::LayerMask kAll = rc::kAllLayers;

// A world, and each of its triangles alone.
class Bodies {
  public:
    explicit Bodies(rc::BuildQuality quality) : quality_(quality) {}

    void add(const Mesh& mesh, const glm::mat4x3& m = glm::mat4x3(1.0f)) {
        const std::uint32_t instance = builder_.add({rc::build_blas(mesh.view(), {quality_}), m});
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            const glm::uvec3& t = mesh.triangles[i];
            if (std::max({t.x, t.y, t.z}) >= mesh.positions.size()) continue;
            if (rc::check_mesh({mesh.positions, std::span(&t, 1)}).kept() == 0) continue;
            Mesh alone{{}, {{0, 1, 2}}};
            for (const std::uint32_t v : {t.x, t.y, t.z}) {
                const glm::vec3& p = mesh.positions[v];
                alone.positions.push_back(((m[0] * p.x + m[1] * p.y) + m[2] * p.z) + m[3]);
            }
            rc::SceneBuilder builder;
            builder.add({rc::build_blas(alone.view())});
            alone_.push_back({builder.commit(), instance, i});
        }
    }
    void commit() { scene_ = builder_.commit(); }

    struct Met {
        int casts = 0, overlaps = 0, nearest = 0;
    };
    // Balls and capsules about `half` / 10 large, thrown through a cube about `centre`.
    Met ask(const glm::vec3& centre, float half, int count) {
        Random random(95);
        Met met;
        for (int i = 0; i < count; ++i) {
            SCOPED_TRACE(i);
            const float radius = i % 5 == 0 ? 0.0f : half * random.between(0.001f, 0.2f);
            const glm::vec3 from = centre + random.in_cube(half), way = random.in_cube(half);
            const rc::Segment axis{from, from + random.in_cube(0.3f * half)};
            met.casts += expect_cast(axis, radius, way);
            met.casts += expect_cast({from, from}, radius, i % 7 == 0 ? glm::vec3(0.0f) : way);
            met.overlaps += expect_overlaps(axis, radius, random);
            met.nearest += expect_nearest(from, i % 3 == 0 ? 0.3f * half : rc::kInfinity);
            if (::testing::Test::HasFailure()) break;
        }
        return met;
    }

  private:
    struct Alone {
        std::shared_ptr<const rc::Scene> scene;
        std::uint32_t instance, primitive;
    };

    static void expect_same(const rc::CastHit& got, const rc::CastHit& want) {
        EXPECT_EQ(std::tie(got.instance, got.primitive), std::tie(want.instance, want.primitive));
        EXPECT_EQ(got.t, want.t);
        EXPECT_EQ(got.depth, want.depth);
        EXPECT_EQ(got.point, want.point);
        EXPECT_EQ(got.normal, want.normal);
    }

    bool expect_cast(const rc::Segment& axis, float radius, const glm::vec3& way) const {
        const bool is_ball = axis.from == axis.to;
        const auto cast = [&](const rc::Scene& scene) {
            return is_ball ? rc::sphere_cast(scene, axis.from, radius, way, kAll)
                           : rc::capsule_cast(scene, axis, radius, way, kAll);
        };
        std::optional<rc::CastHit> best;
        for (const Alone& alone : alone_) {
            std::optional<rc::CastHit> hit = cast(*alone.scene);
            if (!hit) continue;
            hit->instance = alone.instance;
            hit->primitive = alone.primitive;
            const auto key = [](const rc::CastHit& h) { return std::tie(h.t, h.instance, h.primitive); };
            if (!best || key(*hit) < key(*best)) best = hit;
        }
        const std::optional<rc::CastHit> got = cast(*scene_);
        EXPECT_EQ(got.has_value(), best.has_value())
            << (is_ball ? "ball" : "capsule") << " of radius " << radius;
        if (got && best) expect_same(*got, *best);
        rc::CastHit batched;
        if (is_ball) {
            const rc::SphereCast one{axis.from, radius, way};
            rc::sphere_casts(*scene_, std::span(&one, 1), kAll, std::span(&batched, 1));
        } else {
            const rc::CapsuleCast one{axis, radius, way};
            rc::capsule_casts(*scene_, std::span(&one, 1), kAll, std::span(&batched, 1));
        }
        expect_same(batched, got.value_or(rc::CastHit{}));
        return got.has_value();
    }

    // Every contact, deepest first, by `ask(scene, out)`.
    template <class Ask>
    bool expect_all(const char* what, Ask&& ask) const {
        SCOPED_TRACE(what);
        std::vector<rc::CastHit> want, got(alone_.size() + 1);
        for (const Alone& alone : alone_) {
            rc::CastHit hit;
            if (ask(*alone.scene, std::span(&hit, 1)) == 0) continue;
            hit.instance = alone.instance;
            hit.primitive = alone.primitive;
            want.push_back(hit);
        }
        std::sort(want.begin(), want.end(), [](const rc::CastHit& a, const rc::CastHit& b) {
            return std::tuple(-a.depth, a.instance, a.primitive) <
                   std::tuple(-b.depth, b.instance, b.primitive);
        });
        got.resize(ask(*scene_, std::span(got)));
        EXPECT_EQ(got.size(), want.size());
        for (std::size_t k = 0; k < std::min(got.size(), want.size()); ++k) expect_same(got[k], want[k]);
        return !got.empty();
    }

    bool expect_overlaps(const rc::Segment& axis, float radius, Random& random) const {
        const glm::vec3 x = random.direction(), y = glm::normalize(glm::cross(x, random.direction()));
        const rc::OrientedBox box{axis.from, glm::abs(axis.to - axis.from), {x, y, glm::cross(x, y)}};
        const bool ball = expect_all("ball", [&](const rc::Scene& s, std::span<rc::CastHit> out) {
            return rc::sphere_overlaps(s, axis.from, radius, kAll, out);
        });
        const bool capsule = expect_all("capsule", [&](const rc::Scene& s, std::span<rc::CastHit> out) {
            return rc::capsule_overlaps(s, axis, radius, kAll, out);
        });
        const bool crate = expect_all("box", [&](const rc::Scene& s, std::span<rc::CastHit> out) {
            return rc::box_overlaps(s, box, kAll, out);
        });
        return ball || capsule || crate;
    }

    bool expect_nearest(const glm::vec3& point, float limit) const {
        rc::Nearest want;
        for (const Alone& alone : alone_) {
            std::optional<rc::Nearest> near = rc::closest_point(*alone.scene, point, limit, kAll);
            if (!near) continue;
            near->instance = alone.instance;
            near->primitive = alone.primitive;
            const auto key = [](const rc::Nearest& n) {
                return std::tie(n.distance, n.instance, n.primitive);
            };
            if (key(*near) < key(want)) want = *near;
        }
        const rc::Nearest got = rc::closest_point(*scene_, point, limit, kAll).value_or(rc::Nearest{});
        EXPECT_EQ(got.distance, want.distance) << "nearest, within " << limit;
        EXPECT_EQ(std::tie(got.instance, got.primitive), std::tie(want.instance, want.primitive));
        EXPECT_EQ(got.point, want.point);
        EXPECT_EQ(got.normal, want.normal);
        return !got.is_none();
    }

    rc::BuildQuality quality_;
    rc::SceneBuilder builder_;
    std::vector<Alone> alone_;
    std::shared_ptr<const rc::Scene> scene_;
};

class HardBodies : public ::testing::TestWithParam<rc::BuildQuality> {
  protected:
    Bodies bodies_{GetParam()};

    void ask(const glm::vec3& centre, float half, int count, int least_casts, int least_overlaps) {
        bodies_.commit();
        const Bodies::Met met = bodies_.ask(centre, half, count);
        EXPECT_GE(met.casts, least_casts);
        EXPECT_GE(met.overlaps, least_overlaps);
        EXPECT_GT(met.nearest, count / 2);
    }
};

TEST_P(HardBodies, AmongSliversAMillionTimesLongerThanWide) {
    Random random(1);
    Mesh mesh;
    for (std::uint32_t i = 0; i < 120; ++i) {
        const glm::vec3 a = random.in_cube(1.0f);
        mesh.positions.insert(mesh.positions.end(),
                              {a, a + random.direction(), a + random.direction() * 1e-6f});
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    bodies_.add(mesh);
    ask(glm::vec3(0.0f), 1.5f, 60, 30, 10);
}

TEST_P(HardBodies, FromATenthOfAMillimetreToAThousandKilometres) {
    Random random(2);
    Mesh mesh = make_soup(random, 20, 1e6f, 4e5f);
    append(mesh, make_soup(random, 60, 1e-3f, 1e-4f));
    append(mesh, make_ball(glm::vec3(0.0f), 1.0f, 2));
    bodies_.add(mesh);
    ask(glm::vec3(0.0f), 1e-3f, 30, 5, 3);
    ask(glm::vec3(0.0f), 1.0f, 30, 10, 3);
    ask(glm::vec3(0.0f), 1e6f, 30, 10, 3);
}

TEST_P(HardBodies, AmongDuplicatesSeamsAndBoxesInTheirPlane) {
    Mesh mesh = make_sheet(2.0f, 0.0f, 3);
    append(mesh, make_sheet(2.0f, 0.0f, 3));
    append(mesh, make_box(glm::vec3(-1), glm::vec3(1, 0, 1)));
    bodies_.add(mesh);
    bodies_.add(mesh);
    ask(glm::vec3(0.0f), 2.0f, 60, 30, 10);
}

TEST_P(HardBodies, AmongMirroredShearedSqueezedAndVanishedInstances) {
    const Mesh ball = make_ball({0.2f, 0, 0}, 1.0f, 2);
    for (const glm::mat4x3& place :
         {glm::mat4x3(-1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0), glm::mat4x3(1, 5, 0, 0, 1, 0, -7, 0, 1, -2, 0, 0),
          glm::mat4x3(30, 0, 0, 0, 0.01f, 0, 0, 0, 1, 0, 1, 0),
          glm::mat4x3(0.6f, 0.8f, 0, -0.8f, 0.6f, 0, 0, 0, 1, 0, 0, 2)})
        bodies_.add(ball, place);
    ask(glm::vec3(0.0f), 3.0f, 60, 40, 20);
}

TEST_P(HardBodies, FarFromTheOriginAndVerySmall) {
    const Mesh ball = make_ball(glm::vec3(0.0f), 1.0f, 3);
    bodies_.add(ball, glm::mat4x3(1, 0, 0, 0, 1, 0, 0, 0, 1, 1e6f, -1e6f, 1e5f));
    bodies_.add(ball, glm::mat4x3(1e-6f, 0, 0, 0, 1e-6f, 0, 0, 0, 1e-6f, 0, 0, 0));
    ask({1e6f, -1e6f, 1e5f}, 1.5f, 40, 10, 5);
    ask(glm::vec3(0.0f), 1.5e-6f, 40, 10, 5);
}

TEST_P(HardBodies, InASpiralThatTemptsTheTreeToBeDeep) {
    Mesh spiral;
    for (std::uint32_t i = 0; i < 200; ++i) {
        const float x =
            std::ldexp(1.0f + 1e-3f * static_cast<float>(i / 100), static_cast<int>(i % 100) - 50);
        spiral.positions.insert(spiral.positions.end(),
                                {{x, 0, 0}, {1.4f * x, 0, 0.1f * x}, {x, 0.5f * x, 0.3f * x}});
        spiral.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    bodies_.add(spiral);
    ask({1.0f, 0.3f, 0.1f}, 0.5f, 60, 10, 3);
}

TEST_P(HardBodies, AmongBadVertices) {
    Random random(7);
    Mesh mesh = make_soup(random, 100, 1.5f, 1.0f);
    constexpr float kBad[] = {std::numeric_limits<float>::quiet_NaN(), rc::kInfinity, -rc::kInfinity, 1e30f};
    for (std::uint32_t i = 0; i < 40; ++i) mesh.positions[random.below(300)][random.below(3)] = kBad[i % 4];
    bodies_.add(mesh);
    ask(glm::vec3(0.0f), 2.0f, 60, 40, 20);
}

INSTANTIATE_TEST_SUITE_P(EveryQuality, HardBodies, ::testing::ValuesIn(kQualities), quality_test_name);

}  // namespace
}  // namespace test

#include "raycore/every_way.h"

#include "support/isas.h"

#include <algorithm>
#include <cmath>

namespace test {

namespace {

using Truth = std::vector<std::vector<rc::Hit>>;  // all hits of each ray, in order

rc::Hit first_of(const std::vector<rc::Hit>& hits) {
    return hits.empty() ? rc::Hit{} : hits.front();
}

bool is_segment(const rc::Ray& ray) {
    return ray.t_min == 0.0f && ray.t_max == 1.0f && ray.skip_primitive == rc::kNone;
}

void expect_single(const rc::Scene& scene, std::span<const rc::Ray> rays, const Truth& truth,
                   rc::LayerMask layers) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto closest = rc::closest_hit(scene, rays[i], layers);
        ASSERT_TRUE(same_bits(closest.value_or(rc::Hit{}), first_of(truth[i]))) << "closest, ray " << i;
        ASSERT_EQ(rc::any_hit(scene, rays[i], layers), !truth[i].empty()) << "any, ray " << i;
    }
}

void expect_batches(const rc::Scene& scene, std::span<const rc::Ray> rays, const Truth& truth,
                    std::size_t size, rc::LayerMask layers) {
    std::vector<rc::Hit> hits(size);
    std::vector<std::uint8_t> any(size);
    for (std::size_t begin = 0; begin < rays.size(); begin += size) {
        const std::size_t n = std::min(size, rays.size() - begin);
        rc::closest_hits(scene, rays.subspan(begin, n), layers, std::span(hits).first(n));
        rc::any_hits(scene, rays.subspan(begin, n), layers, std::span(any).first(n));
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_TRUE(same_bits(hits[i], first_of(truth[begin + i])))
                << "closest, ray " << begin + i << " in a batch of " << n;
            ASSERT_EQ(any[i] != 0, !truth[begin + i].empty())
                << "any, ray " << begin + i << " in a batch of " << n;
        }
    }
}

// What lies between two points is the ray's answer for t in [0, 1]: to + from may round, so `from + direction` is asked
// for only where it gives the direction back.
void expect_crossings(const rc::Scene& scene, std::span<const rc::Ray> rays, const Truth& truth,
                      rc::LayerMask layers) {
    std::vector<rc::Hit> out(512);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const glm::vec3 to = rays[i].origin + rays[i].direction;
        if (!is_segment(rays[i]) || to - rays[i].origin != rays[i].direction) continue;
        for (const std::size_t capacity : {std::size_t{0}, std::size_t{1}, std::size_t{3}, out.size()}) {
            const std::size_t count =
                rc::crossings(scene, rays[i].origin, to, layers, std::span(out).first(capacity));
            ASSERT_EQ(count, std::min(capacity, truth[i].size())) << "crossings, ray " << i;
            for (std::size_t k = 0; k < count; ++k)
                ASSERT_TRUE(same_bits(out[k], truth[i][k])) << "crossing " << k << " of ray " << i;
        }
    }
}

}  // namespace

std::string quality_test_name(const ::testing::TestParamInfo<rc::BuildQuality>& info) {
    switch (info.param) {
        case rc::BuildQuality::Fast:
            return "fast";
        case rc::BuildQuality::Default:
            return "default";
        case rc::BuildQuality::High:
            return "high";
    }
    return "unknown";
}

int expect_every_way(const TestScene& scene, std::span<const rc::Ray> rays, const char* what,
                     rc::LayerMask layers) {
    Truth truth;
    int met = 0;
    for (const rc::Ray& ray : rays) {
        truth.push_back(scene.all_hits(ray, layers));
        met += !truth.back().empty();
    }
    for (const rc::Isa isa : supported_isas()) {
        const IsaScope scope(isa);
        SCOPED_TRACE(std::string(what) + " on " + std::string(rc::isa_name(isa)));
        expect_single(scene.scene(), rays, truth, layers);
        for (const std::size_t size : {3u, 16u, 64u, 1000u})
            expect_batches(scene.scene(), rays, truth, size, layers);
        expect_crossings(scene.scene(), rays, truth, layers);
    }
    return met;
}

std::vector<rc::Ray> searching_rays(Random& random, const Mesh& mesh, const glm::vec3& centre, float half,
                                    int count) {
    std::vector<rc::Ray> rays;
    for (int i = 0; static_cast<int>(rays.size()) < count && i < 8 * count; ++i) {
        const auto a_vertex = [&] {
            return mesh.positions[random.below(static_cast<std::uint32_t>(mesh.positions.size()))];
        };
        rc::Ray ray{.origin = centre + random.in_cube(half), .direction = random.direction()};
        if (i % 2 == 0) ray.direction = a_vertex() - ray.origin;
        if (i % 4 == 1) ray.direction = centre + random.in_cube(half) - ray.origin, ray.t_max = 1.0f;
        if (i % 5 == 0) {  // along an axis, zeros of both signs, through a vertex
            const std::size_t axis = random.below(3);
            ray.direction = glm::vec3(random.below(2) ? 0.0f : -0.0f);
            ray.direction[axis] = random.below(2) ? half : -half;
            ray.origin = a_vertex();
            ray.origin[axis] -= 2.0f * ray.direction[axis];
        }
        if (i % 7 == 0) ray.origin = a_vertex();  // on the surface itself
        if (i % 9 == 0) ray.t_min = -rc::kInfinity;
        if (i % 13 == 0) ray.direction *= 1e-30f;
        if (i % 17 == 0) ray.direction *= 1e18f;
        const bool is_finite = std::isfinite(ray.origin.x + ray.origin.y + ray.origin.z) &&
                               std::isfinite(ray.direction.x + ray.direction.y + ray.direction.z);
        if (is_finite && ray.direction != glm::vec3(0.0f)) rays.push_back(ray);  // else: a bad vertex, or underflow
    }
    return rays;
}

}  // namespace test

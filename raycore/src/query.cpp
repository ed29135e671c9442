#include "raycore/query.h"

#include "contract.h"
#include "data.h"
#include "dispatch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rc {

namespace {

static_assert(sizeof(kernel::RayIn) == sizeof(Ray) &&
              offsetof(kernel::RayIn, t_min) == offsetof(Ray, t_min) &&
              offsetof(kernel::RayIn, skip_primitive) == offsetof(Ray, skip_primitive));
static_assert(sizeof(kernel::HitOut) == sizeof(Hit) &&
              offsetof(kernel::HitOut, instance) == offsetof(Hit, instance));

const kernel::RayIn* abi(const Ray* rays) {
    return reinterpret_cast<const kernel::RayIn*>(rays);
}
kernel::HitOut* abi(Hit* hits) {
    return reinterpret_cast<kernel::HitOut*>(hits);
}
const kernel::HitOut* abi(const Hit* hits) {
    return reinterpret_cast<const kernel::HitOut*>(hits);
}

#ifdef RC_CONTRACTS
bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void expect_good(const Ray& ray) {
    RC_EXPECTS(is_finite(ray.origin), "a finite ray origin");
    RC_EXPECTS(is_finite(ray.direction) && ray.direction != glm::vec3(0.0f),
               "a finite ray direction that is not zero");
    RC_EXPECTS(ray.t_min <= ray.t_max, "t_min <= t_max, neither NaN");
}
void expect_good(std::span<const Ray> rays) {
    for (const Ray& ray : rays) expect_good(ray);
}
#else
void expect_good(const Ray&) {}
void expect_good(std::span<const Ray>) {}
#endif

void add(Counters* counters, const kernel::Counts& counts, std::size_t rays) {
    if (counters != nullptr) *counters += {rays, counts.instances, counts.nodes, counts.leaves};
}

Ray ray_between(const glm::vec3& from, const glm::vec3& to) {
    return {.origin = from, .direction = to - from, .t_min = 0.0f, .t_max = 1.0f};
}

}  // namespace

std::optional<Hit> closest_hit(const Scene& scene, const Ray& ray, LayerMask layers) {
    expect_good(ray);
    // Written where it is returned: a copy would wait for the kernel's stores.
    std::optional<Hit> hit(std::in_place);
    active_kernels().closest(scene.data().view, abi(&ray), 1, layers, abi(&*hit), nullptr);
    if (hit->is_miss()) hit.reset();
    return hit;
}

bool any_hit(const Scene& scene, const Ray& ray, LayerMask layers) {
    expect_good(ray);
    std::uint8_t is_hit = 0;
    active_kernels().any(scene.data().view, abi(&ray), 1, layers, &is_hit, nullptr);
    return is_hit != 0;
}

namespace {

std::size_t ask_crossings(const Scene& scene, const glm::vec3& from, const glm::vec3& to, LayerMask layers,
                          const Hit* after, std::span<Hit> out) {
    const Ray ray = ray_between(from, to);
    expect_good(ray);
    constexpr std::size_t kMost = 0xFFFFFFFFu;
    return active_kernels().crossings(scene.data().view, *abi(&ray), layers, abi(after), abi(out.data()),
                                      static_cast<std::uint32_t>(std::min(out.size(), kMost)));
}

}  // namespace

std::size_t crossings(const Scene& scene, const glm::vec3& from, const glm::vec3& to, LayerMask layers,
                      std::span<Hit> out) {
    return ask_crossings(scene, from, to, layers, nullptr, out);
}

std::size_t crossings_after(const Scene& scene, const glm::vec3& from, const glm::vec3& to, LayerMask layers,
                            const Hit& last, std::span<Hit> out) {
    if (last.is_miss()) return 0;
    return ask_crossings(scene, from, to, layers, &last, out);
}

void closest_hits(const Scene& scene, std::span<const Ray> rays, LayerMask layers, std::span<Hit> hits,
                  Counters* counters) {
    RC_EXPECTS(rays.size() == hits.size(), "a hit for every ray");
    expect_good(rays);
    kernel::Counts counts;
    active_kernels().closest(scene.data().view, abi(rays.data()), rays.size(), layers, abi(hits.data()),
                             &counts);
    add(counters, counts, rays.size());
}

void any_hits(const Scene& scene, std::span<const Ray> rays, LayerMask layers, std::span<std::uint8_t> is_hit,
              Counters* counters) {
    RC_EXPECTS(rays.size() == is_hit.size(), "an answer for every ray");
    expect_good(rays);
    kernel::Counts counts;
    active_kernels().any(scene.data().view, abi(rays.data()), rays.size(), layers, is_hit.data(), &counts);
    add(counters, counts, rays.size());
}

void crossings(const Scene& scene, std::span<const Segment> segments, LayerMask layers, std::size_t capacity,
               std::span<Hit> out, std::span<std::uint32_t> counts) {
    RC_EXPECTS(counts.size() == segments.size() && out.size() == segments.size() * capacity,
               "a count for every segment and room for its hits");
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const std::span<Hit> hits = out.subspan(i * capacity, capacity);
        counts[i] =
            static_cast<std::uint32_t>(crossings(scene, segments[i].from, segments[i].to, layers, hits));
    }
}

}  // namespace rc

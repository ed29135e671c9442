#include "ray_check.h"

#include "support/brute_force.h"

#include "raycore/isa.h"

#include <algorithm>
#include <tuple>

namespace fuzz {

namespace {

constexpr rc::BuildQuality kQualities[] = {rc::BuildQuality::Fast, rc::BuildQuality::Default,
                                           rc::BuildQuality::High};
constexpr rc::Isa kIsas[] = {rc::Isa::Scalar, rc::Isa::Avx2, rc::Isa::Avx512};
constexpr std::size_t kCapacity = 6;

using Truth = std::vector<std::vector<rc::Hit>>;

rc::Hit first_of(const std::vector<rc::Hit>& hits) {
    return hits.empty() ? rc::Hit{} : hits.front();
}

std::string at(const char* what, std::size_t i) {
    return std::string(what) + " " + std::to_string(i);
}

std::string check_rays(const rc::Scene& scene, const World& world, const Truth& truth) {
    const std::size_t n = world.rays.size();
    std::vector<rc::Hit> hits(n), crossed(kCapacity);
    std::vector<std::uint8_t> any(n);
    rc::closest_hits(scene, world.rays, world.layers, hits);
    rc::any_hits(scene, world.rays, world.layers, any);
    for (std::size_t i = 0; i < n; ++i) {
        const rc::Ray& ray = world.rays[i];
        const rc::Hit want = first_of(truth[i]);
        if (!test::same_bits(hits[i], want)) return at("closest of a batch, ray", i);
        if ((any[i] != 0) != !want.is_miss()) return at("any of a batch, ray", i);
        if (!test::same_bits(rc::closest_hit(scene, ray, world.layers).value_or(rc::Hit{}), want))
            return at("closest alone, ray", i);
        if (rc::any_hit(scene, ray, world.layers) == want.is_miss()) return at("any alone, ray", i);
        const glm::vec3 to = ray.origin + ray.direction;
        const bool is_segment = ray.t_min == 0.0f && ray.t_max == 1.0f && ray.skip_primitive == rc::kNone;
        if (!is_segment || to - ray.origin != ray.direction) continue;
        const std::size_t count = rc::crossings(scene, ray.origin, to, world.layers, crossed);
        if (count != std::min(kCapacity, truth[i].size())) return at("number of crossings, ray", i);
        for (std::size_t k = 0; k < count; ++k)
            if (!test::same_bits(crossed[k], truth[i][k])) return at("crossings, ray", i);
    }
    return {};
}

// Bodies have no oracle here: another tree must say the same.
std::string check_bodies(const rc::Scene& a, const rc::Scene& b, const World& world) {
    const auto same = [](const rc::CastHit& x, const rc::CastHit& y) {
        return std::tie(x.t, x.depth, x.instance, x.primitive) ==
                   std::tie(y.t, y.depth, y.instance, y.primitive) &&
               x.point == y.point && x.normal == y.normal;
    };
    for (std::size_t i = 0; i < world.balls.size(); ++i) {
        const rc::SphereCast& ball = world.balls[i];
        const auto cast = [&](const rc::Scene& s) {
            return rc::sphere_cast(s, ball.centre, ball.radius, ball.displacement, world.layers)
                .value_or(rc::CastHit{});
        };
        if (!same(cast(a), cast(b))) return at("sphere cast, ball", i);
        rc::CastHit out[2][kCapacity];
        const rc::OrientedBox box{ball.centre, glm::vec3(ball.radius),
                                  glm::mat3(0.6f, 0.8f, 0, -0.8f, 0.6f, 0, 0, 0, 1)};
        const std::size_t count = rc::box_overlaps(a, box, world.layers, out[0]);
        if (count != rc::box_overlaps(b, box, world.layers, out[1])) return at("number of overlaps, box", i);
        for (std::size_t k = 0; k < count; ++k)
            if (!same(out[0][k], out[1][k])) return at("overlaps, box", i);
        const auto near = [&](const rc::Scene& s) {
            return rc::closest_point(s, ball.centre, rc::kInfinity, world.layers).value_or(rc::Nearest{});
        };
        const rc::Nearest p = near(a), q = near(b);
        if (p.distance != q.distance || p.instance != q.instance || p.primitive != q.primitive ||
            p.point != q.point)
            return at("closest point, ball", i);
    }
    return {};
}

std::vector<std::shared_ptr<rc::Blas>> blases_of(const World& world, rc::BuildQuality quality) {
    std::vector<std::shared_ptr<rc::Blas>> blases;
    for (const test::Mesh& mesh : world.meshes)
        blases.push_back(rc::build_blas(mesh.view(), {quality, true}));
    return blases;
}

std::shared_ptr<const rc::Scene> scene_of(const World& world,
                                          const std::vector<std::shared_ptr<rc::Blas>>& blases) {
    rc::SceneBuilder builder;
    for (const Placed& placed : world.placed)
        builder.add({blases[placed.mesh], placed.world_from_mesh, placed.layers});
    return builder.commit();
}

Truth truth_of(const World& world) {
    test::TestScene oracle;
    for (const Placed& placed : world.placed)
        oracle.add(world.meshes[placed.mesh], placed.world_from_mesh, placed.layers);
    Truth truth;
    for (const rc::Ray& ray : world.rays) truth.push_back(oracle.all_hits(ray, world.layers));
    return truth;
}

// The world once more with each mesh refitted to its other positions. What is dropped at build stays dropped, so the
// oracle's meshes lose those triangles for good.
World moved_world(const World& world) {
    World moved = world;
    for (std::size_t m = 0; m < world.meshes.size(); ++m) {
        for (glm::uvec3& t : moved.meshes[m].triangles)
            if (rc::check_mesh({world.meshes[m].positions, std::span(&t, 1)}).kept() == 0) t = glm::uvec3(0);
        moved.meshes[m].positions = world.moved[m];
    }
    return moved;
}

std::string name_of(rc::BuildQuality quality) {
    return "quality " + std::to_string(static_cast<int>(quality));
}

std::string check_trees(const World& world,
                        const std::vector<std::vector<std::shared_ptr<rc::Blas>>>& blases) {
    const Truth truth = truth_of(world);
    std::shared_ptr<const rc::Scene> first;
    for (std::size_t q = 0; q < blases.size(); ++q) {
        const auto scene = scene_of(world, blases[q]);
        for (const rc::Isa isa : kIsas) {
            if (!rc::use_isa(isa)) continue;
            const std::string fault = check_rays(*scene, world, truth);
            if (!fault.empty())
                return fault + ", " + name_of(kQualities[q]) + ", " + std::string(rc::isa_name(isa));
        }
        if (first) {
            const std::string fault = check_bodies(*first, *scene, world);
            if (!fault.empty()) return fault + ", " + name_of(kQualities[q]);
        } else {
            first = scene;
        }
    }
    return {};
}

}  // namespace

std::string check(const World& world) {
    std::vector<std::vector<std::shared_ptr<rc::Blas>>> blases;
    for (const rc::BuildQuality quality : kQualities) blases.push_back(blases_of(world, quality));
    const std::string fault = check_trees(world, blases);
    if (!fault.empty()) return fault;
    for (const auto& of_quality : blases)
        for (std::size_t m = 0; m < of_quality.size(); ++m) rc::refit_blas(*of_quality[m], world.moved[m]);
    const std::string moved_fault = check_trees(moved_world(world), blases);
    return moved_fault.empty() ? moved_fault : moved_fault + ", after a refit";
}

}  // namespace fuzz

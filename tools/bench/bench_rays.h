// bench_rays.h - the rays everybody is asked: the same floats for raycore and for its peers.
#pragma once

#include "bench_scenes.h"

#include "raycore/query.h"

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

struct RaySet {
    std::string name;
    bool any = false;  // whether only "is there anything" is asked
    std::vector<rc::Ray> rays;
};

[[nodiscard]] inline std::vector<std::string> names_of(const std::vector<RaySet>& sets) {
    std::vector<std::string> names;
    names.reserve(sets.size());
    for (const RaySet& set : sets) names.push_back(set.name);
    return names;
}

// What was answered, in so few words that nobody's loop is slowed by them.
struct Answer {
    std::uint64_t hits = 0;
    std::uint64_t hash = 0;  // over (hit, primitive) in the order of the rays

    void add(bool is_hit, std::uint32_t primitive) {
        hits += is_hit;
        hash = (hash ^ (is_hit ? primitive + 1u : 0u)) * 0x100000001B3u;
    }
};

// Primary (1280x720 pinhole in 8x8 tiles; every `keep`-th tile), shadow to random lamp points, ambient occlusion of
// a twentieth of the scene, diffuse: one cosine bounce. The last three start at the primary hits.
[[nodiscard]] std::vector<RaySet> make_ray_sets(const BenchScene& scene, const rc::Scene& built, int keep);

}  // namespace bench

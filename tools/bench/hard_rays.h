// hard_rays.h - meshes and rays with known answers that floating point finds hard. Every ray must hit.
#pragma once

#include "bench_scenes.h"
#include "support/random.h"

#include "raycore/ray.h"

#include <functional>
#include <string>
#include <vector>

namespace bench {

struct HardCase {
    std::string name;
    double share = 1.0;  // of the rays asked for
    BenchScene scene;
    std::function<rc::Ray(test::Random&)> ray;
};

[[nodiscard]] std::vector<HardCase> hard_cases();

}  // namespace bench

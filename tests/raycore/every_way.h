// raycore/every_way.h - the same rays asked in every way there is: closest, any and crossings, one by one and in batches
// of several sizes, on every instruction set. All must give the specification's answer in every bit.
#pragma once

#include "support/brute_force.h"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

namespace test {

inline constexpr rc::BuildQuality kQualities[] = {rc::BuildQuality::Fast, rc::BuildQuality::Default,
                                                  rc::BuildQuality::High};
[[nodiscard]] std::string quality_test_name(const ::testing::TestParamInfo<rc::BuildQuality>& info);

// How many of the rays meet something; adds test failures, naming `what`, where an answer is not the oracle's.
int expect_every_way(const TestScene& scene, std::span<const rc::Ray> rays, const char* what,
                     rc::LayerMask layers = rc::kAllLayers);

// Rays that suit any scene: from and to places in a cube about `centre`, at vertices and along axes, some with limits
// on t, zeros of both signs, and unusual lengths.
[[nodiscard]] std::vector<rc::Ray> searching_rays(Random& random, const Mesh& mesh, const glm::vec3& centre,
                                                  float half, int count);

}  // namespace test

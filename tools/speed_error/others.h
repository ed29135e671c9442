// speed_error/others.h - what others make of the same scene: Blender's Cycles at equal time, and a picture from anywhere.
//
// Renderers differ in what they take a file to mean (units of lamps, which side shines, what roughness is), so each is
// judged by its own converged picture; how far those are apart is said beside it.
#pragma once

#include "base/result.h"
#include "findings.h"
#include "reference.h"
#include "rows.h"

#include <filesystem>
#include <string>
#include <vector>

namespace speed_error {

struct OtherSettings {
    std::string view;
    std::uint64_t key = 0;
    std::filesystem::path scene;   // the file itself
    std::filesystem::path folder;  // for what is made on the way
    int samples = 16, reference_samples = 1024;
    int threads = 1;
};

// Cycles and "path, Sobol" at the core time Cycles takes, scene and trees built beforehand. An error says in one sentence
// why there is nothing: no `blender`, say.
[[nodiscard]] gh::Result<Finding> against_cycles(const std::vector<Row>& rows, const Reference& own,
                                                 const gh::render::Camera& camera,
                                                 const OtherSettings& settings);

// The reference beside somebody else's converged picture of the same view, whose sides are a whole multiple of its.
[[nodiscard]] gh::Result<Finding> against_picture(const std::filesystem::path& picture, const Reference& own,
                                                  const OtherSettings& settings, const gh::Jobs& jobs);

// What the path tracer leaves out in real time, once all noise is gone: few bounces, no focused light, clamps.
[[nodiscard]] Finding left_out_in_real_time(const Reference& real_time, const Reference& all_light,
                                            const std::string& view, const gh::Jobs& jobs);

}  // namespace speed_error

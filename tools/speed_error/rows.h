// speed_error/rows.h - one line of the report: a contestant on a view, what it cost and how wrong it was.
#pragma once

#include "base/jobs.h"
#include "base/result.h"
#include "contestants.h"
#include "reference.h"
#include "studio.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace speed_error {

struct Row {
    std::string view, contestant, family, truth;
    int samples_per_pixel = 1;
    std::uint64_t key = 0;  // of the reference: a row of another one is made anew
    int runs = 0;
    double wall_ms = 0.0, core_ms = 0.0;  // a picture; medians
    double filter_ms = 0.0;               // of core_ms: what came after rendering
    double rays = 0.0;                    // a picture
    double rel_mse = 0.0, rel_mse_trimmed = 0.0, flip = 0.0, ssim = 0.0;
    double bias = 0.0;  // of the mean over pixels and runs, as a share of the reference's mean
    double flicker =
        0.0;  // mean over pixels of the deviation between runs, as a share of the reference's mean
    double own_error = 0.0;  // of the reference

    // 1 / (relMSE x core-seconds): what is better at equal time.
    [[nodiscard]] double efficiency() const;
};

// Runs the contestant `runs` times with other seeds and writes its first picture as PNG, exposed as the reference. The
// last frame of each run is judged; the cost is that of one frame.
[[nodiscard]] gh::Result<Row> measure(const Contestant& contestant, const View& view, const Reference& truth,
                                      int runs, const gh::Jobs& jobs, const std::filesystem::path& picture);

// The slope of log rms error over log samples of a family's rows on one view (least squares); 0 with fewer than two.
[[nodiscard]] double slope(const std::vector<Row>& rows, const std::string& view, const std::string& family,
                           double Row::*error = &Row::rel_mse);

// What a family's error (rel_mse, or trimmed) would be at this cost: between its rows, and beyond them by 1 / cost; 0
// where it has none.
[[nodiscard]] double error_at_cost(const std::vector<Row>& rows, const std::string& view,
                                   const std::string& family, double core_ms,
                                   double Row::*error = &Row::rel_mse);

[[nodiscard]] nlohmann::json to_json(const Row& row);
// False when something is missing.
[[nodiscard]] bool from_json(const nlohmann::json& json, Row& row);

}  // namespace speed_error

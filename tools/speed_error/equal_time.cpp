#include "equal_time.h"

#include <algorithm>
#include <string>
#include <utility>

namespace speed_error {

namespace {

constexpr const char* kUnfiltered = "path, real time, unfiltered";

}  // namespace

std::vector<Finding> filter_gains(const std::vector<Row>& rows) {
    std::vector<Finding> gains;
    for (const Row& row : rows) {
        const bool is_filtered = row.family.starts_with("path, real time, ") && row.family != kUnfiltered;
        if (!is_filtered) continue;
        for (const auto& [measure, error] :
             {std::pair("relMSE", &Row::rel_mse),
              std::pair("relMSE without the worst thousandth", &Row::rel_mse_trimmed)}) {
            const double plain = error_at_cost(rows, row.view, kUnfiltered, row.core_ms, error);
            if (!(plain > 0.0) || !(row.*error > 0.0)) continue;
            gains.push_back({.table = "filtered against unfiltered at equal time",
                             .view = row.view,
                             .name = row.contestant + ", " + measure,
                             .key = row.key,
                             .values = {{"core-ms a frame", row.core_ms},
                                        {"filters of it", row.filter_ms},
                                        {"filtered", row.*error},
                                        {"unfiltered", plain},
                                        {"times lower", plain / row.*error}}});
        }
    }
    return gains;
}

std::vector<Finding> slopes(const std::vector<Row>& rows) {
    std::vector<Finding> found;
    for (const Row& row : rows) {
        const Finding like{.table = "error over samples", .view = row.view, .name = row.family, .values = {}};
        if (find(found, like) != nullptr) continue;
        std::vector<int> counts;
        for (const Row& other : rows) {
            const bool is_more =
                other.view == row.view && other.family == row.family &&
                std::find(counts.begin(), counts.end(), other.samples_per_pixel) == counts.end();
            if (is_more) counts.push_back(other.samples_per_pixel);
        }
        if (counts.size() < 3) continue;
        Finding steepness = like;
        steepness.values.emplace_back("slope", slope(rows, row.view, row.family));
        steepness.values.emplace_back("without the worst thousandth",
                                      slope(rows, row.view, row.family, &Row::rel_mse_trimmed));
        found.push_back(std::move(steepness));
    }
    return found;
}

bool is_doubtful(const Row& row) {
    return row.rel_mse < 20.0 * row.own_error;
}

std::size_t count_doubtful(const std::vector<Row>& rows) {
    return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), is_doubtful));
}

}  // namespace speed_error

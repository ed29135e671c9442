// speed_error/report.h - all that was measured as a page with plots and pictures, and as JSON for programs.
#pragma once

#include "base/result.h"
#include "findings.h"
#include "rows.h"

#include <filesystem>
#include <string>
#include <vector>

namespace speed_error {

struct Report {
    std::string machine;
    std::vector<Row> rows;
    std::vector<Finding> findings;
};

// Where a row's picture lies below the report's folder.
[[nodiscard]] std::string picture_name(const Row& row);

// report.html, report.json, and a plot of its own for every view: plot_VIEW.svg.
[[nodiscard]] gh::Result<void> write_report(const std::filesystem::path& folder, const Report& report);

// What an earlier report in that folder has; nothing if there is none.
[[nodiscard]] Report earlier_report(const std::filesystem::path& folder);

}  // namespace speed_error

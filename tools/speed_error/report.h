// speed_error/report.h - all rows as a page with plots and pictures, and as JSON for programs.
#pragma once

#include "base/result.h"
#include "rows.h"

#include <filesystem>
#include <string>
#include <vector>

namespace speed_error {

// Where a row's picture lies below the report's folder.
[[nodiscard]] std::string picture_name(const Row& row);

// report.html and report.json.
[[nodiscard]] gh::Result<void> write_report(const std::filesystem::path& folder, const std::vector<Row>& rows,
                                            const std::string& machine);

// The rows of an earlier report in that folder; none if there is none.
[[nodiscard]] std::vector<Row> earlier_rows(const std::filesystem::path& folder);

}  // namespace speed_error

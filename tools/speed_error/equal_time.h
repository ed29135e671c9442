// speed_error/equal_time.h - what follows from the rows: filtered against unfiltered at equal time, and how fast errors
// fall with the number of samples.
#pragma once

#include "findings.h"
#include "rows.h"

#include <vector>

namespace speed_error {

// Of every view: each filtered row beside what the same renderer without a filter would reach in the very same time.
[[nodiscard]] std::vector<Finding> filter_gains(const std::vector<Row>& rows);

// Slope of log rms error over log samples of every family with at least three numbers of samples.
[[nodiscard]] std::vector<Finding> slopes(const std::vector<Row>& rows);

// Rows that are not twenty times as wrong as what they are judged by.
[[nodiscard]] std::size_t count_doubtful(const std::vector<Row>& rows);
[[nodiscard]] bool is_doubtful(const Row& row);

}  // namespace speed_error

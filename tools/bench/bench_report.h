// bench_report.h - tables for people on stdout, and the same figures for programs in one JSON file.
#pragma once

#include "figures.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace bench {

class Report {
  public:
    Report();
    ~Report();
    Report(const Report&) = delete;
    Report& operator=(const Report&) = delete;

    // Starts a table: a title, the heading of the rows' names, and one heading a column.
    void table(const std::string& title, const std::string& of_rows, std::vector<std::string> columns);

    // A row is begun by its name; cells follow from left to right and must fill it.
    Report& row(const std::string& name);
    Report& number(double value, int decimals = 2);
    Report& count(std::uint64_t value);
    Report& text(const std::string& value);
    Report& hash(std::uint64_t value);
    Report& none();  // not applicable
    // Median of figures where more is better or worse alike, with its quartiles; printed "5.31 [5.20 5.40]".
    Report& spread(const Samples& samples, int decimals = 2);
    // Speed with its ratio to somebody, both medians; quartiles of the speed go to the JSON only: "5.31 (1.07)".
    Report& speed(const Samples& samples, const Samples& ratios);

    // A sentence below the table.
    void note(const std::string& sentence);
    // A fact about the run: machine, instruction set, options.
    void fact(const std::string& name, const std::string& value);

    // Writes everything said so far; false, with a sentence on stderr, when the file can not be written.
    [[nodiscard]] bool write_json(const std::string& path) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace bench

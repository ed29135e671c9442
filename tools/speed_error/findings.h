// speed_error/findings.h - what is measured beside the rows: small tables of named figures about a view.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace speed_error {

struct Finding {
    std::string table, view, name;
    std::uint64_t key = 0;  // of all it was made from: one of another scene is made anew
    std::vector<std::pair<std::string, double>> values;
};

// Null when there is none.
[[nodiscard]] const Finding* find(const std::vector<Finding>& findings, const Finding& like);
// In place of the one with the same table, view and name.
void keep(std::vector<Finding>& findings, Finding finding);

// Tables of a view, or of all views when `view` is empty.
[[nodiscard]] std::string html_of(const std::vector<Finding>& findings, const std::string& view);
void print(const std::vector<Finding>& findings);

[[nodiscard]] nlohmann::json to_json(const Finding& finding);
// False when something is missing.
[[nodiscard]] bool from_json(const nlohmann::json& json, Finding& finding);

}  // namespace speed_error

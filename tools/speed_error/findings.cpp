#include "findings.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace speed_error {

namespace {

bool is_alike(const Finding& a, const Finding& b) {
    return a.table == b.table && a.view == b.view && a.name == b.name;
}

std::vector<std::string> tables_of(const std::vector<Finding>& findings, const std::string& view) {
    std::vector<std::string> tables;
    for (const Finding& finding : findings) {
        if (!view.empty() && finding.view != view) continue;
        if (std::find(tables.begin(), tables.end(), finding.table) == tables.end())
            tables.push_back(finding.table);
    }
    return tables;
}

}  // namespace

const Finding* find(const std::vector<Finding>& findings, const Finding& like) {
    for (const Finding& finding : findings) {
        if (is_alike(finding, like)) return &finding;
    }
    return nullptr;
}

void keep(std::vector<Finding>& findings, Finding finding) {
    for (Finding& old : findings) {
        if (!is_alike(old, finding)) continue;
        old = std::move(finding);
        return;
    }
    findings.push_back(std::move(finding));
}

std::string html_of(const std::vector<Finding>& findings, const std::string& view) {
    std::string html;
    for (const std::string& table : tables_of(findings, view)) {
        html += fmt::format("<h3>{}</h3>\n<table>", table);
        std::string heads;
        for (const Finding& finding : findings) {
            if (finding.table != table || finding.view != view) continue;
            std::string head = "<tr><th></th>", line = fmt::format("<tr><td>{}</td>", finding.name);
            for (const auto& [name, value] : finding.values) {
                head += fmt::format("<th>{}</th>", name);
                line += fmt::format("<td>{:.4g}</td>", value);
            }
            if (head != heads) html += head + "</tr>\n";
            heads = head;
            html += line + "</tr>\n";
        }
        html += "</table>\n";
    }
    return html;
}

void print(const std::vector<Finding>& findings) {
    for (const std::string& table : tables_of(findings, "")) {
        fmt::print("\n{}\n", table);
        for (const Finding& finding : findings) {
            if (finding.table != table) continue;
            fmt::print("{:28} {:28}", finding.view, finding.name);
            for (const auto& [name, value] : finding.values) fmt::print("  {} {:.4g}", name, value);
            fmt::print("\n");
        }
    }
}

nlohmann::json to_json(const Finding& finding) {
    return {{"table", finding.table},
            {"view", finding.view},
            {"name", finding.name},
            {"key", finding.key},
            {"values", finding.values}};
}

bool from_json(const nlohmann::json& json, Finding& finding) {
    try {
        json.at("table").get_to(finding.table);
        json.at("view").get_to(finding.view);
        json.at("name").get_to(finding.name);
        json.at("key").get_to(finding.key);
        json.at("values").get_to(finding.values);
        return true;
    } catch (const nlohmann::json::exception&) {
        return false;
    }
}

}  // namespace speed_error

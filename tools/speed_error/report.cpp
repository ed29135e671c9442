#include "report.h"

#include "base/file.h"
#include "equal_time.h"
#include "plot.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace speed_error {

namespace {

constexpr const char* kHead =
    "<!doctype html><meta charset='utf-8'><title>Speed against "
    "error</title><style>body{font-family:sans-serif;"
    "margin:2em;max-width:1200px}table{border-collapse:collapse;font-size:13px}td,th{padding:2px "
    "9px;text-align:right;"
    "border-bottom:1px solid "
    "#eee}td:first-child,th:first-child{text-align:left}figure{display:inline-block;margin:4px}"
    "figcaption{font-size:11px}</style>\n<h1>Speed against error</h1>\n";

constexpr const char* kErrorTitle = "relMSE without the worst thousandth";

std::vector<std::string> distinct(const std::vector<Row>& rows, std::string Row::*member) {
    std::vector<std::string> names;
    for (const Row& row : rows) {
        if (std::find(names.begin(), names.end(), row.*member) == names.end()) names.push_back(row.*member);
    }
    return names;
}

// Fireflies apart: one pixel in ten thousand would draw the line.
std::vector<Line> lines_of(const std::vector<Row>& rows, const std::string& view, double Row::*cost) {
    std::vector<Line> lines;
    for (const std::string& family : distinct(rows, &Row::family)) {
        Line line{.name = family, .points = {}};
        for (const Row& row : rows) {
            if (row.view == view && row.family == family)
                line.points.push_back({row.*cost, row.rel_mse_trimmed, row.contestant});
        }
        std::sort(line.points.begin(), line.points.end(),
                  [](const Point& a, const Point& b) { return a.x < b.x; });
        if (!line.points.empty()) lines.push_back(std::move(line));
    }
    return lines;
}

std::string table_of(const std::vector<Row>& rows, const std::string& view) {
    std::string html =
        "<table><tr><th>how</th><th>truth</th><th>core-ms</th><th>of it filters</th><th>wall "
        "ms</th><th>Mrays</th><th>relMSE</th>"
        "<th>trimmed</th><th>FLIP</th><th>SSIM</th><th>bias %</th><th>flicker "
        "%</th><th>efficiency</th><th>slope</th></tr>\n";
    for (const Row& row : rows) {
        if (row.view != view) continue;
        html += fmt::format(
            "<tr><td>{}</td><td>{}</td><td>{:.1f}</td><td>{:.1f}</td><td>{:.1f}</td><td>{:.2f}</td>"
            "<td>{:.3g}{}</td><td>{:.3g}</td>"
            "<td>{:.4f}</td><td>{:.4f}</td><td>{:.2f}</td><td>{:.2f}</td><td>{:.3g}</td><td>{:.2f}</td></"
            "tr>\n",
            row.contestant, row.truth, row.core_ms, row.filter_ms, row.wall_ms, row.rays * 1e-6, row.rel_mse,
            is_doubtful(row) ? " *" : "", row.rel_mse_trimmed, row.flip, row.ssim, 100.0 * row.bias,
            100.0 * row.flicker, row.efficiency(), slope(rows, view, row.family));
    }
    return html + "</table>\n";
}

}  // namespace

std::string picture_name(const Row& row) {
    std::string name = row.view + "_" + row.contestant;
    for (char& c : name) {
        const bool is_plain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        if (!is_plain) c = '-';
    }
    return "pictures/" + name + ".png";
}

gh::Result<void> write_report(const std::filesystem::path& folder, const Report& report) {
    const std::vector<Row>& rows = report.rows;
    std::string html =
        kHead + fmt::format(
                    "<p>{}. A star marks what is less than twenty times as wrong as its own truth is. "
                    "Slope: of the error over samples in a family. Flicker: deviation of a pixel between "
                    "pictures with other seeds, of the mean brightness.</p>\n",
                    report.machine);
    nlohmann::json json = {{"machine", report.machine},
                           {"rows", nlohmann::json::array()},
                           {"findings", nlohmann::json::array()}};
    for (const Row& row : rows) json["rows"].push_back(to_json(row));
    for (const Finding& finding : report.findings) json["findings"].push_back(to_json(finding));
    for (const std::string& view : distinct(rows, &Row::view)) {
        const std::string by_cost =
            plot(lines_of(rows, view, &Row::core_ms), "core-ms a picture", kErrorTitle);
        html += fmt::format("<h2>{}</h2>\n", view) + table_of(rows, view) + by_cost +
                plot(lines_of(rows, view, &Row::rays), "rays a picture", kErrorTitle) +
                html_of(report.findings, view);
        if (auto written = gh::write_file_atomically(folder / ("plot_" + view + ".svg"), by_cost); !written)
            return written.error();
        for (const Row& row : rows) {
            if (row.view != view) continue;
            html += fmt::format(
                "<figure><img src='{}' width='320'><figcaption>{}: {:.1f} core-ms, FLIP "
                "{:.4f}</figcaption></figure>\n",
                picture_name(row), row.contestant, row.core_ms, row.flip);
        }
    }
    if (auto written = gh::write_file_atomically(folder / "report.json", json.dump(1)); !written)
        return written.error();
    return gh::write_file_atomically(folder / "report.html", html);
}

Report earlier_report(const std::filesystem::path& folder) {
    Report report;
    const auto bytes = gh::read_file(folder / "report.json", std::size_t{1} << 26);
    if (!bytes) return report;
    const auto* text = reinterpret_cast<const char*>(bytes->data());
    const nlohmann::json json = nlohmann::json::parse(text, text + bytes->size(), nullptr, false);
    if (!json.is_object() || !json.contains("rows") || !json.contains("findings")) return report;
    for (const nlohmann::json& entry : json["rows"]) {
        Row row;
        if (from_json(entry, row)) report.rows.push_back(std::move(row));
    }
    for (const nlohmann::json& entry : json["findings"]) {
        Finding finding;
        if (from_json(entry, finding)) report.findings.push_back(std::move(finding));
    }
    return report;
}

}  // namespace speed_error

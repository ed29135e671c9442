#include "plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace speed_error {

namespace {

constexpr double kPlotWidth = 760, kPlotHeight = 420, kLeft = 70, kRight = 240, kTop = 15, kBottom = 45;
constexpr std::array<const char*, 14> kColors = {"#c0392b", "#2471a3", "#1e8449", "#b7950b", "#7d3c98",
                                                 "#ba4a00", "#117a65", "#566573", "#ec7063", "#5dade2",
                                                 "#58d68d", "#17202a", "#d4ac0d", "#a569bd"};

struct Axis {
    double low = 1e300, high = 0.0;  // whole decades

    void include(double value) {
        low = std::min(low, std::pow(10.0, std::floor(std::log10(value))));
        high = std::max(high, std::pow(10.0, std::ceil(std::log10(value) + 1e-9)));
    }
    // Where lines go: 1, 10, 100 and so on.
    [[nodiscard]] std::vector<double> decades() const {
        const int count = static_cast<int>(std::lround(std::log10(high / low)));
        std::vector<double> all;
        for (int i = 0; i <= count; ++i) all.push_back(low * std::pow(10.0, i));
        return all;
    }
    [[nodiscard]] double share(double value) const { return std::log(value / low) / std::log(high / low); }
};

bool is_shown(const Point& p) {
    return p.x > 0.0 && p.y > 0.0 && std::isfinite(p.x) && std::isfinite(p.y);
}

}  // namespace

std::string plot(const std::vector<Line>& lines, const std::string& x_title, const std::string& y_title) {
    Axis x_axis, y_axis;
    for (const Line& line : lines) {
        for (const Point& p : line.points) {
            if (!is_shown(p)) continue;
            x_axis.include(p.x);
            y_axis.include(p.y);
        }
    }
    if (!(x_axis.high > x_axis.low) || !(y_axis.high > y_axis.low)) return "<p>Nothing to plot.</p>";
    const auto x_at = [&](double x) { return kLeft + x_axis.share(x) * (kPlotWidth - kLeft - kRight); };
    const auto y_at = [&](double y) {
        return kPlotHeight - kBottom - y_axis.share(y) * (kPlotHeight - kTop - kBottom);
    };

    std::string svg = fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1}' width='{0}' height='{1}' "
        "font-family='sans-serif' font-size='11'><rect width='100%' height='100%' fill='#fff'/>\n",
        kPlotWidth, kPlotHeight);
    for (const double x : x_axis.decades()) {
        svg += fmt::format(
            "<line x1='{0:.1f}' x2='{0:.1f}' y1='{1}' y2='{2}' stroke='#ddd'/>"
            "<text x='{0:.1f}' y='{3}' text-anchor='middle'>{4:g}</text>\n",
            x_at(x), kTop, kPlotHeight - kBottom, kPlotHeight - kBottom + 15, x);
    }
    for (const double y : y_axis.decades()) {
        svg += fmt::format(
            "<line x1='{0}' x2='{1}' y1='{2:.1f}' y2='{2:.1f}' stroke='#ddd'/>"
            "<text x='{3}' y='{4:.1f}' text-anchor='end'>{5:g}</text>\n",
            kLeft, kPlotWidth - kRight, y_at(y), kLeft - 6, y_at(y) + 4, y);
    }
    svg += fmt::format(
        "<text x='{}' y='{}' text-anchor='middle'>{}</text><text x='12' y='{}' transform='rotate(-90 12 {})' "
        "text-anchor='middle'>{}</text>\n",
        0.5 * (kLeft + kPlotWidth - kRight), kPlotHeight - 8, x_title, 0.5 * kPlotHeight, 0.5 * kPlotHeight,
        y_title);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const char* color = kColors[i % kColors.size()];
        const bool is_second = i >= kColors.size();  // of its colour: dashed, and its points are rings
        std::string path;
        for (const Point& p : lines[i].points) {
            if (!is_shown(p)) continue;
            path += fmt::format("{:.1f},{:.1f} ", x_at(p.x), y_at(p.y));
            svg += fmt::format(
                "<circle cx='{:.1f}' cy='{:.1f}' r='4' fill='{}' stroke='{}'><title>{}</title></circle>\n",
                x_at(p.x), y_at(p.y), is_second ? "#fff" : color, color, p.title);
        }
        svg += fmt::format("<polyline points='{}' fill='none' stroke='{}' stroke-width='1.5'{}/>\n", path,
                           color, is_second ? " stroke-dasharray='5 3'" : "");
        svg += fmt::format("<text x='{}' y='{}' fill='{}'>{}{}</text>\n", kPlotWidth - kRight + 12,
                           kTop + 14 + 16 * static_cast<double>(i), color, lines[i].name,
                           is_second ? " (dashed)" : "");
    }
    return svg + "</svg>\n";
}

}  // namespace speed_error

// speed_error/plot.h - error over cost as a picture in a page, both logarithmic.
#pragma once

#include <string>
#include <vector>

namespace speed_error {

struct Point {
    double x = 0.0, y = 0.0;
    std::string title;
};
struct Line {
    std::string name;
    std::vector<Point> points;  // x rising
};

// SVG. Points that are not above 0 are left out.
[[nodiscard]] std::string plot(const std::vector<Line>& lines, const std::string& x_title,
                               const std::string& y_title);

}  // namespace speed_error

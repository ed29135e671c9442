#include "rows.h"

#include "clocks.h"
#include "metrics/picture_metrics.h"
#include "record/picture.h"
#include "shown.h"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace speed_error {

namespace {

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[values.size() / 2];
}

// How much pixels differ from run to run, where what they show does not.
double flicker_of(const std::vector<gh::Image>& pictures) {
    if (pictures.size() < 2) return 0.0;
    const auto count = static_cast<double>(pictures.size());
    double total = 0.0;
    for (std::size_t i = 0; i < pictures[0].pixels.size(); ++i) {
        double sum = 0.0, squares = 0.0;
        for (const gh::Image& picture : pictures) {
            const double value = brightness(picture.pixels[i]);
            sum += value;
            squares += value * value;
        }
        total += std::sqrt(std::max(0.0, (squares - sum * sum / count) / (count - 1.0)));
    }
    return total / static_cast<double>(pictures[0].pixels.size());
}

}  // namespace

double Row::efficiency() const {
    const double cost = rel_mse * core_ms * 1e-3;
    return cost > 0.0 ? 1.0 / cost : 0.0;
}

gh::Result<Row> measure(const Contestant& contestant, const View& view, const Reference& truth, int runs,
                        const gh::Jobs& jobs, const std::filesystem::path& picture) {
    Row row{.view = view.name,
            .contestant = contestant.name,
            .family = contestant.family,
            .truth = contestant.truth,
            .samples_per_pixel = contestant.samples_per_pixel,
            .key = truth.key,
            .runs = runs,
            .own_error = truth.own_error};
    const float exposure = gh::filter::metered_exposure(truth.picture);
    const gh::Image wanted = shown(truth.picture, exposure, jobs);
    const double light = mean_brightness(truth.picture);
    std::vector<double> wall, core, filter;
    std::vector<gh::Image> pictures;
    for (int run = 0; run < runs; ++run) {
        gh::render::Film film(truth.picture.width, truth.picture.height);
        const Run make = contestant.begin();
        for (int frame = 0; frame < contestant.frames; ++frame) {
            const double start = wall_ms();
            const StageTimes times = make({.scene = view.studio.lit_view(),
                                           .camera = view.camera,
                                           .seed = static_cast<std::uint32_t>(run),
                                           .frame = static_cast<std::uint32_t>(frame),
                                           .jobs = jobs},
                                          film);
            wall.push_back(wall_ms() - start);
            core.push_back(times.total());
            filter.push_back(times.filter_ms);
        }
        row.rays += static_cast<double>(film.stats.total()) / runs;
        const metrics::RelMse error = metrics::rel_mse(film.radiance, truth.picture);
        const gh::Image seen = shown(film.radiance, exposure, jobs);
        row.rel_mse += error.all / runs;
        row.rel_mse_trimmed += error.trimmed / runs;
        row.flip += metrics::flip(seen, wanted).mean / runs;
        row.ssim += metrics::ssim(seen, wanted) / runs;
        row.bias += (mean_brightness(film.radiance) - light) / (light * runs);
        pictures.push_back(std::move(film.radiance));
    }
    row.wall_ms = median(wall);
    row.core_ms = median(core);
    row.filter_ms = median(filter);
    row.flicker = light > 0.0 ? flicker_of(pictures) / light : 0.0;
    if (auto written = gh::record::write_png(picture, shown8(pictures[0], exposure, jobs)); !written)
        return written.error();
    return row;
}

double slope(const std::vector<Row>& rows, const std::string& view, const std::string& family,
             double Row::*error) {
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const Row& row : rows) {
        if (row.view != view || row.family != family || !(row.*error > 0.0)) continue;
        const double samples = std::log(row.samples_per_pixel), rms = 0.5 * std::log(row.*error);
        n += 1.0, x += samples, y += rms, xx += samples * samples, xy += samples * rms;
    }
    const double spread = n * xx - x * x;
    return n >= 2.0 && spread > 0.0 ? (n * xy - x * y) / spread : 0.0;
}

double error_at_cost(const std::vector<Row>& rows, const std::string& view, const std::string& family,
                     double core_ms, double Row::*error) {
    std::vector<std::pair<double, double>> points;  // log cost, log error
    for (const Row& row : rows) {
        if (row.view == view && row.family == family && row.*error > 0.0 && row.core_ms > 0.0)
            points.emplace_back(std::log(row.core_ms), std::log(row.*error));
    }
    if (points.empty() || !(core_ms > 0.0)) return 0.0;
    std::sort(points.begin(), points.end());
    const double at = std::log(core_ms);
    if (at <= points.front().first) return std::exp(points.front().second + points.front().first - at);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const auto [x0, y0] = points[i - 1];
        const auto [x1, y1] = points[i];
        if (at <= x1) return std::exp(x1 > x0 ? y0 + (y1 - y0) * (at - x0) / (x1 - x0) : y1);
    }
    return std::exp(points.back().second + points.back().first - at);
}

nlohmann::json to_json(const Row& row) {
    return {{"view", row.view},
            {"contestant", row.contestant},
            {"family", row.family},
            {"truth", row.truth},
            {"spp", row.samples_per_pixel},
            {"key", row.key},
            {"runs", row.runs},
            {"wall_ms", row.wall_ms},
            {"core_ms", row.core_ms},
            {"filter_ms", row.filter_ms},
            {"rays", row.rays},
            {"rel_mse", row.rel_mse},
            {"rel_mse_trimmed", row.rel_mse_trimmed},
            {"flip", row.flip},
            {"ssim", row.ssim},
            {"bias", row.bias},
            {"flicker", row.flicker},
            {"own_error", row.own_error},
            {"efficiency", row.efficiency()}};
}

bool from_json(const nlohmann::json& json, Row& row) {
    try {
        json.at("view").get_to(row.view);
        json.at("contestant").get_to(row.contestant);
        json.at("family").get_to(row.family);
        json.at("truth").get_to(row.truth);
        json.at("spp").get_to(row.samples_per_pixel);
        json.at("key").get_to(row.key);
        json.at("runs").get_to(row.runs);
        json.at("wall_ms").get_to(row.wall_ms);
        json.at("core_ms").get_to(row.core_ms);
        json.at("filter_ms").get_to(row.filter_ms);
        json.at("rays").get_to(row.rays);
        json.at("rel_mse").get_to(row.rel_mse);
        json.at("rel_mse_trimmed").get_to(row.rel_mse_trimmed);
        json.at("flip").get_to(row.flip);
        json.at("ssim").get_to(row.ssim);
        json.at("bias").get_to(row.bias);
        json.at("flicker").get_to(row.flicker);
        json.at("own_error").get_to(row.own_error);
        return true;
    } catch (const nlohmann::json::exception&) {
        return false;
    }
}

}  // namespace speed_error

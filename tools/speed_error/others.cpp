#include "others.h"

#include "base/file.h"
#include "metrics/picture_metrics.h"
#include "record/picture.h"
#include "shown.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <system_error>

namespace speed_error {

namespace {

constexpr std::size_t kMostJson = std::size_t{1} << 20;

std::string in_quotes(const std::filesystem::path& path) {
    std::string quoted = "'";
    for (const char c : path.string()) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

nlohmann::json read_json(const std::filesystem::path& path) {
    const auto bytes = gh::read_file(path, kMostJson);
    if (!bytes) return nullptr;
    const auto* text = reinterpret_cast<const char*>(bytes->data());
    return nlohmann::json::parse(text, text + bytes->size(), nullptr, false);
}

// Mean of the three colours of both pictures, theirs over ours.
double brightness_ratio(const gh::Image& theirs, const gh::Image& ours) {
    const double own = mean_brightness(ours);
    return own > 0.0 ? mean_brightness(theirs) / own : 0.0;
}

gh::Image scaled(gh::Image picture, double factor) {
    for (glm::vec3& pixel : picture.pixels) pixel *= static_cast<float>(factor);
    return picture;
}

// Means of blocks.
gh::Result<gh::Image> shrunk(const gh::Image& picture, int width, int height) {
    const int side = picture.width / width;
    if (side < 1 || side * width != picture.width || side * height != picture.height) {
        return gh::Error{fmt::format("a picture of {}x{} is no whole multiple of {}x{}", picture.width,
                                     picture.height, width, height)};
    }
    gh::Image small(width, height);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x)
            small.at(x / side, y / side) += picture.at(x, y) / static_cast<float>(side * side);
    }
    return small;
}

}  // namespace

gh::Result<Finding> against_cycles(const std::vector<Row>& rows, const Reference& own,
                                   const gh::render::Camera& camera, const OtherSettings& settings) {
    if (std::system("command -v blender >/dev/null 2>&1") != 0)
        return gh::Error{"--cycles: there is no blender to be started; Debian's package is called blender"};
    std::error_code failed;
    const std::filesystem::path folder =
        std::filesystem::absolute(settings.folder / "cycles" / settings.view);
    std::filesystem::create_directories(folder, failed);
    const nlohmann::json wanted = {{"scene", std::filesystem::absolute(settings.scene).string()},
                                   {"folder", folder.string()},
                                   {"width", own.picture.width},
                                   {"height", own.picture.height},
                                   {"threads", settings.threads},
                                   {"samples", settings.samples},
                                   {"reference_samples", settings.reference_samples},
                                   {"position", {camera.position.x, camera.position.y, camera.position.z}},
                                   {"yaw", camera.yaw},
                                   {"pitch", camera.pitch},
                                   {"roll", camera.roll},
                                   {"fov_y", camera.fov_y}};
    const std::filesystem::path wish = folder / "settings.json";
    if (auto written = gh::write_file_atomically(wish, wanted.dump(1)); !written) return written.error();
    std::filesystem::remove(folder / "timing.json", failed);
    const std::string command = "blender -b --factory-startup -noaudio --python " +
                                in_quotes(GLASSHOUSE_SOURCE_DIR "/tools/speed_error/cycles.py") + " -- " +
                                in_quotes(wish) + " >" + in_quotes(folder / "log.txt") + " 2>&1";
    fmt::print(stderr, "Cycles renders {}: {} and {} samples a pixel\n", settings.view, settings.samples,
               settings.reference_samples);
    if (std::system(command.c_str()) != 0 || !read_json(folder / "timing.json").is_object())
        return gh::Error{"--cycles: blender did not render, see " + (folder / "log.txt").string()};
    const nlohmann::json timing = read_json(folder / "timing.json");
    const auto a = gh::record::read_picture(folder / "a.exr"), b = gh::record::read_picture(folder / "b.exr"),
               truth = gh::record::read_picture(folder / "reference.exr");
    if (!a || !b || !truth) return gh::Error{"--cycles: a picture is missing in " + folder.string()};
    // Two independent pictures of n samples and one of N against their sum: what is left of N's own error is n / N.
    const double share = static_cast<double>(settings.samples) / settings.reference_samples;
    const double error =
        0.5 * (metrics::rel_mse(*a, *truth).all + metrics::rel_mse(*b, *truth).all) / (1.0 + share);
    const double ms =
        500.0 * (timing.value("a", 0.0) + timing.value("b", 0.0)) - 1000.0 * timing.value("one", 0.0);
    const double ours = error_at_cost(rows, settings.view, "path, Sobol", ms);
    return Finding{.table = "Cycles at equal time, both unfiltered, each against its own converged picture",
                   .view = settings.view,
                   .name = fmt::format("Cycles, {} spp", settings.samples),
                   .key = settings.key,
                   .values = {{"core-ms", ms},
                              {"relMSE of Cycles", error},
                              {"relMSE of path, Sobol", ours},
                              {"ours / theirs", error > 0.0 ? ours / error : 0.0},
                              {"brightness, theirs / ours", brightness_ratio(*truth, own.picture)}}};
}

gh::Result<Finding> against_picture(const std::filesystem::path& path, const Reference& own,
                                    const OtherSettings& settings, const gh::Jobs& jobs) {
    const auto large = gh::record::read_picture(path);
    if (!large) return large.error();
    const auto theirs = shrunk(*large, own.picture.width, own.picture.height);
    if (!theirs) return gh::Error{path.string() + ": " + theirs.error().sentence};
    const double ratio = brightness_ratio(*theirs, own.picture);
    const gh::Image even = scaled(*theirs, ratio > 0.0 ? 1.0 / ratio : 1.0);
    const float exposure = gh::filter::metered_exposure(own.picture);
    const gh::Image wanted = shown(own.picture, exposure, jobs), seen = shown(even, exposure, jobs);
    const auto name = settings.folder / "pictures" / (settings.view + "_given.png");
    if (auto written = gh::record::write_png(name, shown8(even, exposure, jobs)); !written)
        return written.error();
    return Finding{
        .table = "the truth against a picture by others, which may take the scene to mean something else",
        .view = settings.view,
        .name = path.filename().string(),
        .key = settings.key,
        .values = {{"brightness, theirs / ours", ratio},
                   {"relMSE, equally bright", metrics::rel_mse(even, own.picture).all},
                   {"trimmed", metrics::rel_mse(even, own.picture).trimmed},
                   {"FLIP", metrics::flip(seen, wanted).mean},
                   {"SSIM", metrics::ssim(seen, wanted)}}};
}

Finding left_out_in_real_time(const Reference& real_time, const Reference& all_light, const std::string& view,
                              const gh::Jobs& jobs) {
    const float exposure = gh::filter::metered_exposure(all_light.picture);
    const gh::Image wanted = shown(all_light.picture, exposure, jobs),
                    seen = shown(real_time.picture, exposure, jobs);
    return {.table = "what path tracing leaves out in real time: both converged",
            .view = view,
            .name = "real time against all light",
            .key = all_light.key,
            .values = {{"brightness, share", brightness_ratio(real_time.picture, all_light.picture)},
                       {"relMSE", metrics::rel_mse(real_time.picture, all_light.picture).all},
                       {"trimmed", metrics::rel_mse(real_time.picture, all_light.picture).trimmed},
                       {"FLIP", metrics::flip(seen, wanted).mean}}};
}

}  // namespace speed_error

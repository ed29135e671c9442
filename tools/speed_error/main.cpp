// Renders views with every contestant, judges each by a reference of many samples, and writes what came out:
//   build/release/bin/speed_error [SCENE] [--camera NAME ...] [--quick]
// Stopped and started again it goes on where it was.
#include "app/assets.h"
#include "app/view.h"
#include "base/hash.h"
#include "base/progress.h"
#include "load/level_loader.h"
#include "render/prepared.h"
#include "report.h"
#include "spatial/stage.h"
#include "world/initial_state.h"

#include "raycore/isa.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace {

using namespace gh;

struct Options {
    std::string scene = "foyer", out = "out/speed_error";
    std::vector<std::string> cameras;
    int width = 320, height = 180, reference_samples = 2048, runs = 3, threads = 0;
    bool is_quick = false;
};

int complain(const std::string& sentence) {
    fmt::print(stderr, "speed_error: {}\n", sentence);
    return 2;
}

// Three views where the file names any, else one from where a player would start.
std::vector<std::string> views_of(const world::Level& level, const Options& options) {
    if (!options.cameras.empty()) return options.cameras;
    std::vector<std::string> names;
    const std::size_t count = std::min<std::size_t>(options.is_quick ? 1 : 3, level.viewpoints.size());
    for (std::size_t i = 0; i < count; ++i)
        names.push_back(level.viewpoints[i * level.viewpoints.size() / count].name);
    if (names.empty()) names.emplace_back();
    return names;
}

std::uint64_t scene_key(const world::Level& level, const render::Camera& camera) {
    Hasher hash;
    hash.add(level.file_hash);
    hash.add(camera.position);
    hash.add(camera.yaw);
    hash.add(camera.pitch);
    hash.add(camera.fov_y);
    return hash.digest();
}

struct Studio {
    std::shared_ptr<const world::Level> level;
    world::Snapshot snapshot;
    std::unique_ptr<spatial::Stage> stage;
    render::Prepared prepared;
};

Result<Studio> open(const std::string& scene, const Jobs& jobs) {
    const auto path = app::resolve_level(scene);
    if (!path) return path.error();
    auto loaded = load::load_level(*path, {.finds_ways = false});
    if (!loaded) return loaded.error();
    Studio studio;
    studio.level = std::make_shared<const world::Level>(*std::move(loaded));
    jobs.run_in([&] { studio.stage = std::make_unique<spatial::Stage>(studio.level); });
    studio.snapshot = studio.stage->commit(world::initial_state(*studio.level, 0), jobs);
    studio.prepared = render::prepare(*studio.level, studio.snapshot, jobs);
    return studio;
}

Result<void> judge_view(const Studio& studio, const std::string& name, const Options& options,
                        const Jobs& jobs, std::vector<speed_error::Row>& rows, const std::string& machine) {
    const std::filesystem::path folder = options.out;
    const render::SceneView scene{*studio.level, studio.snapshot, studio.prepared};
    const auto camera = app::camera_named(*studio.level, studio.snapshot, name);
    if (!camera) return camera.error();
    const std::string view = studio.level->name + (name.empty() ? "" : "_" + name);
    const auto all = speed_error::contestants(options.is_quick);
    Progress progress(view, all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const speed_error::ReferenceSettings settings{.samples_per_pixel = options.reference_samples,
                                                      .folder = folder / "references",
                                                      .view = view,
                                                      .scene_key = scene_key(*studio.level, *camera),
                                                      .width = options.width,
                                                      .height = options.height};
        const auto truth = speed_error::reference(all[i].truth, settings, scene, *camera, jobs);
        if (!truth) return truth.error();
        const auto is_same = [&](const speed_error::Row& row) {
            return row.view == view && row.contestant == all[i].name;
        };
        const auto known = std::find_if(rows.begin(), rows.end(), is_same);
        if (known != rows.end() && known->key == truth->key && known->runs >= options.runs) continue;
        speed_error::Row wanted;
        wanted.view = view;
        wanted.contestant = all[i].name;
        auto row = speed_error::measure(all[i], view, *truth, scene, *camera, options.runs, jobs,
                                        folder / speed_error::picture_name(wanted));
        if (!row) return row.error();
        rows.erase(std::remove_if(rows.begin(), rows.end(), is_same), rows.end());
        rows.push_back(*std::move(row));
        if (auto written = speed_error::write_report(folder, rows, machine); !written) return written.error();
        progress.show(i + 1);
    }
    return {};
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Renders views in every way and says how wrong each is for what it costs.", "speed_error");
    app.add_option("SCENE", options.scene, "a level's name, or any .gltf or .glb")->capture_default_str();
    app.add_option("--camera", options.cameras,
                   "cameras of the scene, or x,y,z,yaw,pitch,fov; three of its own otherwise");
    app.add_option("--out", options.out, "folder of report.html, report.json and the pictures")
        ->capture_default_str();
    app.add_option("--width", options.width, "pixels")->check(CLI::Range(16, 4096))->capture_default_str();
    app.add_option("--height", options.height, "pixels")->check(CLI::Range(16, 4096))->capture_default_str();
    app.add_option("--reference", options.reference_samples, "samples a pixel of a reference")
        ->check(CLI::Range(2, 1 << 20))
        ->capture_default_str();
    app.add_option("--runs", options.runs, "pictures with other seeds")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--threads", options.threads, "0: one for every core")->check(CLI::Range(0, 256));
    app.add_flag("--quick", options.is_quick, "one view, few samples, small: within a minute");
    CLI11_PARSE(app, argc, argv);
    if (options.is_quick) {
        options.width = std::min(options.width, 160);
        options.height = std::min(options.height, 90);
        options.reference_samples = std::min(options.reference_samples, 256);
        options.runs = std::min(options.runs, 2);
    }
    const Jobs jobs(options.threads);
    const auto studio = open(options.scene, jobs);
    if (!studio) return complain(studio.error().sentence);
    const std::string machine =
        fmt::format("{} threads, {}, {}x{} pixels, references of {} samples", jobs.threads(),
                    rc::isa_name(rc::active_isa()), options.width, options.height, options.reference_samples);
    std::vector<speed_error::Row> rows = speed_error::earlier_rows(options.out);
    for (const std::string& view : views_of(*studio->level, options)) {
        if (auto judged = judge_view(*studio, view, options, jobs, rows, machine); !judged)
            return complain(judged.error().sentence);
    }
    for (const speed_error::Row& row : rows) {
        fmt::print("{:28} {:28} {:9.1f} core-ms  relMSE {:9.3g}  FLIP {:.4f}  efficiency {:.3g}\n", row.view,
                   row.contestant, row.core_ms, row.rel_mse, row.flip, row.efficiency());
    }
    fmt::print("{}\n", (std::filesystem::path(options.out) / "report.html").string());
    return 0;
}

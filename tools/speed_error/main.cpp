// Renders views with every contestant, judges each by a reference of many samples, and writes what came out:
//   build/release/bin/speed_error [SCENE] [--camera NAME ...] [--quick] [--cycles] [--reference PICTURE]
// Stopped and started again it goes on where it was.
#include "adaptive_gap.h"
#include "app/assets.h"
#include "app/view.h"
#include "base/progress.h"
#include "equal_time.h"
#include "others.h"
#include "over_time.h"
#include "report.h"
#include "studio.h"
#include "walking_guard.h"

#include "raycore/isa.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <optional>

namespace {

using namespace gh;
using speed_error::Finding;
using speed_error::Report;
using speed_error::Row;
using speed_error::View;

struct Options {
    std::string scene = "foyer", out = "out/speed_error", picture, only;
    std::vector<std::string> cameras;
    int width = 320, height = 180, reference_samples = 2048, runs = 3, threads = 0, cycles_samples = 16;
    bool is_quick = false, asks_cycles = false;
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

Result<speed_error::Reference> truth_of(const View& view, const std::string& truth, const Options& options,
                                        const Jobs& jobs) {
    return speed_error::reference(truth, view,
                                  {.samples_per_pixel = options.reference_samples,
                                   .folder = std::filesystem::path(options.out) / "references",
                                   .width = options.width,
                                   .height = options.height},
                                  jobs);
}

Result<void> judge_pictures(const View& view, const Options& options, const Jobs& jobs, Report& report) {
    const std::filesystem::path folder = options.out;
    auto all = speed_error::contestants(options.is_quick);
    const auto is_left_out = [&](const speed_error::Contestant& contestant) {
        return contestant.name.find(options.only) == std::string::npos;
    };
    all.erase(std::remove_if(all.begin(), all.end(), is_left_out), all.end());
    Progress progress(view.name, all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto truth = truth_of(view, all[i].truth, options, jobs);
        if (!truth) return truth.error();
        const auto is_same = [&](const Row& row) {
            return row.view == view.name && row.contestant == all[i].name;
        };
        const auto known = std::find_if(report.rows.begin(), report.rows.end(), is_same);
        if (known != report.rows.end() && known->key == truth->key && known->runs >= options.runs) continue;
        Row wanted;
        wanted.view = view.name;
        wanted.contestant = all[i].name;
        auto row = speed_error::measure(all[i], view, *truth, options.runs, jobs,
                                        folder / speed_error::picture_name(wanted));
        if (!row) return row.error();
        report.rows.erase(std::remove_if(report.rows.begin(), report.rows.end(), is_same), report.rows.end());
        report.rows.push_back(*std::move(row));
        if (auto written = speed_error::write_report(folder, report); !written) return written.error();
        progress.show(i + 1);
    }
    return {};
}

// Nothing to be done where an earlier run left the same finding.
bool is_known(const Report& report, const std::string& table, const View& view, const std::string& name) {
    const Finding* known =
        find(report.findings, {.table = table, .view = view.name, .name = name, .values = {}});
    return known != nullptr && known->key == view.key;
}

void judge_guard(const View& view, const Options& options, const Jobs& jobs, Report& report) {
    if (view.studio.level->guards.empty()) return;
    std::optional<speed_error::WalkingGuard> guard;
    for (const speed_error::Contestant& contestant : speed_error::moving_contestants()) {
        if (is_known(report, speed_error::kWalkingGuardTable, view, contestant.family)) continue;
        if (!guard) guard.emplace(view, options.width, options.height, jobs);
        for (Finding& seen : guard->judge(contestant)) keep(report.findings, std::move(seen));
    }
}

void judge_motion(const View& view, const Options& options, const Jobs& jobs, Report& report) {
    for (const speed_error::Contestant& contestant : speed_error::moving_contestants()) {
        if (is_known(report, "over time, of what is shown", view, contestant.family)) continue;
        keep(report.findings,
             speed_error::judge_over_time(contestant, view, options.width, options.height, jobs));
    }
    if (is_known(report, "adaptive against full sampling, same seed, 640x360", view, "contrast 0.25")) return;
    for (Finding& gap : adaptive_gaps(view, jobs)) keep(report.findings, std::move(gap));
}

Result<void> ask_others(const View& view, const Options& options, const Jobs& jobs, Report& report) {
    if (!options.asks_cycles && options.picture.empty()) return {};
    const auto own = truth_of(view, "path", options, jobs);
    if (!own) return own.error();
    const auto file = app::resolve_level(options.scene);
    if (!file) return file.error();
    const speed_error::OtherSettings settings{.view = view.name,
                                              .key = view.key,
                                              .scene = *file,
                                              .folder = options.out,
                                              .samples = options.cycles_samples,
                                              .reference_samples = 64 * options.cycles_samples,
                                              .threads = jobs.threads()};
    if (!options.picture.empty()) {
        auto finding = speed_error::against_picture(options.picture, *own, settings, jobs);
        if (!finding) return finding.error();
        keep(report.findings, *std::move(finding));
    }
    if (options.asks_cycles) {
        auto finding = speed_error::against_cycles(report.rows, *own, view.camera, settings);
        if (!finding) return finding.error();
        keep(report.findings, *std::move(finding));
    }
    return {};
}

Result<void> judge_view(const View& view, const Options& options, const Jobs& jobs, Report& report) {
    if (auto judged = judge_pictures(view, options, jobs, report); !judged) return judged.error();
    if (options.only.empty()) {
        const auto real_time = truth_of(view, "real time", options, jobs),
                   all_light = truth_of(view, "path", options, jobs);
        if (!real_time || !all_light) return (real_time ? all_light : real_time).error();
        keep(report.findings, speed_error::left_out_in_real_time(*real_time, *all_light, view.name, jobs));
        judge_motion(view, options, jobs, report);
    }
    if (std::string(speed_error::kWalkingGuardTable).find(options.only) != std::string::npos)
        judge_guard(view, options, jobs, report);
    for (Finding& gain : speed_error::filter_gains(report.rows)) keep(report.findings, std::move(gain));
    for (Finding& slope : speed_error::slopes(report.rows)) keep(report.findings, std::move(slope));
    auto asked = ask_others(view, options, jobs, report);
    if (auto written = speed_error::write_report(options.out, report); !written) return written.error();
    return asked;
}

void tell(const Report& report, const Options& options) {
    for (const Row& row : report.rows) {
        fmt::print("{:28} {:34} {:9.1f} core-ms  relMSE {:9.3g}{} FLIP {:.4f}  efficiency {:.3g}\n", row.view,
                   row.contestant, row.core_ms, row.rel_mse, speed_error::is_doubtful(row) ? " *" : "  ",
                   row.flip, row.efficiency());
    }
    print(report.findings);
    if (const std::size_t doubtful = speed_error::count_doubtful(report.rows); doubtful > 0) {
        fmt::print(
            "\n{} of {} rows (*) are less than twenty times as wrong as their truth: more "
            "--reference-samples\n",
            doubtful, report.rows.size());
    }
    fmt::print("{}\n", (std::filesystem::path(options.out) / "report.html").string());
}

void add_options(CLI::App& app, Options& options) {
    app.add_option("SCENE", options.scene, "a level's name, or any .gltf or .glb")->capture_default_str();
    app.add_option("--camera", options.cameras,
                   "cameras of the scene, or x,y,z,yaw,pitch,fov; three of its own otherwise");
    app.add_option(
        "--only", options.only,
        "judge no more than the ways whose name holds this text: \"real time\", \"Sobol\", \"guard walks\"");
    app.add_option("--out", options.out, "folder of report.html, report.json and the pictures")
        ->capture_default_str();
    app.add_option("--width", options.width, "pixels")->check(CLI::Range(16, 4096))->capture_default_str();
    app.add_option("--height", options.height, "pixels")->check(CLI::Range(16, 4096))->capture_default_str();
    app.add_option("--reference-samples", options.reference_samples, "samples a pixel of a reference")
        ->check(CLI::Range(2, 1 << 20))
        ->capture_default_str();
    app.add_option("--reference", options.picture,
                   "somebody else's converged picture of the view (EXR): how far ours is from it");
    app.add_flag("--cycles", options.asks_cycles,
                 "also Blender's Cycles, at equal time (Debian: blender, python3-numpy)");
    app.add_option("--cycles-samples", options.cycles_samples,
                   "samples a pixel; its own truth has 64 times as many")
        ->check(CLI::Range(1, 4096))
        ->capture_default_str();
    app.add_option("--runs", options.runs, "pictures with other seeds")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--threads", options.threads, "0: one for every core")->check(CLI::Range(0, 256));
    app.add_flag("--quick", options.is_quick, "one view, few samples, small: within a minute");
}

void make_quick(Options& options) {
    options.width = std::min(options.width, 160);
    options.height = std::min(options.height, 90);
    options.reference_samples = std::min(options.reference_samples, 128);
    options.runs = std::min(options.runs, 2);
}

int judge_all(const Options& options) {
    const Jobs jobs(options.threads);
    const auto studio = speed_error::open_studio(options.scene, jobs);
    if (!studio) return complain(studio.error().sentence);
    Report report = speed_error::earlier_report(options.out);
    report.machine = fmt::format("{} threads, {}, {}x{}", jobs.threads(), rc::isa_name(rc::active_isa()),
                                 options.width, options.height);
    for (const std::string& name : views_of(*studio->level, options)) {
        const auto camera = app::camera_named(*studio->level, studio->snapshot, name);
        if (!camera) return complain(camera.error().sentence);
        const View view{*studio, studio->level->name + (name.empty() ? "" : "_" + name), *camera,
                        speed_error::scene_key(*studio->level, *camera)};
        if (auto judged = judge_view(view, options, jobs, report); !judged)
            return complain(judged.error().sentence);
    }
    tell(report, options);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        Options options;
        CLI::App app("Renders views in every way and says how wrong each is for what it costs.",
                     "speed_error");
        add_options(app, options);
        try {
            app.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            return app.exit(error) == 0 ? 0 : 2;
        }
        if (options.is_quick) make_quick(options);
        return judge_all(options);
    } catch (const std::exception& error) {
        return complain(error.what());
    }
}

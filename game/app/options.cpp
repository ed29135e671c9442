#include "app/options.h"

#include "app/settings.h"
#include "present/menu.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <iostream>
#include <string_view>

namespace gh::app {

namespace {

constexpr int kMaxSide = 16384;  // pixels: more is a slip of the finger, and gigabytes

std::optional<Size> size_from(const std::string& text) {
    Size size;
    const char* const end = text.data() + text.size();
    const auto [cross, width_error] = std::from_chars(text.data(), end, size.width);
    if (width_error != std::errc() || cross == end || (*cross != 'x' && *cross != 'X')) return std::nullopt;
    const auto [rest, height_error] = std::from_chars(cross + 1, end, size.height);
    if (height_error != std::errc() || rest != end) return std::nullopt;
    const bool fits =
        1 <= size.width && size.width <= kMaxSide && 1 <= size.height && size.height <= kMaxSide;
    return fits ? std::optional(size) : std::nullopt;
}

// CLI::Range takes NaN for a number of any range.
CLI::Validator between(double least, double most) {
    const std::string range = fmt::format("{} to {}", least, most);
    return {[least, most, range](std::string& text) {
                double number = 0.0;
                const bool fits =
                    CLI::detail::lexical_cast(text, number) && least <= number && number <= most;
                return fits ? std::string() : fmt::format("'{}' is not a number from {}", text, range);
            },
            "from " + range};
}

void add_size(CLI::App& command, Size& size) {
    command
        .add_option_function<std::string>(
            "--size",
            [&size](const std::string& text) {
                const std::optional<Size> parsed = size_from(text);
                if (!parsed)
                    throw CLI::ValidationError(
                        "--size", "'" + text + "' is not WIDTHxHEIGHT between 1x1 and 16384x16384");
                size = *parsed;
            },
            "picture size in pixels")
        ->type_name("WxH");
}

void add_quality(CLI::App& command, std::string& quality) {
    command
        .add_option("--quality", quality, "of the window: low, medium, high, ultra; otherwise as in the menu")
        ->check(CLI::IsMember(
            std::vector<std::string>(present::kQualityWords.begin(), present::kQualityWords.end())))
        ->type_name("NAME");
}

void add_machine(CLI::App& command, MachineOptions& machine) {
    command.add_option("--threads", machine.threads, "threads to use; 0: all cores")
        ->check(CLI::Range(0, 1024))
        ->type_name("N");
    command
        .add_option_function<std::string>(
            "--isa",
            [&machine](const std::string& name) {
                const std::optional<rc::Isa> isa = rc::isa_from_name(name);
                if (!isa)
                    throw CLI::ValidationError("--isa", "'" + name + "' is not one of scalar, avx2, avx512");
                if (!rc::is_isa_supported(*isa))
                    throw CLI::ValidationError("--isa", "this machine has no " + name);
                machine.isa = isa;
            },
            "instructions to use: scalar, avx2, avx512; all give the same bits")
        ->type_name("NAME");
}

void add_renderer(CLI::App& command, RendererOptions& o) {
    command.add_option("--renderer", o.renderer, "how light is computed")
        ->check(CLI::IsMember({"whitted", "cook", "path"}))
        ->capture_default_str();
    command.add_option("--sampler", o.sampler, "path: where its random numbers come from")
        ->check(CLI::IsMember({"iid", "jittered", "sobol", "bluenoise"}))
        ->capture_default_str();
    command.add_option("--seed", o.seed, "path: another one is another, independent picture")->type_name("N");
    command.add_option("--depth", o.max_depth, "path: most bounces")
        ->check(CLI::Range(0, 199))
        ->capture_default_str()
        ->type_name("N");
    command
        .add_option("--clamp", o.clamp,
                    "path: most that a bounce may bring at once, in multiples of white; 0: whatever it does")
        ->check(between(0.0, 1e9))
        ->capture_default_str()
        ->type_name("X");
    command
        .add_option("--roughen", o.least_indirect_roughness,
                    "path: least roughness of gloss that scattered light meets; 0: its own")
        ->check(between(0.0, 1.0))
        ->capture_default_str()
        ->type_name("X");
    command.add_flag("--unbiased", o.is_unbiased,
                     "path: --clamp 0 --roughen 0, all light there is and all its noise");
    command.add_option("--sky", o.sky, "path: a picture of all directions for what lies outside")
        ->type_name("FILE");
    command.add_flag("--denoise", o.is_denoised, "path: filter what noise is left");
    command.add_option("--filter", o.filter, "cook, path: how samples make a pixel: box, tent, gaussian")
        ->check(CLI::IsMember({"box", "tent", "gaussian"}));
    command.add_option("--aperture", o.aperture, "cook, path: radius of the lens in metres; 0: all is sharp")
        ->check(between(0.0, 10.0))
        ->type_name("M");
    command.add_option("--focus", o.focus, "cook, path: metres to what is sharp")
        ->check(between(1e-3, 1e6))
        ->capture_default_str()
        ->type_name("M");
    command.add_flag_callback(
        "--unbent", [&o] { o.bends_light = false; },
        "path: lamps shine straight through clear glass, and nothing focuses them");
}

void add_replay(CLI::App& replay, ReplayOptions& o) {
    replay.add_option("FILE", o.file, "a recording")->required();
    replay.add_flag("--verify", o.verifies,
                    "compare every tick's state with the recorded hash; exit 3 where they part");
    replay.add_flag("--window", o.opens_window, "watch it in a window");
    add_quality(replay, o.quality);
    replay.add_option("--frames", o.frames, "write pictures into this folder")->type_name("DIR");
    replay.add_option("--every", o.every, "one picture every N ticks")
        ->check(CLI::Range(1, 1'000'000))
        ->type_name("N");
    replay
        .add_option("--spp", o.samples_per_pixel,
                    "samples a pixel; whitted with 1 smooths edges as the window does")
        ->check(CLI::Range(1, 65536))
        ->type_name("N");
    add_renderer(replay, o.renderer);
    replay
        .add_option("--shutter", o.renderer.shutter,
                    "cook, path: how long it is open, in pictures: what the eye's own motion blurs")
        ->check(between(0.0, 1.0))
        ->type_name("X");
    replay.add_flag("--exr", o.writes_exr, "write pictures as EXR, linear and unexposed, instead of PNG");
    replay.add_option("--audio", o.audio, "write the sound to this file")->type_name("FILE.wav");
    add_size(replay, o.size);
    add_machine(replay, o.machine);
}

void add_render(CLI::App& render, RenderOptions& o) {
    render.add_option("SCENE", o.scene, "a level's name, or any .gltf or .glb")->required();
    render.add_option("-o,--output", o.output, "OUT.png or OUT.exr")->required()->type_name("FILE");
    render.add_option("--camera", o.camera, "a camera of the file, or x,y,z,yaw,pitch,fov (metres, degrees)")
        ->type_name("NAME");
    add_renderer(render, o.renderer);
    render.add_option("--spp", o.samples_per_pixel, "samples a pixel")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str()
        ->type_name("N");
    render.add_flag("--adaptive", o.is_adaptive,
                    "whitted: work out light for fewer pixels where it changes little, as the window does");
    add_size(render, o.size);
    add_machine(render, o.machine);
}

}  // namespace

std::variant<Options, int> parse_options(int argc, char** argv) {
    PlayOptions play;
    ReplayOptions replay;
    RenderOptions render;
    InspectOptions inspect;

    CLI::App app("Glasshouse: a stealth game that is ray traced throughout.", "glasshouse");
    app.footer("Settings and keys are kept in " + settings_path().string() + ",\nrecordings in " +
               recordings_path().string() + ".");
    app.set_version_flag("--version", GLASSHOUSE_VERSION);
    app.add_option("LEVEL", play.level, "a level under assets/levels, or any .gltf or .glb")
        ->capture_default_str();
    app.add_option("--record", play.record, "where the run is recorded")->type_name("FILE");
    app.add_option("--renderer", play.renderer,
                   "how light is computed: cook and path are slower, noisier and more true")
        ->check(CLI::IsMember({"whitted", "cook", "path"}))
        ->capture_default_str();
    add_quality(app, play.quality);
    app.add_flag("--fullscreen", play.is_fullscreen, "take the whole screen");
    add_size(app, play.size);
    add_machine(app, play.machine);
    CLI::App* replay_command =
        app.add_subcommand("replay", "play a recording again, headless unless --window is given");
    add_replay(*replay_command, replay);
    CLI::App* render_command = app.add_subcommand("render", "one picture of a level or any glTF scene");
    add_render(*render_command, render);
    CLI::App* inspect_command =
        app.add_subcommand("inspect", "what is in a level, scene or recording, in a page");
    inspect_command->add_option("FILE", inspect.file, "a level's name, .gltf, .glb or a recording")
        ->required();
    app.require_subcommand(0, 1);

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
        std::cerr << "glasshouse: " << error.what() << " (see --help)\n";
        return 2;
    }
    if (replay_command->parsed()) return Options(replay);
    if (render_command->parsed()) return Options(render);
    if (inspect_command->parsed()) return Options(inspect);
    return Options(play);
}

}  // namespace gh::app

// glasshouse inspect: what is in a level, scene or recording, in a page.
#include "load/inspect.h"

#include "app/assets.h"
#include "app/commands.h"
#include "app/printable.h"
#include "input/replay.h"
#include "load/level_loader.h"
#include "render/scene_needs.h"
#include "world/state.h"

#include <fmt/format.h>

#include <array>
#include <iostream>

namespace gh::app {

namespace {

struct Held {
    const char* what;
    input::Button button;
};
constexpr std::array kHeld = {
    Held{"running", input::Run},
    Held{"crouching", input::Crouch},
    Held{"jumping", input::Jump},
    Held{"leaning left", input::LeanLeft},
    Held{"leaning right", input::LeanRight},
    Held{"using", input::Use},
    Held{"aiming a stone", input::Throw},
    Held{"raising the mirror", input::HandMirror},
};

std::string describe_replay(const std::string& name, const input::Replay& replay) {
    const input::ReplayHeader& header = replay.header;
    std::string page = fmt::format("{}: a recording of '{}'\n", name, header.level_name);
    page += fmt::format("  {:<24}{} ({:.1f} s){}\n", "ticks", replay.ticks(),
                        static_cast<double>(replay.ticks()) / world::kTicksPerSecond,
                        replay.is_cut_short ? ", cut short" : "");
    page += fmt::format("  {:<24}{}\n", "simulation version", header.simulation_version);
    page += fmt::format("  {:<24}{:016x}\n", "level hash", header.level_hash);
    page += fmt::format("  {:<24}{:016x}\n", "navmesh hash", header.navmesh_hash);
    page += fmt::format("  {:<24}{}\n", "seed", header.seed);
    if (!replay.state_hashes.empty())
        page += fmt::format("  {:<24}{:016x}\n", "final hash", replay.state_hashes.back());
    page += "  ticks spent\n";
    std::size_t walking = 0;
    for (const input::Command& command : replay.commands)
        walking += command.move_right != 0 || command.move_forward != 0;
    page += fmt::format("    {:<22}{}\n", "walking", walking);
    for (const Held& held : kHeld) {
        std::size_t ticks = 0;
        for (const input::Command& command : replay.commands) ticks += command.is_held(held.button);
        page += fmt::format("    {:<22}{}\n", held.what, ticks);
    }
    return page;
}

}  // namespace

int inspect(const InspectOptions& options) {
    const std::filesystem::path path = options.file;
    if (path.extension() == ".rec" || path.extension() == ".part") {
        const auto replay = input::read_replay(path);
        if (!replay) return refuse(replay.error());
        std::cout << printable(describe_replay(path.string(), *replay));
        return kExitFine;
    }
    const auto level = resolve_level(options.file);
    if (!level) return refuse(level.error());
    const auto page = load::describe_level(*level);
    if (!page) return refuse(page.error());
    const auto loaded = load::load_level(*level, {.finds_ways = false});
    if (!loaded) return refuse(loaded.error());
    std::cout << printable(page->text + "  needs      " + render::sentence_of(render::scene_needs(*loaded)) +
                           "\n");
    if (page->errors > 0)
        return refuse({fmt::format("{}: {} error{}, told of above", options.file, page->errors,
                                   page->errors == 1 ? "" : "s")});
    return kExitFine;
}

}  // namespace gh::app

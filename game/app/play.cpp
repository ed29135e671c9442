// glasshouse [LEVEL]: the game in its window.
#include "app/assets.h"
#include "app/commands.h"
#include "app/loop.h"
#include "app/quality.h"

#include <iostream>

namespace gh::app {

int play(const PlayOptions& options) {
    const auto path = resolve_level(options.level);
    if (!path) return refuse(path.error());
    // The window first: without a display there is no point in loading.
    auto window = present::Window::open({.title = "Glasshouse",
                                         .width = options.size.width,
                                         .height = options.size.height,
                                         .is_fullscreen = options.is_fullscreen});
    if (!window) return refuse(window.error());
    auto session = open_session(*path, 0, options.machine);
    if (!session) return refuse(session.error());
    session->prepare_pictures();

    // A file given by path is found again from any folder.
    const bool is_bundled = *path != std::filesystem::path(options.level);
    const std::string name = is_bundled ? options.level : std::filesystem::absolute(*path).string();
    Loop loop(*session, *window, name);
    if (const auto lights = light_paths(options.renderer)) loop.trace_paths(*lights);
    if (const auto quality = quality_named(options.quality)) loop.use_quality(*quality);
    return loop.run(options.record) ? kExitFine : kExitUnusable;
}

}  // namespace gh::app

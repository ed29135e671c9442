#include "app/assets.h"

#include <cstdlib>

namespace gh::app {

namespace fs = std::filesystem;

namespace {

bool holds_levels(const fs::path& folder) {
    std::error_code ignored;
    return fs::is_directory(folder / "levels", ignored);
}

}  // namespace

Result<fs::path> find_assets() {
    if (const char* named = std::getenv("GLASSHOUSE_ASSETS")) {
        if (holds_levels(named)) return fs::path(named);
        return Error{std::string("GLASSHOUSE_ASSETS: '") + named + "' has no folder 'levels'"};
    }
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (error) return Error{"assets: cannot tell where the program is: " + error.message()};
    for (fs::path folder = program.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
        if (holds_levels(folder / "assets")) return folder / "assets";
        if (holds_levels(folder / "share/glasshouse/assets")) return folder / "share/glasshouse/assets";
    }
    return Error{"assets: no folder 'assets/levels' is to be found above " + program.string() +
                 "; set GLASSHOUSE_ASSETS"};
}

Result<fs::path> resolve_level(const std::string& name_or_path) {
    const fs::path path = name_or_path;
    const bool is_file_name =
        path.extension() == ".glb" || path.extension() == ".gltf" || path.has_parent_path();
    if (is_file_name) return path;
    Result<fs::path> assets = find_assets();
    if (!assets) return assets.error();
    fs::path level = *assets / "levels" / (name_or_path + ".glb");
    std::error_code ignored;
    if (fs::exists(level, ignored)) return level;
    return Error{"level '" + name_or_path + "': there is no " + level.string()};
}

}  // namespace gh::app

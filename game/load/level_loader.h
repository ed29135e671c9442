// load/level_loader.h - a glTF file becomes a Level: geometry, materials, lamps, and what its extras say of
// doors, mirrors, guards and goals (assets/README.md). A file without extras becomes a level too: a place to
// stand is found in it, its emissive panels light it or else a sun does, and there is nothing to steal.
//
// Cost      about a second for a million triangles; memory bounded by the limits in load/limits.h.
// Threads   any number at once on different files; nothing is shared.
// Same bits everything the simulation reads is computed without the C library's elementary functions.
// Bad input truncated, damaged, oversized or contradictory files give one sentence that names file, item and
//           reason. What comes back has passed check_ranges (level_check.h), so nobody behind it checks
//           again.
#pragma once

#include "base/result.h"
#include "world/level.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace gh::load {

struct LoadOptions {
    bool finds_ways = true;  // false: no navmesh is read or baked, which a picture does not need
    // Parts that stand still become one, for speed (fuse_parts.h). False: parts are the file's nodes.
    bool fuses_parts = true;
    bool hangs_sun = true;  // where nothing shines
};

// Reads .glb or .gltf (told apart by content). A navmesh beside it (foyer.glb: foyer.navmesh) is used when it
// was baked from this very geometry; otherwise one is baked now, where somebody could walk it.
[[nodiscard]] Result<world::Level> load_level(const std::filesystem::path& path,
                                              const LoadOptions& options = {});

// The same from bytes; `name` is for sentences, external buffers and images are looked for in `base_dir`
// (empty: refused), and no navmesh file is looked for.
[[nodiscard]] Result<world::Level> load_level_from_memory(std::span<const std::byte> bytes,
                                                          const std::string& name,
                                                          const std::filesystem::path& base_dir,
                                                          const LoadOptions& options = {});

}  // namespace gh::load

// The kernels there are: all of a tile in one unit, once for each set of features.
#include "render/path_kernels.h"

#include "render/path_tile.inl"
#include "render/path_tile_planes.inl"
#include "render/path_tile_scatter.inl"
#include "render/path_tile_shade.inl"

#include <memory>

namespace gh::render {

namespace {

template <unsigned kFeatures>
void trace_with(const PathFrame& frame, const Jobs& jobs, Film& film) {
    const int across = (frame.width + kPathTileSide - 1) / kPathTileSide;
    const int down = (frame.height + kPathTileSide - 1) / kPathTileSide;
    const auto tiles = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
    std::vector<FrameStats> stats(tiles);
    std::vector<std::unique_ptr<PathTile<kFeatures>>> tracers(static_cast<std::size_t>(jobs.threads()));
    jobs.run(tiles, [&](std::size_t tile, int worker) {
        auto& tracer = tracers[static_cast<std::size_t>(worker)];
        if (tracer == nullptr) tracer = std::make_unique<PathTile<kFeatures>>(frame);
        tracer->trace(static_cast<int>(tile) % across, static_cast<int>(tile) / across, film, stats[tile]);
    });
    for (const FrameStats& tile : stats) film.stats += tile;
}

}  // namespace

void trace_tiles(const PathFrame& frame, unsigned features, const Jobs& jobs, Film& film) {
    switch (features) {
        case 0:
            return trace_with<0>(frame, jobs, film);
        case kClearKernel:
            return trace_with<kClearKernel>(frame, jobs, film);
        case kPlanesKernel:
            return trace_with<kPlanesKernel>(frame, jobs, film);
        default:
            return trace_with<kAllFeatures>(frame, jobs, film);
    }
}

}  // namespace gh::render

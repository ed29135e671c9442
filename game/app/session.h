// app/session.h - one run of one level: what play and replay have in common.
#pragma once

#include "app/options.h"
#include "base/jobs.h"
#include "base/result.h"
#include "render/prepared.h"
#include "sim/simulation.h"
#include "world/level.h"

#include <filesystem>
#include <memory>

namespace gh::app {

struct Session {
    std::filesystem::path level_path;
    std::unique_ptr<Jobs> jobs;
    std::shared_ptr<const world::Level> level;
    std::unique_ptr<sim::Simulation> simulation;
    std::unique_ptr<render::Prepared> prepared;  // null until prepare_pictures

    // Once, before the first picture; the simulation does not need it.
    void prepare_pictures();
    // From the first tick again.
    void restart(std::uint32_t seed);
};

[[nodiscard]] Result<Session> open_session(const std::filesystem::path& level_path, std::uint32_t seed,
                                           const MachineOptions& machine);

}  // namespace gh::app

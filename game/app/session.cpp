#include "app/session.h"

#include "app/commands.h"
#include "load/level_loader.h"

namespace gh::app {

void Session::restart(std::uint32_t seed) {
    jobs->run_in([&] { simulation = std::make_unique<sim::Simulation>(level, seed, jobs.get()); });
}

void Session::prepare_pictures() {
    if (prepared != nullptr) return;
    prepared = std::make_unique<render::Prepared>(render::prepare(*level, *simulation->snapshot(), *jobs));
}

Result<Session> open_session(const std::filesystem::path& level_path, std::uint32_t seed,
                             const MachineOptions& machine) {
    apply(machine);
    auto loaded = load::load_level(level_path);
    if (!loaded) return loaded.error();
    Session session;
    session.level_path = level_path;
    session.jobs = std::make_unique<Jobs>(machine.threads);
    session.level = std::make_shared<const world::Level>(*std::move(loaded));
    tell(*session.level);
    session.restart(seed);
    return session;
}

}  // namespace gh::app

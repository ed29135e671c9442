#include "studio.h"

#include "app/assets.h"
#include "base/hash.h"
#include "load/level_loader.h"
#include "world/initial_state.h"

#include <utility>

namespace speed_error {

gh::Result<Studio> open_studio(const std::string& scene, const gh::Jobs& jobs) {
    const auto path = gh::app::resolve_level(scene);
    if (!path) return path.error();
    auto loaded = gh::load::load_level(*path, {.finds_ways = false});
    if (!loaded) return loaded.error();
    Studio studio;
    studio.level = std::make_shared<const gh::world::Level>(*std::move(loaded));
    jobs.run_in([&] { studio.stage = std::make_unique<gh::spatial::Stage>(studio.level); });
    gh::world::State state = gh::world::initial_state(*studio.level, 0);
    studio.snapshot = studio.stage->commit(state, jobs);
    state.group_on.fill(0);
    studio.dark = studio.stage->commit(state, jobs);
    studio.prepared = gh::render::prepare(*studio.level, studio.snapshot, jobs);
    return studio;
}

std::uint64_t scene_key(const gh::world::Level& level, const gh::render::Camera& camera) {
    gh::Hasher hash;
    hash.add(level.file_hash);
    hash.add(camera.position);
    hash.add(camera.yaw);
    hash.add(camera.pitch);
    hash.add(camera.fov_y);
    return hash.digest();
}

}  // namespace speed_error

// speed_error/studio.h - a scene opened for pictures, as it is and with its lamps switched off.
#pragma once

#include "base/jobs.h"
#include "base/result.h"
#include "render/camera.h"
#include "render/prepared.h"
#include "render/scene_view.h"
#include "spatial/stage.h"

#include <cstdint>
#include <memory>
#include <string>

namespace speed_error {

struct Studio {
    std::shared_ptr<const gh::world::Level> level;
    std::unique_ptr<gh::spatial::Stage> stage;
    gh::world::Snapshot snapshot;
    gh::world::Snapshot dark;  // every lamp that has a switch is off
    gh::render::Prepared prepared;

    [[nodiscard]] gh::render::SceneView lit_view() const { return {*level, snapshot, prepared}; }
    [[nodiscard]] gh::render::SceneView dark_view() const { return {*level, dark, prepared}; }
    [[nodiscard]] bool has_switches() const { return !level->lamp_groups.empty(); }
};

// A level's name, or any .gltf or .glb.
[[nodiscard]] gh::Result<Studio> open_studio(const std::string& scene, const gh::Jobs& jobs);

// One picture's worth of a studio, and what its figures are filed under.
struct View {
    const Studio& studio;
    std::string name;
    gh::render::Camera camera;
    std::uint64_t key;
};

// Changes with the level, what is on in it, and the camera.
[[nodiscard]] std::uint64_t scene_key(const gh::world::Level& level, const gh::render::Camera& camera);

}  // namespace speed_error

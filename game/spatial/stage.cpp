#include "spatial/stage.h"

#include "base/contracts.h"
#include "spatial/pose.h"
#include "spatial/transforms.h"
#include "spatial/wardrobe.h"

#include "raycore/blas.h"
#include "raycore/scene.h"

#include <utility>
#include <vector>

namespace gh::spatial {
namespace {

// A part that bends, and what it wears.
struct Actor {
    std::uint32_t part = world::kNoIndex;
    std::uint32_t guard = world::kNoIndex;
    std::uint32_t model = world::kNoIndex;
    std::shared_ptr<Wardrobe> wardrobe;     // one a model: guards alike share bodies
    std::shared_ptr<const PosedBody> worn;  // in the last Snapshot
};

bool bends(const world::Level& level, const world::Part& part) {
    if (part.mover != world::Mover::Guard) return false;
    const std::uint32_t model = level.guards[part.mover_index].model;
    return model != world::kNoIndex && level.models[model].mesh == part.mesh &&
           !level.meshes[part.mesh].joints.empty();
}

std::vector<Actor> cast_of(const world::Level& level) {
    std::vector<Actor> actors;
    std::vector<std::shared_ptr<Wardrobe>> wardrobes(level.models.size());
    for (std::size_t p = 0; p < level.parts.size(); ++p) {
        const world::Part& part = level.parts[p];
        if (!bends(level, part)) continue;
        const std::uint32_t model = level.guards[part.mover_index].model;
        if (!wardrobes[model]) {
            wardrobes[model] = std::make_shared<Wardrobe>(level.models[model], level.meshes[part.mesh]);
        }
        actors.push_back({.part = static_cast<std::uint32_t>(p),
                          .guard = part.mover_index,
                          .model = model,
                          .wardrobe = wardrobes[model],
                          .worn = nullptr});
    }
    return actors;
}

// Changes the shape of every actor whose pose is not the one it wears; the others keep theirs, tree and all.
void dress(const world::State& state, const Jobs* jobs, std::vector<Actor>& actors) {
    struct Change {
        std::size_t actor;
        PoseKey key;
        std::unique_ptr<PosedBody> body;
    };
    std::vector<Change> changes;
    for (std::size_t a = 0; a < actors.size(); ++a) {
        const PoseKey key = pose_key(state.guards[actors[a].guard]);
        if (actors[a].worn && actors[a].worn->key == key) continue;
        changes.push_back({.actor = a, .key = key, .body = actors[a].wardrobe->take()});
    }
    const auto pose_one = [&](std::size_t i) {
        actors[changes[i].actor].wardrobe->pose(changes[i].key, *changes[i].body);
    };
    if (jobs != nullptr && changes.size() > 1) {
        jobs->run(changes.size(), [&](std::size_t i, int) { pose_one(i); });
    } else {
        for (std::size_t i = 0; i < changes.size(); ++i) pose_one(i);
    }
    for (Change& change : changes) {
        Actor& actor = actors[change.actor];
        actor.worn = actor.wardrobe->publish(std::move(change.body));
    }
}

}  // namespace

struct Stage::Data {
    std::shared_ptr<const world::Level> level;
    std::vector<Actor> actors;  // their wardrobes read the level
    rc::SceneBuilder builder;
    std::vector<std::uint32_t> movable_parts;

    void set_the_scene();
    [[nodiscard]] world::Snapshot commit(const world::State& state, const Jobs* jobs);
    [[nodiscard]] Gaze gaze_of_guard(const world::State& state, std::size_t guard) const;
};

// Builds a tree for every mesh that never bends, and puts all parts where they rest.
void Stage::Data::set_the_scene() {
    std::vector<std::shared_ptr<const rc::Blas>> trees(level->meshes.size());
    for (std::size_t p = 0; p < level->parts.size(); ++p) {
        const world::Part& part = level->parts[p];
        std::shared_ptr<const rc::Blas>& tree = trees[part.mesh];
        if (!tree && !bends(*level, part)) {
            const world::Mesh& mesh = level->meshes[part.mesh];
            tree = rc::build_blas({.positions = mesh.positions, .triangles = mesh.triangles},
                                  {.quality = rc::BuildQuality::High, .can_refit = false});
        }
        builder.add({.blas = tree, .world_from_instance = part.mover_from_part, .layers = part.layers});
        if (part.mover != world::Mover::None) movable_parts.push_back(static_cast<std::uint32_t>(p));
    }
}

Gaze Stage::Data::gaze_of_guard(const world::State& state, std::size_t guard) const {
    Gaze gaze = gaze_of(world::Model{}, state.guards[guard].head_yaw, {});
    for (const Actor& actor : actors) {
        if (actor.guard != guard) continue;
        gaze = gaze_of(level->models[actor.model], state.guards[guard].head_yaw, actor.worn->skin);
        break;
    }
    const glm::mat4x3 world_from_model = world_from_guard(state, guard);
    return {.eye = point_through(world_from_model, gaze.eye),
            .look = vector_through(world_from_model, gaze.look)};
}

world::Snapshot Stage::Data::commit(const world::State& state, const Jobs* jobs) {
    dress(state, jobs, actors);
    for (const std::uint32_t part : movable_parts) {
        builder.set_transform(part, world_from_part(*level, state, part));
        builder.set_layers(part, layers_of_part(*level, state, part));
    }
    world::Snapshot snapshot;
    snapshot.posed.resize(level->parts.size());
    for (const Actor& actor : actors) {
        // Both share the body's one count: it goes home when scene and pose are let go of.
        builder.set_blas(actor.part, std::shared_ptr<const rc::Blas>(actor.worn, actor.worn->blas.get()));
        snapshot.posed[actor.part] = std::shared_ptr<const world::PosedMesh>(actor.worn, &actor.worn->mesh);
    }
    snapshot.scene = builder.commit();
    snapshot.state = state;
    for (std::size_t m = 0; m < level->mirrors.size(); ++m)
        snapshot.panes.push_back(mirror_pane(*level, state, m));
    for (std::size_t g = 0; g < level->guards.size(); ++g) {
        const Gaze gaze = gaze_of_guard(state, g);
        snapshot.guard_eyes.push_back(gaze.eye);
        snapshot.guard_looks.push_back(gaze.look);
    }
    return snapshot;
}

Stage::Stage(std::shared_ptr<const world::Level> level) : data_(std::make_unique<Data>()) {
    EXPECTS(level != nullptr);
    data_->level = std::move(level);
    data_->actors = cast_of(*data_->level);
    data_->set_the_scene();
}

Stage::~Stage() = default;

world::Snapshot Stage::commit(const world::State& state) {
    return data_->commit(state, nullptr);
}

world::Snapshot Stage::commit(const world::State& state, const Jobs& jobs) {
    return data_->commit(state, &jobs);
}

const world::Level& Stage::level() const {
    return *data_->level;
}

}  // namespace gh::spatial

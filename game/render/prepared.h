// render/prepared.h - what the renderer works out once for a level: smaller copies of its textures, which lamps each
// corner can see, and the light its walls give back.
//
// Cost      2.4 s of one core for the museum, 1.8 of them for baked light; about 1.4 s on two. A player waits for it.
// Threads   immutable once made. Borrows the Level, which must stay where it is and outlive it.
// Same bits a function of its arguments; never of the number of threads.
#pragma once

#include "base/jobs.h"
#include "render/ambient.h"
#include "render/emitters.h"
#include "render/gleams.h"
#include "render/gloss.h"
#include "render/gloss_energy.h"
#include "render/lamp.h"
#include "render/lamp_lists.h"
#include "render/material_textures.h"
#include "render/scene_needs.h"
#include "render/texture.h"
#include "world/level.h"
#include "world/snapshot.h"

#include <cstdint>
#include <vector>

namespace gh::render {

struct PrepareSettings {
    bool bakes_ambient = true;
    float spacing = 1.5f;  // metres between points of light
    std::size_t max_cells = 12'000;
    int rays = 96;    // from each point
    int bounces = 3;  // off walls; 1: light that was reflected once
    int lamp_list_rays = 8;
};

// What a part is to light.
struct PartTraits {
    std::uint32_t lamp = world::kNoIndex;  // it is this lamp's bulb
    bool is_clear = false;                 // something in it lets light through
    bool is_solid_glass = false;           // its clear triangles close a volume: light bends in and out of it
};

struct Prepared {
    std::vector<MipTexture> textures;
    std::vector<PartTraits> parts;
    SceneNeeds needs;
    std::vector<MaterialTextures> material_textures;  // one a material
    std::vector<BulbClearance> bulbs;                 // one a lamp
    LampLists lamp_lists;
    AmbientBake ambient;
    GlossTable gloss;
    std::vector<Emitter> emitters;  // what a path looks for besides lamps without a mesh
    Gleams gleams;                  // what lamps light so close by that a path looks for it as well
    GlossEnergy energy = GlossEnergy::none();
    bool has_clear_parts = false;
    // What surely blocks a shadow ray: the Blocker parts of a level that says which they are, else all that is drawn,
    // and then what blocks must be looked at again.
    rc::LayerMask blocking_layers = 0;
};

// `rest` is the world the light is baked in: the level's first tick, doors closed.
[[nodiscard]] Prepared prepare(const world::Level& level, const world::Snapshot& rest, const Jobs& jobs,
                               const PrepareSettings& settings = {});

}  // namespace gh::render

// render/scene_view.h - all a picture is made from, borrowed.
#pragma once

#include "render/prepared.h"
#include "world/level.h"
#include "world/snapshot.h"

namespace gh::render {

class LastPicture;

struct SceneView {
    const world::Level& level;
    const world::Snapshot& snapshot;  // of this very level
    const Prepared& prepared;         // for this very level
    // The world of the picture before, by which Film::planes know what moved. Null: nothing did.
    const world::Snapshot* before = nullptr;
    // And that picture itself, by which a guide knows what is mirrored. Null: there was none.
    const LastPicture* last = nullptr;
};

}  // namespace gh::render

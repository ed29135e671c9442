// spatial/stage.h - turns a State into the Snapshot everybody asks: pose, refit what changed, rebuild the top level.
//
//   spatial::Stage stage(level);                        // once: builds every tree
//   const world::Snapshot now = stage.commit(state);    // every tick
//
// Cost      construction: a high-quality build of every mesh. commit: skinning and a refit for every guard whose pose
//           changed, then O(parts log parts) for the top level.
// Threads   one Stage belongs to one thread; its Snapshots are immutable and may be read, and dropped, on any. A body
//           that somebody still reads is never written: the next pose goes into another (wardrobe.h).
// Same bits a Snapshot answers as a pure function of (Level, State), whatever was committed before, on any number of
//           threads. Trees may differ after a rewind; answers can not.
// Bad input a checked Level, and a State made for it.
#pragma once

#include "base/jobs.h"
#include "world/level.h"
#include "world/snapshot.h"
#include "world/state.h"

#include <memory>

namespace gh::spatial {

class Stage {
  public:
    explicit Stage(std::shared_ptr<const world::Level> level);
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    // The world as `state` has it. With `jobs`, guards are posed side by side.
    [[nodiscard]] world::Snapshot commit(const world::State& state);
    [[nodiscard]] world::Snapshot commit(const world::State& state, const Jobs& jobs);

    [[nodiscard]] const world::Level& level() const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace gh::spatial

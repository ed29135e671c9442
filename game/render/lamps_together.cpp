#include "render/lamps_together.h"

#include "base/contracts.h"
#include "render/light_math.h"

#include <algorithm>

namespace gh::render {

void LampsTogether::ask(const SceneView& view, const FrameLight& light,
                        std::span<const SeenSurface* const> surfaces) {
    EXPECTS(surfaces.size() <= kLitTogether);
    surfaces_.count = surfaces.size();
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const SeenSurface& surface = *surfaces[i];
        set_lane(surfaces_.position, i, surface.at.surface.position);
        set_lane(surfaces_.normal, i, surface.at.normal);
        set_lane(surfaces_.geometric, i, surface.at.geometric);
        set_lane(surfaces_.to_eye, i, surface.gloss.to_eye);
        set_lane(surfaces_.f0, i, surface.gloss.f0);
        set_lane(surfaces_.diffuse, i, surface.path.weight * surface.diffuse * kPerPi);
        set_lane(surfaces_.weight, i, surface.path.weight);
        surfaces_.f90[i] = surface.gloss.f90;
        surfaces_.alpha[i] = surface.gloss.alpha;
    }
    find_cells(view.prepared.lamp_lists);
    sums_ = {};
    count_ = 0;
    for (std::uint32_t lamp = next_lamp(); lamp != world::kNoIndex; lamp = next_lamp()) {
        if (answers_.size() == count_) answers_.emplace_back();
        Answer& answer = answers_[count_];
        take(lamp, answer.light);
        if (light.lamp_on[lamp] == 0) continue;
        answer.lamp = lamp;
        if (add_lamp(view.level.lamps[lamp], light.lamps[lamp], surfaces_, answer.light, sums_)) ++count_;
    }
}

SurfaceLight LampsTogether::light(std::size_t i) const {
    SurfaceLight light;
    light.irradiance = lane(sums_.irradiance, i);
    light.shine = lane(sums_.shine, i);
    light.turns = sums_.turns_at(i);
    return light;
}

void LampsTogether::find_cells(const LampLists& lists) {
    cell_count_ = 0;
    for (std::size_t i = 0; i < surfaces_.count; ++i) {
        const std::size_t index = lists.grid.cell_index(lists.grid.cell_at(lane(surfaces_.position, i)));
        std::size_t cell = 0;
        while (cell < cell_count_ && cells_[cell].index != index) ++cell;
        if (cell == cell_count_) cells_[cell_count_++] = {index, lists.of_cell(index), 0};
        cell_of_[i] = cell;
    }
}

// The lowest id that is left in any list.
std::uint32_t LampsTogether::next_lamp() const {
    std::uint32_t lamp = world::kNoIndex;
    for (std::size_t i = 0; i < cell_count_; ++i) {
        const Cell& cell = cells_[i];
        if (cell.next < cell.near.lamps.size()) lamp = std::min(lamp, cell.near.lamps[cell.next]);
    }
    return lamp;
}

// Out of all lists that have it.
void LampsTogether::take(std::uint32_t lamp, LampLight& light) {
    std::array<float, kLitTogether> open{};
    for (std::size_t i = 0; i < cell_count_; ++i) {
        Cell& cell = cells_[i];
        if (cell.next < cell.near.lamps.size() && cell.near.lamps[cell.next] == lamp)
            open[i] = cell.near.open[cell.next++];
    }
    for (std::size_t i = 0; i < kLitTogether; ++i)
        light.asked[i] = i < surfaces_.count ? open[cell_of_[i]] : 0.0f;
}

}  // namespace gh::render

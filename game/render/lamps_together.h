// render/lamps_together.h - what lamps bring to a few surfaces that lie near each other: they know mostly the same lamps, so
// each lamp is asked for all of them at once.
//
// Same bits what a surface gets depends on it alone, not on those beside it.
// Threads   scratch memory for one thread.
#pragma once

#include "render/frame_light.h"
#include "render/lamp_light.h"
#include "render/main_surfaces.h"
#include "render/scene_view.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gh::render {

class LampsTogether {
  public:
    // Of one lamp, to one surface.
    struct Arrived {
        glm::vec3 light{0.0f};  // in the pixel, if nothing is in its way
        std::uint32_t lamp = 0;
        float open = 0.0f;  // about the share of the lamp that the lists say is in sight
    };

    // Asks the lamps that are on for at most kLitTogether surfaces.
    void ask(const SceneView& view, const FrameLight& light, std::span<const SeenSurface* const> surfaces);

    // What came of it for the i-th surface, lamp ids rising.
    template <class Visit>
    void visit(std::size_t i, Visit visit) const {
        for (std::size_t k = 0; k < count_; ++k) {
            const Answer& answer = answers_[k];
            if (answer.light.counts[i] > 0.0f)
                visit(Arrived{lane(answer.light.light, i), answer.lamp, answer.light.asked[i]});
        }
    }
    // The same of all lamps together.
    [[nodiscard]] SurfaceLight light(std::size_t i) const;

  private:
    // One lamp's; it was asked for those surfaces whose cells list it, by the share of it that they see.
    struct Answer {
        LampLight light;
        std::uint32_t lamp = 0;
    };
    // A cell that some of the surfaces lie in, and how far through its list we are.
    struct Cell {
        std::size_t index = 0;
        LampLists::Near near;
        std::size_t next = 0;
    };

    void find_cells(const LampLists& lists);
    [[nodiscard]] std::uint32_t next_lamp() const;
    void take(std::uint32_t lamp, LampLight& light);

    LitSurfaces surfaces_;
    std::array<Cell, kLitTogether> cells_;
    std::array<std::size_t, kLitTogether> cell_of_{};
    std::size_t cell_count_ = 0;
    std::vector<Answer> answers_;
    std::size_t count_ = 0;  // of these
    LampSums sums_;
};

}  // namespace gh::render

#include "render/grid.h"

namespace gh::render {

Grid make_grid(const world::Aabb& box, float spacing, std::size_t max_cells) {
    const glm::vec3 size = glm::max(box.max - box.min, glm::vec3(0.0f));
    const float longest = std::max({size.x, size.y, size.z});
    Grid grid;
    grid.origin = box.min;
    if (!(longest > 0.0f) || !std::isfinite(longest)) return grid;

    // A level of other units than metres, or a huge one, gets cells of a size that fits it.
    float edge = std::min(spacing, longest / 4.0f);
    for (;; edge *= 1.1f) {
        // Cells past 1e6 would not fit; then the count is surely too high.
        const glm::vec3 cells = glm::max(glm::ceil(size / edge), glm::vec3(1.0f)) + 1.0f;
        if (cells.x * cells.y * cells.z > static_cast<float>(max_cells)) continue;
        grid.cells = glm::ivec3(cells);
        break;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float extent = size[axis] > 0.0f ? size[axis] : edge;
        grid.spacing[axis] = extent / static_cast<float>(grid.cells[axis] - 1);
        grid.origin[axis] -= 0.5f * grid.spacing[axis];
    }
    return grid;
}

}  // namespace gh::render

// sim/grid_navmesh.h - a navmesh for rooms with a flat floor at y = 0, made of square cells: so that tests of guards
// do not depend on how load bakes.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace gh::test {

// Cells of `cell` metres from (min_x, min_z) on, `columns` x `rows` of them; is_free says which may be walked on.
struct Grid {
    float min_x = 0.0f;
    float min_z = 0.0f;
    float cell = 0.25f;
    int columns = 0;
    int rows = 0;
    std::function<bool(int column, int row)> is_free;
};

[[nodiscard]] std::vector<std::byte> grid_navmesh(const Grid& grid);

}  // namespace gh::test

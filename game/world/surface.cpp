#include "world/surface.h"

namespace gh::world {
namespace {

struct Row {
    std::string_view name;
    Acoustics acoustics;
};

// In the order of Surface. A carpet lies on a concrete slab, and it is the slab that a sound has to cross.
constexpr std::array<Row, kSurfaceCount> kRows{{
    {"marble", {{0.01f, 0.01f, 0.02f}, {55.0f, 67.0f, 79.0f}}},
    {"concrete", {{0.01f, 0.02f, 0.02f}, {54.0f, 66.0f, 78.0f}}},
    {"parquet", {{0.04f, 0.06f, 0.06f}, {54.0f, 66.0f, 78.0f}}},
    {"plaster", {{0.015f, 0.03f, 0.05f}, {46.0f, 58.0f, 70.0f}}},
    {"stud", {{0.10f, 0.04f, 0.09f}, {28.0f, 40.0f, 52.0f}}},
    {"glass", {{0.06f, 0.03f, 0.02f}, {21.0f, 33.0f, 45.0f}}},
    {"pane", {{0.25f, 0.12f, 0.04f}, {24.0f, 37.0f, 49.0f}}},
    {"oak", {{0.22f, 0.09f, 0.11f}, {30.0f, 42.0f, 54.0f}}},
    {"metal", {{0.04f, 0.05f, 0.07f}, {19.0f, 31.0f, 43.0f}}},
    {"curtain", {{0.35f, 0.72f, 0.65f}, {1.0f, 13.0f, 25.0f}}},
    {"ceiling", {{0.66f, 0.92f, 0.75f}, {15.0f, 27.0f, 39.0f}}},
    {"carpet", {{0.24f, 0.69f, 0.73f}, {54.0f, 66.0f, 78.0f}}},
}};

}  // namespace

std::string_view surface_name(Surface surface) {
    return kRows[static_cast<std::size_t>(surface)].name;
}

std::optional<Surface> surface_from_name(std::string_view name) {
    for (std::size_t i = 0; i < kRows.size(); ++i) {
        if (kRows[i].name == name) return static_cast<Surface>(i);
    }
    return std::nullopt;
}

const Acoustics& acoustics(Surface surface) {
    return kRows[static_cast<std::size_t>(surface)].acoustics;
}

}  // namespace gh::world

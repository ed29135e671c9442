// world/surface.h - what a material is to feet and ears. Figures: absorption and transmission loss per band at
// 250 Hz, 1 kHz and 4 kHz; TL = 20 log10(f m) - 47 dB by the mass law.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace gh::world {

enum class Surface : std::uint8_t {
    Marble,
    Concrete,
    Parquet,
    Plaster,
    Stud,
    Glass,
    Pane,
    Oak,
    Metal,
    Curtain,
    Ceiling,
    Carpet,
};
inline constexpr std::size_t kSurfaceCount = 12;
inline constexpr std::size_t kBands = 3;  // 250 Hz, 1 kHz, 4 kHz

struct Acoustics {
    std::array<float, kBands> absorption;            // share of the energy, 0..1
    std::array<float, kBands> transmission_loss_db;  // of a sound that crosses one wall of it
};

inline constexpr float kSpeedOfSound = 343.0f;  // m/s, in air of 20 degrees

// Where a table with one entry a surface has this one's.
[[nodiscard]] constexpr std::size_t index_of(Surface surface) {
    return static_cast<std::size_t>(surface);
}

[[nodiscard]] std::string_view surface_name(Surface surface);  // "marble", ...
[[nodiscard]] std::optional<Surface> surface_from_name(std::string_view name);
[[nodiscard]] const Acoustics& acoustics(Surface surface);

}  // namespace gh::world

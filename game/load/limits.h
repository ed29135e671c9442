// load/limits.h - how large a level may be. A small damaged file can claim anything; what would need more
// than this is refused with a sentence before anything is allocated for it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gh::load {

inline constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;
inline constexpr std::size_t kMaxExternalBytes = std::size_t{1} << 30;  // of all side files together
inline constexpr std::size_t kMaxJsonBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMaxJsonObjects = 500'000;  // each becomes up to a few hundred bytes
inline constexpr std::size_t kMaxJsonValues = 8'000'000;
inline constexpr int kMaxJsonDepth = 64;  // the parser behind us recurses
inline constexpr std::size_t kMaxBuffers = 64;

inline constexpr std::size_t kMaxVertices = std::size_t{1} << 25;  // of all meshes together
inline constexpr std::size_t kMaxTriangles = std::size_t{1} << 25;
inline constexpr std::size_t kMaxZeros = std::size_t{1} << 22;  // of an accessor that has no bytes of its own
inline constexpr std::size_t kMaxParts = 1u << 16;
inline constexpr std::size_t kMaxJoints = 512;                 // of one model
inline constexpr std::size_t kMaxKeys = std::size_t{1} << 22;  // of all clips together, resampled
inline constexpr int kMaxNodeDepth = 256;

inline constexpr int kMaxTextureSide = 16384;
inline constexpr std::size_t kMaxTextureBytes = std::size_t{2} << 30;  // of all textures together, decoded

inline constexpr double kMaxCoordinate = 1.0e6;    // metres; float's grain there is 6 cm
inline constexpr double kMaxFarCoordinate = 1.0e9;  // of nodes in the file, before the level is brought near (node_tree.h)

}  // namespace gh::load

// base/plane_block.h - memory for planes that are read side by side.
//
// Cost      large blocks ask for huge pages: filters follow eighty planes at once, each on another page of 4 kB for every row
//           or two (a fifteenth of the denoiser's time). A plane of 640x360 is too small for a huge page of its own, so
//           those of one thing share a block. Up to 1 MB more is held than was asked for.
#pragma once

#include <cstddef>
#include <memory>

namespace gh {

// 64-byte aligned at least, unfilled; lives as long as somebody holds it.
[[nodiscard]] std::shared_ptr<std::byte> make_plane_block(std::size_t bytes);

}  // namespace gh

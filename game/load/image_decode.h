// load/image_decode.h - PNG and JPEG bytes become RGBA pixels, through OpenImageIO.
//
// Bad input  other formats, oversized and damaged pictures give a sentence; no more is allocated than
//            `max_bytes` for pixels. The library's exceptions end here.
#pragma once

#include "base/result.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gh::load {

struct Pixels {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;  // rows top to bottom, straight alpha, values as in the file
};

[[nodiscard]] Result<Pixels> decode_image(std::span<const unsigned char> bytes, std::size_t max_bytes);

}  // namespace gh::load

// record/picture.h - pictures to disk, and from it.
//
// A file appears under its name complete or not at all: it is written beside it under another name and renamed.
// Errors are one sentence naming file and reason. Folders on the way are made.
#pragma once

#include "base/image.h"
#include "base/result.h"

#include <filesystem>

namespace gh::record {

// 8 bits a channel, 3 or 4 channels, marked as sRGB.
[[nodiscard]] Result<void> write_png(const std::filesystem::path& path, const Image8& picture);

// Linear radiance, 32-bit float RGB, losslessly compressed.
[[nodiscard]] Result<void> write_exr(const std::filesystem::path& path, const Image& picture);

// The first three channels of an EXR, HDR or any picture the library knows, as they are in the file: linear radiance if
// the file holds that. A grey one has the same three times. At most 2^28 pixels.
[[nodiscard]] Result<Image> read_picture(const std::filesystem::path& path);

}  // namespace gh::record

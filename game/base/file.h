// base/file.h - whole files in and out, with sentences for what goes wrong.
//
// Bad input  every error is one sentence that names the file and the reason. Nothing larger than the caller
//            allows is ever read or allocated for.
#pragma once

#include "base/result.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace gh {

// All bytes of a regular file of at most `max_bytes`.
[[nodiscard]] Result<std::vector<std::byte>> read_file(const std::filesystem::path& path,
                                                       std::size_t max_bytes);

// The file appears under its name complete or not at all: it is written beside it under another name, brought
// to the disk, and renamed. Folders on the way are made.
[[nodiscard]] Result<void> write_file_atomically(const std::filesystem::path& path,
                                                 std::span<const std::byte> bytes);
[[nodiscard]] Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace gh

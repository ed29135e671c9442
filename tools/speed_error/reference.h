// speed_error/reference.h - the truth pictures are judged by, made once and kept in a file.
#pragma once

#include "base/image.h"
#include "base/result.h"
#include "contestants.h"
#include "studio.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace speed_error {

struct Reference {
    gh::Image picture;
    double own_error = 0.0;  // its relMSE, estimated from its two independent halves
    std::uint64_t key = 0;   // of all it was made from
};

struct ReferenceSettings {
    int samples_per_pixel = 1024;  // of both halves together
    std::filesystem::path folder;
    int width = 320, height = 180;
};

// Reads the file, named by truth and view, when it was made from the very same things; makes and writes it otherwise.
[[nodiscard]] gh::Result<Reference> reference(const std::string& truth, const View& view,
                                              const ReferenceSettings& settings, const gh::Jobs& jobs);

}  // namespace speed_error

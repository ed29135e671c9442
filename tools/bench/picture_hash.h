// picture_hash.h - the hash of a picture, so that a fast wrong one is caught.
#pragma once

#include "base/hash.h"
#include "base/image.h"

#include <cstdint>

namespace bench {

inline std::uint64_t picture_hash(const gh::Image& picture) {
    gh::Hasher hash;
    for (const glm::vec3& pixel : picture.pixels) hash.add(pixel);
    return hash.digest();
}

}  // namespace bench

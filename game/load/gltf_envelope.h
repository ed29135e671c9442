// load/gltf_envelope.h - what a glTF file is made of before its meaning is read: a JSON text and, in a .glb,
// a chunk of bytes. The glTF parser behind this trusts sizes and recurses, so both are checked here first.
#pragma once

#include "base/result.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace gh::load {

struct GltfEnvelope {
    std::string_view json;             // into the caller's bytes
    std::span<const std::byte> chunk;  // a .glb's BIN chunk; empty otherwise
    bool is_binary = false;
};

// Tells .glb from .gltf by its first bytes. Sentences do not name the file: the caller knows it.
[[nodiscard]] Result<GltfEnvelope> open_envelope(std::span<const std::byte> bytes);

// Whether the text stays within load/limits.h in depth and in number of values, and its buffers in bytes if
// each of them is a copy of the chunk. Not a JSON validator: what is no JSON at all may pass; the parser
// refuses it.
[[nodiscard]] Result<void> check_json_limits(const GltfEnvelope& envelope);

}  // namespace gh::load

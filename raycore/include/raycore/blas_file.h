// raycore/blas_file.h - a built tree as bytes, so that a big level need not build its trees again.
//
// The bytes hold the tree, not the triangles: loading asks for the very mesh it was built from, and takes its corners.
// They are meant for the machine and the raycore that wrote them; anything else is refused, never guessed at.
// Cost      O(n), by several threads: a seventh to two fifths of a high-quality build (17 against 116 ms of processor
//           time for 199 k triangles, 80 against 197 for a million); 11-17 bytes a triangle.
// Same bits a loaded Blas is the saved one, byte for byte.
// Bad input bytes that are damaged, cut short, of another version or another mesh are refused with a sentence. Whatever
//           they hold, loading never reads outside them and a tree that is accepted never leads a query astray.
#pragma once

#include "raycore/blas.h"
#include "raycore/mesh.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace rc {

// Empty, and a contract violation, when `mesh` is not what `blas` was built from (or refitted to). Empty as well when a
// refit has made a triangle bad that was built in, or one good that was dropped: only a new build fits such a mesh.
[[nodiscard]] std::vector<std::byte> save_blas(const Blas& blas, const MeshView& mesh);

struct LoadedBlas {
    std::shared_ptr<Blas> blas;  // nothing when refused
    std::string refusal;         // why, in a sentence
};
[[nodiscard]] LoadedBlas load_blas(std::span<const std::byte> bytes, const MeshView& mesh);

}  // namespace rc

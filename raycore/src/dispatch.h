// dispatch.h - the kernels that answer: chosen once a query or a batch, never inside one.
#pragma once

#include "kernels/build_abi.h"
#include "kernels/kernel_abi.h"

#include "raycore/mesh.h"

#include <cstdint>

namespace rc {

[[nodiscard]] const kernel::Kernels& active_kernels();
[[nodiscard]] const kernel::BuildKernels& active_build_kernels();

// A mesh as builders' kernels read it.
[[nodiscard]] inline kernel::MeshArrays mesh_arrays_of(const MeshView& mesh) {
    return {reinterpret_cast<const float*>(mesh.positions.data()),
            reinterpret_cast<const std::uint32_t*>(mesh.triangles.data())};
}

}  // namespace rc

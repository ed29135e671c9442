// triangle_check.h - which triangles are worth keeping: one answer for build, refit and report.
#pragma once

#include "kernels/build_abi.h"
#include "raycore/mesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

namespace rc {

enum class TriangleFault { None, IndexOutOfRange, NotFinite, ZeroArea };

[[nodiscard]] TriangleFault fault_of(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);
[[nodiscard]] TriangleFault fault_of(std::span<const glm::vec3> positions, const glm::uvec3& triangle);
void count(TriangleFault fault, MeshReport& report);

}  // namespace rc

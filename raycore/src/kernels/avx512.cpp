// kernels/avx512.cpp - the kernels in AVX-512VL: the masks of AVX-512 on 256-bit registers.
#define RC_ISA isa_avx512
// clang-format off: each file stands on the one before it.
#include "kernels/kernel_abi.h"
#include "kernels/simd_avx2.h"
#include "kernels/ray_setup.inl"
#include "kernels/leaf.inl"
#include "kernels/triangle.inl"
#include "kernels/boxes.inl"
#include "kernels/children.inl"
#include "kernels/traverse.inl"
#include "kernels/top_walk.inl"
#include "kernels/stream.inl"
#include "kernels/packet_rays.inl"
#include "kernels/packet_boxes.inl"
#include "kernels/packet_lanes.inl"
#include "kernels/packet_leaves.inl"
#include "kernels/packet_tail.inl"
#include "kernels/packet.inl"
#include "kernels/packet_ask.inl"
#include "kernels/sinks.inl"
// clang-format on

namespace rc::kernel {

const Kernels kAvx512Kernels{RC_ISA::closest, RC_ISA::any, RC_ISA::crossings};

}  // namespace rc::kernel

// kernels/avx512.cpp - the kernels in AVX-512VL: the masks and compress of AVX-512 on 256-bit registers.
#include "kernels/kernel_abi.h"
#define RC_ISA isa_avx512
#include "kernels/ray_setup.inl"
#include "kernels/simd_avx2.h"
#include "kernels/sinks.inl"
#include "kernels/traverse.inl"
#include "kernels/triangle.inl"

namespace rc::kernel {

const Kernels kAvx512Kernels{RC_ISA::closest, RC_ISA::any, RC_ISA::crossings};

}  // namespace rc::kernel

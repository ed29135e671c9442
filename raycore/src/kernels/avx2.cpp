// kernels/avx2.cpp - the kernels in AVX2 and FMA.
#include "kernels/kernel_abi.h"
#include "kernels/ray_setup.inl"
#include "kernels/simd_avx2.h"
#include "kernels/sinks.inl"
#include "kernels/traverse.inl"
#include "kernels/triangle.inl"

namespace rc::kernel {

const Kernels kAvx2Kernels{RC_ISA::closest, RC_ISA::any, RC_ISA::crossings};

}  // namespace rc::kernel

// kernels/scalar.cpp - the kernels in plain C++.
#include "kernels/kernel_abi.h"
#include "kernels/ray_setup.inl"
#include "kernels/simd_scalar.h"
#include "kernels/sinks.inl"
#include "kernels/traverse.inl"
#include "kernels/triangle.inl"

namespace rc::kernel {

const Kernels kScalarKernels{RC_ISA::closest, RC_ISA::any, RC_ISA::crossings};

}  // namespace rc::kernel

// kernels/build_avx2.cpp - the builders' inner loops in AVX2.
// clang-format off: each file stands on the one before it.
#include "kernels/build_abi.h"
#define RC_ISA isa_build_avx2
#include "kernels/build.inl"
#include "kernels/bins.inl"
#include "kernels/pieces.inl"
#include "kernels/lanes.inl"
#include "kernels/share.inl"
#include "kernels/fit.inl"
#include "kernels/collect.inl"
// clang-format on

namespace rc::kernel {

const BuildKernels kAvx2BuildKernels{RC_ISA::clear,         RC_ISA::bin,           RC_ISA::best_split,
                                     RC_ISA::partition,     RC_ISA::measure,       RC_ISA::measure_subsets,
                                     RC_ISA::bin_pieces,    RC_ISA::best_plane,    RC_ISA::share_lanes,
                                     RC_ISA::fill_boxes,    RC_ISA::share_corners, RC_ISA::fit_block,
                                     RC_ISA::box_triangles, RC_ISA::measure_lanes};

}  // namespace rc::kernel

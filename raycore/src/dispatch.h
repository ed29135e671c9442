// dispatch.h - the kernels that answer: chosen once a query or a batch, never inside one.
#pragma once

#include "kernels/build_abi.h"
#include "kernels/kernel_abi.h"

namespace rc {

[[nodiscard]] const kernel::Kernels& active_kernels();
[[nodiscard]] const kernel::BuildKernels& active_build_kernels();

}  // namespace rc

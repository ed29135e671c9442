#include "dispatch.h"

#include "raycore/isa.h"

#include <atomic>

namespace rc {

namespace {

struct KernelsOf {
    std::string_view name;
    const kernel::Kernels* kernels;
};

constexpr KernelsOf kIsas[] = {
    {"scalar", &kernel::kScalarKernels},
    {"avx2", &kernel::kAvx2Kernels},
    {"avx512", &kernel::kAvx512Kernels},
};

const KernelsOf& kernels_of(Isa isa) {
    return kIsas[static_cast<std::size_t>(isa)];
}

// The one mutable static of the library: which instructions this process uses.
std::atomic<Isa>& choice() {
    static std::atomic<Isa> isa{best_isa()};
    return isa;
}

}  // namespace

std::string_view isa_name(Isa isa) {
    return kernels_of(isa).name;
}

std::optional<Isa> isa_from_name(std::string_view name) {
    for (const Isa isa : {Isa::Scalar, Isa::Avx2, Isa::Avx512})
        if (isa_name(isa) == name) return isa;
    return std::nullopt;
}

bool is_isa_supported(Isa isa) {
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                      __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
    switch (isa) {
        case Isa::Scalar:
            return true;
        case Isa::Avx2:
            return avx2;
        case Isa::Avx512:
            return avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                   __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
    }
    return false;
}

Isa best_isa() {
    if (is_isa_supported(Isa::Avx512)) return Isa::Avx512;
    return is_isa_supported(Isa::Avx2) ? Isa::Avx2 : Isa::Scalar;
}

Isa active_isa() {
    return choice().load(std::memory_order_relaxed);
}

bool use_isa(Isa isa) {
    if (!is_isa_supported(isa)) return false;
    choice().store(isa, std::memory_order_relaxed);
    return true;
}

const kernel::Kernels& active_kernels() {
    return *kernels_of(active_isa()).kernels;
}

const kernel::BuildKernels& active_build_kernels() {
    return active_isa() == Isa::Scalar ? kernel::kScalarBuildKernels : kernel::kAvx2BuildKernels;
}

}  // namespace rc

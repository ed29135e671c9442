// raycore/isa.h - which instructions answer. All give the same bits; they differ in speed only.
#pragma once

#include <optional>
#include <string_view>

namespace rc {

enum class Isa { Scalar, Avx2, Avx512 };

[[nodiscard]] std::string_view isa_name(Isa isa);                     // "scalar", "avx2", "avx512"
[[nodiscard]] std::optional<Isa> isa_from_name(std::string_view name);
[[nodiscard]] bool is_isa_supported(Isa isa);                         // by this CPU and this build
[[nodiscard]] Isa best_isa();                                         // the fastest supported one
[[nodiscard]] Isa active_isa();                                       // best_isa() until use_isa is called

// Chooses for the whole process; false and no change when not supported. Call before other threads ask.
bool use_isa(Isa isa);

}  // namespace rc

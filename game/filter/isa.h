// filter/isa.h - the instruction sets this room's kernels were compiled for, so that tests and benchmarks can ask each.
//
// Without a call the best one of the machine is taken. Not for use while a filter runs.
#pragma once

#include <string>
#include <vector>

namespace gh::filter {

// Those this machine can run, best first, e.g. AVX3, AVX2, SSE4, SSSE3, EMU128 (plain floats).
[[nodiscard]] std::vector<std::string> isa_names();

// From now on kernels run with that one, "" again with the best. False if there is none of that name here.
bool use_isa(const std::string& name);

}  // namespace gh::filter

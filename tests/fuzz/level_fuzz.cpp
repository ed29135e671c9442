// libFuzzer target: any bytes at all as a level. A good seed is a small .glb (tests/support/tiny_level.h).
//
//   cmake -DGLASSHOUSE_FUZZ=ON -DCMAKE_CXX_COMPILER=clang++ ...; bin/level_fuzz CORPUS -max_total_time=60
#include "load/level_check.h"
#include "load/level_loader.h"

#include <cstddef>
#include <cstdint>
#include <span>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = std::as_bytes(std::span(data, size));
    const gh::Result<gh::world::Level> level = gh::load::load_level_from_memory(bytes, "fuzz.glb", {});
    if (!level) {
        if (level.error().sentence.empty()) __builtin_trap();
        return 0;
    }
    if (!gh::load::check_ranges(*level)) __builtin_trap();
    (void)gh::load::check_level(*level);
    return 0;
}

// libFuzzer target: any bytes at all as meshes, instances, rays and bodies, every tree and instruction set against brute
// force. Without libFuzzer it is a program of its own:
//
//   bin/ray_fuzz_standalone --seeds 0 1000          worlds from random bytes, by seed
//   bin/ray_fuzz_standalone FILE...                 a corpus, or what once failed
#include "ray_check.h"
#include "support/random.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

bool is_right(std::span<const std::uint8_t> bytes, const std::string& name) {
    const std::string fault = fuzz::check(fuzz::world_from(bytes));
    if (fault.empty()) return true;
    std::fprintf(stderr, "%s: %s\n", name.c_str(), fault.c_str());
    return false;
}

}  // namespace

#ifdef GLASSHOUSE_LIBFUZZER

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (!is_right(std::span(data, size), "fuzz")) __builtin_trap();
    return 0;
}

#else

namespace {

std::vector<std::uint8_t> bytes_of(std::uint64_t seed) {
    test::Random random(seed);
    std::vector<std::uint8_t> bytes(64 + random.below(1600));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
    return bytes;
}

bool are_seeds_right(std::uint64_t from, std::uint64_t to) {
    int faults = 0;
    for (std::uint64_t seed = from; seed < to && faults < 10; ++seed)
        faults += !is_right(bytes_of(seed), "seed " + std::to_string(seed));
    std::printf("%llu worlds, %d faults\n", static_cast<unsigned long long>(to - from), faults);
    return faults == 0;
}

bool is_file_right(const char* path) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> text{std::istreambuf_iterator<char>(file), {}};
    if (!file) {
        std::fprintf(stderr, "%s: can not be read\n", path);
        return false;
    }
    return is_right(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), path);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 4 && std::string(argv[1]) == "--seeds")
        return are_seeds_right(std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10)) ? 0
                                                                                                         : 1;
    if (argc < 2) {
        std::fprintf(stderr, "usage: %s --seeds FROM TO | FILE...\n", argv[0]);
        return 2;
    }
    int faults = 0;
    for (int i = 1; i < argc; ++i) faults += !is_file_right(argv[i]);
    return faults == 0 ? 0 : 1;
}

#endif

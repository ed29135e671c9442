#include "filter/jitter.h"

#include "base/contracts.h"

#include <array>

namespace gh::filter {

namespace {

float radical_inverse(std::uint32_t i, std::uint32_t base) {
    float result = 0.0f, digit = 1.0f / static_cast<float>(base);
    for (; i > 0; i /= base, digit /= static_cast<float>(base))
        result += static_cast<float>(i % base) * digit;
    return result;
}

}  // namespace

glm::vec2 halton_jitter(std::uint32_t i) {
    constexpr std::uint32_t kPeriod = 32;
    const std::uint32_t n = i % kPeriod + 1;
    return glm::vec2(radical_inverse(n, 2), radical_inverse(n, 3)) - 0.5f;
}

glm::ivec2 lit_offset(std::uint32_t i, int step) {
    constexpr std::array<std::array<int, 2>, 4> kOfTwo = {{{0, 0}, {1, 1}, {1, 0}, {0, 1}}};
    constexpr std::array<std::array<int, 2>, 9> kOfThree = {
        {{1, 1}, {0, 0}, {2, 2}, {2, 0}, {0, 2}, {1, 0}, {1, 2}, {0, 1}, {2, 1}}};
    EXPECTS(1 <= step && step <= 4);
    if (step == 2) return {kOfTwo[i % 4][0], kOfTwo[i % 4][1]};
    if (step == 3) return {kOfThree[i % 9][0], kOfThree[i % 9][1]};
    if (step == 4) return 2 * lit_offset(i % 4, 2) + lit_offset(i / 4, 2);
    return {0, 0};
}

glm::vec2 small_jitter(const glm::vec2& jitter, const glm::ivec2& offset, int step) {
    return (glm::vec2(offset) + 0.5f + jitter) / static_cast<float>(step) - 0.5f;
}

}  // namespace gh::filter

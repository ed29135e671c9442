// filter/cubic.h - the cubic both resampling filters use.
#pragma once

namespace gh::filter {

// Mitchell and Netravali 1988 with B = C = 1/3, at distance x >= 0; support 2.
[[nodiscard]] constexpr float mitchell(float x) {
    if (x < 1.0f) return (7.0f * x * x * x - 12.0f * x * x + 16.0f / 3.0f) / 6.0f;
    if (x < 2.0f) return (-7.0f / 3.0f * x * x * x + 12.0f * x * x - 20.0f * x + 32.0f / 3.0f) / 6.0f;
    return 0.0f;
}

}  // namespace gh::filter

// base/det_math.h - the elementary functions, with the same bits on every machine.
//
// The C library picks other code on other processors and its last bits differ, so what decides the game
// (sim, sense, spatial) calls these. They compute in double with +, -, *, / and sqrt only, each rounded once
// by IEEE 754, and round to float at the end.
//
// Error     measured over a sweep of all floats, against long double: below 0.501 units in the last place of
//           the correct answer, that is, nearly always the nearest float (tests/base/det_math_test.cpp).
// Domain    that of the C library: all floats, sin(1e30) too; NaN, infinities and poles answer as <cmath>
//           does.
// Cost      20-60 ns, two to four times the C library.
// Threads   pure.
#pragma once

namespace gh {

inline constexpr float kPi = 3.14159265358979323846f;
inline constexpr float kTwoPi = 6.28318530717958647693f;

// The same angle in [-pi, pi], in radians; an infinite one gives NaN.
[[nodiscard]] float wrap_angle(float radians);

namespace det {

struct SinCos {
    float sin;
    float cos;
};

[[nodiscard]] float sin(float radians);
[[nodiscard]] float cos(float radians);
[[nodiscard]] SinCos sin_cos(float radians);
[[nodiscard]] float tan(float radians);
[[nodiscard]] float asin(float x);  // NaN outside [-1, 1]
[[nodiscard]] float acos(float x);  // NaN outside [-1, 1]
[[nodiscard]] float atan(float x);
[[nodiscard]] float atan2(float y, float x);  // angle of (x, y) from +x, in [-pi, pi]; atan2(+-0, -0) is +-pi
[[nodiscard]] float exp(float x);
[[nodiscard]] float exp2(float x);
[[nodiscard]] float log(float x);  // -infinity at 0, NaN below
[[nodiscard]] float log2(float x);
[[nodiscard]] float log10(float x);
[[nodiscard]] float pow(float base, float exponent);

}  // namespace det
}  // namespace gh

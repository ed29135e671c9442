// base/det_constants.h - what the parts of det_math have in common. Private to base.
#pragma once

#include <limits>

namespace gh {

inline constexpr double kPiD = 3.14159265358979323846;
inline constexpr double kHalfPiD = 1.57079632679489661923;
inline constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

}  // namespace gh

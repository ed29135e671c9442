#include "base/det_math.h"
#include "filter/tone_map.h"

#include <algorithm>

namespace gh::filter {

float srgb_from_linear(float linear) {
    if (!(linear > 0.0f)) return 0.0f;
    if (linear >= 1.0f) return 1.0f;
    return linear <= 0.0031308f ? linear * 12.92f : 1.055f * det::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float linear_from_srgb(float encoded) {
    if (!(encoded > 0.0f)) return 0.0f;
    if (encoded >= 1.0f) return 1.0f;
    return encoded <= 0.04045f ? encoded / 12.92f : det::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

}  // namespace gh::filter

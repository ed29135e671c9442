#include "sense/exposure.h"

#include "base/det_math.h"
#include "sense/lamp_light.h"

#include <algorithm>

namespace gh::sense {

float luminance(const glm::vec3& rgb) {
    return (0.2126f * rgb.r + 0.7152f * rgb.g) + 0.0722f * rgb.b;
}

float lightness_of(const glm::vec3& irradiance) {
    const float light = luminance(irradiance);
    if (!(light > kDarkIrradiance)) return 0.0f;
    const float doublings = det::log2(light / kDarkIrradiance);
    return std::min(1.0f, doublings / det::log2(kBrightIrradiance / kDarkIrradiance));
}

Exposure exposure(const world::Level& level, const world::Snapshot& snapshot, const BodyPoints& body) {
    std::array<Probe, kBodyPoints> probes;
    for (std::size_t i = 0; i < kBodyPoints; ++i)
        probes[i] = {.position = body[i], .normal = glm::vec3(0.0f)};
    Exposure result;
    irradiance(level, snapshot, probes, result.irradiance);
    float sum = 0.0f;
    for (std::size_t i = 0; i < kBodyPoints; ++i) {
        result.lit[i] = lightness_of(result.irradiance[i]);
        sum += result.lit[i];
    }
    result.level = sum / static_cast<float>(kBodyPoints);
    return result;
}

}  // namespace gh::sense

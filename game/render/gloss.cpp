#include "render/gloss.h"

#include "base/det_math.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr int kSamplesPerSide = 12;

// A microfacet normal that the eye sees, in proportion to how much of it shows (Heitz 2018); z is the surface normal.
glm::vec3 visible_normal(const glm::vec3& eye, float alpha, float u, float v) {
    const glm::vec3 stretched = glm::normalize(glm::vec3(alpha * eye.x, alpha * eye.y, eye.z));
    const float length2 = stretched.x * stretched.x + stretched.y * stretched.y;
    const glm::vec3 side = length2 > 0.0f ? glm::vec3(-stretched.y, stretched.x, 0.0f) / std::sqrt(length2)
                                          : glm::vec3(1.0f, 0.0f, 0.0f);
    const glm::vec3 over = glm::cross(stretched, side);
    const float radius = std::sqrt(u);
    const auto [sin_phi, cos_phi] = det::sin_cos(kTwoPi * v);
    const float x = radius * cos_phi;
    const float s = 0.5f * (1.0f + stretched.z);
    const float y = (1.0f - s) * std::sqrt(1.0f - x * x) + s * radius * sin_phi;
    const float z = std::sqrt(std::max(0.0f, 1.0f - x * x - y * y));
    const glm::vec3 n = side * x + over * y + stretched * z;
    return glm::normalize(glm::vec3(alpha * n.x, alpha * n.y, std::max(1e-6f, n.z)));
}

float smith_lambda_at(float cosine, float alpha) {
    const float tan2 = (1.0f - cosine * cosine) / (cosine * cosine);
    return 0.5f * (std::sqrt(1.0f + alpha * alpha * tan2) - 1.0f);
}

}  // namespace

float ggx_density(float cos_half, float alpha) {
    const float a2 = alpha * alpha;
    const float d = cos_half * cos_half * (a2 - 1.0f) + 1.0f;
    return a2 / (kPi * d * d);
}

float ggx_visibility(float cos_eye, float cos_light, float alpha) {
    const float a2 = alpha * alpha;
    const float eye = cos_light * std::sqrt(cos_eye * cos_eye * (1.0f - a2) + a2);
    const float light = cos_eye * std::sqrt(cos_light * cos_light * (1.0f - a2) + a2);
    return 0.5f / std::max(eye + light, 1e-7f);
}

GlossTable::GlossTable() {
    for (int r = 0; r < kSide; ++r) {
        const float roughness = static_cast<float>(r) / static_cast<float>(kSide - 1);
        const float alpha = roughness * roughness;
        for (int c = 0; c < kSide; ++c) {
            const float cosine = std::max(1e-3f, static_cast<float>(c) / static_cast<float>(kSide - 1));
            const glm::vec3 eye(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
            float of_f0 = 0.0f, of_f90 = 0.0f;
            for (int i = 0; i < kSamplesPerSide * kSamplesPerSide; ++i) {
                const int column = i % kSamplesPerSide, row = i / kSamplesPerSide;
                const float u = (static_cast<float>(column) + 0.5f) / kSamplesPerSide;
                const float v = (static_cast<float>(row) + 0.5f) / kSamplesPerSide;
                const glm::vec3 half = visible_normal(eye, alpha, u, v);
                const float cos_half_eye = std::max(0.0f, glm::dot(eye, half));
                const float cos_light = 2.0f * cos_half_eye * half.z - eye.z;
                if (!(cos_light > 0.0f)) continue;
                const float lambda_eye = smith_lambda_at(cosine, alpha);
                const float weight =
                    (1.0f + lambda_eye) / (1.0f + lambda_eye + smith_lambda_at(cos_light, alpha));
                const float m = 1.0f - cos_half_eye;
                const float m5 = m * m * m * m * m;
                of_f0 += weight * (1.0f - m5);
                of_f90 += weight * m5;
            }
            constexpr float kCount = kSamplesPerSide * kSamplesPerSide;
            shares_[static_cast<std::size_t>(r * kSide + c)] = {of_f0 / kCount, of_f90 / kCount};
        }
    }
}

glm::vec3 GlossTable::albedo(const glm::vec3& f0, float f90, float cos_eye, float roughness) const {
    const float x = std::clamp(cos_eye, 0.0f, 1.0f) * (kSide - 1);
    const float y = std::clamp(roughness, 0.0f, 1.0f) * (kSide - 1);
    const int x0 = std::min(static_cast<int>(x), kSide - 2), y0 = std::min(static_cast<int>(y), kSide - 2);
    const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
    const Share* row = shares_.data() + y0 * kSide + x0;
    const auto blend = [&](float a, float b, float c, float d) {
        return (a * (1.0f - fx) + b * fx) * (1.0f - fy) + (c * (1.0f - fx) + d * fx) * fy;
    };
    const float of_f0 = blend(row[0].of_f0, row[1].of_f0, row[kSide].of_f0, row[kSide + 1].of_f0);
    const float of_f90 = blend(row[0].of_f90, row[1].of_f90, row[kSide].of_f90, row[kSide + 1].of_f90);
    return f0 * of_f0 + glm::vec3(f90 * of_f90);
}

}  // namespace gh::render

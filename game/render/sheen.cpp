#include "render/sheen.h"

#include "base/det_math.h"
#include "render/table_place.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kLeastRoughness = 0.07f;  // narrower lobes show nothing and overflow

// Roughness of row r of the tables.
float roughness_of(std::size_t r, int rows) {
    return kLeastRoughness + (1.0f - kLeastRoughness) * static_cast<float>(r) / static_cast<float>(rows - 1);
}

float unscaled(const glm::vec3& eye, const glm::vec3& light, float roughness) {
    const glm::vec3 sum = eye + light;
    const float length2 = glm::dot(sum, sum);
    if (!(length2 > 0.0f)) return 0.0f;
    const float cos2 = sum.z * sum.z / length2;
    const float per_alpha = 1.0f / (roughness * roughness);
    // sin^(1/alpha) of the half vector's angle.
    const float sin2 = std::clamp(1.0f - cos2, 0.0f, 1.0f);
    const float power = sin2 > 0.0f ? det::pow(sin2, 0.5f * per_alpha) : 0.0f;
    const float fibres = (2.0f + per_alpha) * power / kTwoPi;
    const float open = 4.0f * (eye.z + light.z - eye.z * light.z);
    return open > 0.0f ? fibres * light.z / open : 0.0f;
}

// Over the hemisphere; heights are closer together where light grazes.
float unscaled_albedo(float cosine, float roughness) {
    constexpr int kHeights = 64, kTurns = 32;
    const glm::vec3 eye(std::sqrt(std::max(0.0f, 1.0f - cosine * cosine)), 0.0f, cosine);
    double sum = 0.0;
    for (int i = 0; i < kHeights; ++i) {
        const float s = (static_cast<float>(i) + 0.5f) / kHeights;
        const float z = s * s, ring = std::sqrt(1.0f - z * z);
        for (int k = 0; k < kTurns; ++k) {
            const auto [sine, cos_turn] = det::sin_cos(kPi * (static_cast<float>(k) + 0.5f) / kTurns);
            const glm::vec3 light(ring * cos_turn, ring * sine, z);
            sum += static_cast<double>(unscaled(eye, light, roughness) * 2.0f * s);
        }
    }
    return static_cast<float>(sum * static_cast<double>(kTwoPi) / (kHeights * kTurns));
}

TablePlace row_of(float roughness, int rows) {
    return place_in_table((roughness - kLeastRoughness) / (1.0f - kLeastRoughness), rows);
}
}  // namespace

Sheen::Sheen() {
    for (std::size_t r = 0; r < kRoughnesses; ++r) {
        const float roughness = roughness_of(r, kRoughnesses);
        float most = 0.0f;
        float* row = albedo_.data() + r * kCosines;
        for (std::size_t c = 0; c < kCosines; ++c) {
            const float cosine = std::max(static_cast<float>(c), 0.05f) / (kCosines - 1);
            row[c] = unscaled_albedo(cosine, roughness);
            most = std::max(most, row[c]);
        }
        // A hair more than needed: between the table's angles there may be a little more.
        scale_[r] = std::min(1.0f, 0.98f / most);
        for (std::size_t c = 0; c < kCosines; ++c) row[c] *= scale_[r];
    }
}

float Sheen::value(const glm::vec3& eye, const glm::vec3& light, float roughness) const {
    const TablePlace y = row_of(roughness, kRoughnesses);
    const float scale = std::min(scale_[y.cell], scale_[y.cell + 1]);
    return scale * unscaled(eye, light, std::max(roughness, kLeastRoughness));
}

float Sheen::albedo(float cosine, float roughness) const {
    const TablePlace row = row_of(roughness, kRoughnesses), column = place_in_table(cosine, kCosines);
    return std::min(1.0f, between(albedo_.data(), kCosines, row, column));
}

}  // namespace gh::render

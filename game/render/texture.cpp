#include "render/texture.h"

#include "base/contracts.h"
#include "base/det_math.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kMaxTaps = 8.0f;

float linear_from_srgb(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : det::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

std::uint8_t byte_from_unit(float value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

std::uint8_t srgb_byte(float linear) {
    const float encoded =
        linear <= 0.0031308f ? linear * 12.92f : 1.055f * det::pow(linear, 1.0f / 2.4f) - 0.055f;
    return byte_from_unit(encoded);
}

// What a byte means, for either encoding; and the byte for twelve bits of linear light, so that no mip level calls pow.
struct Tables {
    std::array<float, 256> unit;
    std::array<float, 256> from_srgb;
    std::array<std::uint8_t, 4096> to_srgb;
};

Tables make_tables() {
    Tables tables;
    for (std::size_t i = 0; i < 256; ++i) {
        tables.unit[i] = static_cast<float>(i) / 255.0f;
        tables.from_srgb[i] = linear_from_srgb(tables.unit[i]);
    }
    for (std::size_t i = 0; i < 4096; ++i) tables.to_srgb[i] = srgb_byte(static_cast<float>(i) / 4095.0f);
    return tables;
}

const Tables kTables = make_tables();

int wrapped(int i, int size, world::Wrap wrap) {
    switch (wrap) {
        case world::Wrap::Clamp:
            return std::clamp(i, 0, size - 1);
        case world::Wrap::Mirror: {
            const int at = ((i % (2 * size)) + 2 * size) % (2 * size);
            return at < size ? at : 2 * size - 1 - at;
        }
        case world::Wrap::Repeat:
            break;
    }
    const int at = i % size;
    return at < 0 ? at + size : at;
}

// Far outside, float texel coordinates mean nothing and would not fit an int.
float tamed(float coordinate) {
    return std::abs(coordinate) < 1e6f ? coordinate : 0.0f;
}

}  // namespace

MipTexture::MipTexture(const world::Texture& texture, Encoding encoding)
    : whole_(texture.rgba), wrap_u_(texture.wrap_u), wrap_v_(texture.wrap_v), encoding_(encoding) {
    EXPECTS(texture.width >= 1 && texture.height >= 1);
    levels_.push_back({texture.width, texture.height});
    while (levels_.back().width > 1 || levels_.back().height > 1) add_level(level_count() - 1);
}

std::span<const std::uint8_t> MipTexture::texels(int level) const {
    return level == 0 ? whole_ : std::span<const std::uint8_t>(smaller_[static_cast<std::size_t>(level - 1)]);
}

glm::vec4 MipTexture::texel(int level, int x, int y) const {
    const auto width = static_cast<std::size_t>(levels_[static_cast<std::size_t>(level)].width);
    const std::uint8_t* rgba =
        texels(level).data() + (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)) * 4;
    const std::array<float, 256>& rgb = encoding_ == Encoding::Srgb ? kTables.from_srgb : kTables.unit;
    return {rgb[rgba[0]], rgb[rgba[1]], rgb[rgba[2]], kTables.unit[rgba[3]]};
}

// Half the size, rounded down: each texel the mean of the 2x2 below it, 3 wide where a side is odd.
void MipTexture::add_level(int from) {
    const Size big = levels_[static_cast<std::size_t>(from)];
    const Size small{std::max(1, big.width / 2), std::max(1, big.height / 2)};
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(small.width) *
                                    static_cast<std::size_t>(small.height) * 4);
    for (int y = 0; y < small.height; ++y) {
        const int y_begin = y * big.height / small.height, y_end = (y + 1) * big.height / small.height;
        for (int x = 0; x < small.width; ++x) {
            const int x_begin = x * big.width / small.width, x_end = (x + 1) * big.width / small.width;
            glm::vec4 sum(0.0f);
            for (int j = y_begin; j < y_end; ++j) {
                for (int i = x_begin; i < x_end; ++i) sum += texel(from, i, j);
            }
            const glm::vec4 mean = sum / static_cast<float>((y_end - y_begin) * (x_end - x_begin));
            std::uint8_t* out =
                bytes.data() + (static_cast<std::size_t>(y) * static_cast<std::size_t>(small.width) +
                                static_cast<std::size_t>(x)) *
                                   4;
            for (std::size_t c = 0; c < 3; ++c) {
                const float value = std::clamp(mean[c], 0.0f, 1.0f);
                out[c] = encoding_ == Encoding::Srgb
                             ? kTables.to_srgb[static_cast<std::size_t>(value * 4095.0f + 0.5f)]
                             : byte_from_unit(value);
            }
            out[3] = byte_from_unit(mean.w);
        }
    }
    levels_.push_back(small);
    smaller_.push_back(std::move(bytes));
}

glm::vec4 MipTexture::bilinear(int level, const glm::vec2& uv) const {
    const Size size = levels_[static_cast<std::size_t>(level)];
    const float x = tamed(uv.x * static_cast<float>(size.width) - 0.5f);
    const float y = tamed(uv.y * static_cast<float>(size.height) - 0.5f);
    const float x_floor = std::floor(x), y_floor = std::floor(y);
    const int x0 = wrapped(static_cast<int>(x_floor), size.width, wrap_u_);
    const int x1 = wrapped(static_cast<int>(x_floor) + 1, size.width, wrap_u_);
    const int y0 = wrapped(static_cast<int>(y_floor), size.height, wrap_v_);
    const int y1 = wrapped(static_cast<int>(y_floor) + 1, size.height, wrap_v_);
    const float fx = x - x_floor, fy = y - y_floor;
    const glm::vec4 top = texel(level, x0, y0) * (1.0f - fx) + texel(level, x1, y0) * fx;
    const glm::vec4 bottom = texel(level, x0, y1) * (1.0f - fx) + texel(level, x1, y1) * fx;
    return top * (1.0f - fy) + bottom * fy;
}

glm::vec4 MipTexture::trilinear(float level, const glm::vec2& uv) const {
    const float clamped = std::clamp(level, 0.0f, static_cast<float>(level_count() - 1));
    const int fine = static_cast<int>(clamped);
    const float blend = clamped - static_cast<float>(fine);
    const glm::vec4 sharp = bilinear(fine, uv);
    return blend == 0.0f ? sharp : sharp * (1.0f - blend) + bilinear(fine + 1, uv) * blend;
}

glm::vec4 MipTexture::sample(glm::vec2 uv, const Footprint& footprint) const {
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) uv = glm::vec2(0.0f);
    const glm::vec2 size(static_cast<float>(levels_[0].width), static_cast<float>(levels_[0].height));
    const float major = glm::length(footprint.major * size);
    const float minor = glm::length(footprint.minor * size);

    // As many taps along the long axis as make each about round; what is left over is blurred away.
    const float wanted = std::ceil(major / std::max(minor, 1.0f));
    const float taps = wanted > 1.0f ? std::min(wanted, kMaxTaps) : 1.0f;
    const float width = std::max(minor, major / taps);
    const float level = width > 1.0f ? std::log2(width) : 0.0f;
    if (taps == 1.0f) return trilinear(level, uv);

    glm::vec4 sum(0.0f);
    for (float i = 0.0f; i < taps; i += 1.0f) {
        sum += trilinear(level, uv + footprint.major * ((i + 0.5f) / taps - 0.5f));
    }
    return sum / taps;
}

}  // namespace gh::render

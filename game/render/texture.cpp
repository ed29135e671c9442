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

// Brings a coordinate into [0, 1]: what lies outside repeats, runs back, or is the border's.
float folded(float u, world::Wrap wrap) {
    switch (wrap) {
        case world::Wrap::Clamp:
            return std::clamp(u, 0.0f, 1.0f);
        case world::Wrap::Mirror: {
            const float t = u - 2.0f * std::floor(0.5f * u);
            return t <= 1.0f ? t : 2.0f - t;
        }
        case world::Wrap::Repeat:
            break;
    }
    return u - std::floor(u);
}

// Two texels next to each other and how far the place is from the first to the second.
struct Pair {
    int first, second;
    float share;
};

Pair pair_at(float unit, int size, world::Wrap wrap) {
    const float at = unit * static_cast<float>(size) - 0.5f;
    const float floor = std::floor(at);
    const int i = static_cast<int>(floor);
    const bool repeats = wrap == world::Wrap::Repeat;
    const int first = i >= 0 ? i : repeats ? size - 1 : 0;
    const int second = i + 1 < size ? i + 1 : repeats ? 0 : size - 1;
    return {std::min(first, size - 1), second, at - floor};
}

}  // namespace

MipTexture::Mip::Mip(int mip_width, int mip_height)
    : width(mip_width), height(mip_height), blocks_across(static_cast<std::size_t>(mip_width + 3) / 4) {
    rgba.resize(blocks_across * (static_cast<std::size_t>(mip_height + 3) / 4) * 16);
}

MipTexture::MipTexture(const world::Texture& texture, Encoding encoding)
    : wrap_u_(texture.wrap_u), wrap_v_(texture.wrap_v), encoding_(encoding) {
    EXPECTS(texture.width >= 1 && texture.height >= 1);
    Mip whole(texture.width, texture.height);
    const std::uint8_t* bytes = texture.rgba.data();
    for (int y = 0; y < texture.height; ++y) {
        for (int x = 0; x < texture.width; ++x, bytes += 4) {
            whole.rgba[whole.index(x, y)] = std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8 |
                                            std::uint32_t{bytes[2]} << 16 | std::uint32_t{bytes[3]} << 24;
        }
    }
    mips_.push_back(std::move(whole));
    while (mips_.back().width > 1 || mips_.back().height > 1) mips_.push_back(halved(mips_.back()));
}

glm::vec4 MipTexture::linear(std::uint32_t texel) const {
    const std::array<float, 256>& rgb = encoding_ == Encoding::Srgb ? kTables.from_srgb : kTables.unit;
    return {rgb[texel & 0xFF], rgb[texel >> 8 & 0xFF], rgb[texel >> 16 & 0xFF], kTables.unit[texel >> 24]};
}

std::uint32_t MipTexture::encoded(const glm::vec4& mean) const {
    std::uint32_t texel = std::uint32_t{byte_from_unit(mean.w)} << 24;
    for (std::size_t c = 0; c < 3; ++c) {
        const float value = std::clamp(mean[c], 0.0f, 1.0f);
        const std::uint8_t byte = encoding_ == Encoding::Srgb
                                      ? kTables.to_srgb[static_cast<std::size_t>(value * 4095.0f + 0.5f)]
                                      : byte_from_unit(value);
        texel |= std::uint32_t{byte} << (8 * c);
    }
    return texel;
}

// Half the size, rounded down: each texel the mean of the 2x2 below it, 3 wide where a side is odd.
MipTexture::Mip MipTexture::halved(const Mip& big) const {
    Mip small(std::max(1, big.width / 2), std::max(1, big.height / 2));
    for (int y = 0; y < small.height; ++y) {
        const int y_begin = y * big.height / small.height, y_end = (y + 1) * big.height / small.height;
        for (int x = 0; x < small.width; ++x) {
            const int x_begin = x * big.width / small.width, x_end = (x + 1) * big.width / small.width;
            glm::vec4 sum(0.0f);
            for (int j = y_begin; j < y_end; ++j) {
                for (int i = x_begin; i < x_end; ++i) sum += linear(big.rgba[big.index(i, j)]);
            }
            const auto count = static_cast<float>((y_end - y_begin) * (x_end - x_begin));
            small.rgba[small.index(x, y)] = encoded(sum / count);
        }
    }
    return small;
}

glm::vec4 MipTexture::bilinear(const Mip& mip, const glm::vec2& uv) const {
    const Pair x = pair_at(uv.x, mip.width, wrap_u_), y = pair_at(uv.y, mip.height, wrap_v_);
    const std::uint32_t* texels = mip.rgba.data();
    const glm::vec4 top = linear(texels[mip.index(x.first, y.first)]) * (1.0f - x.share) +
                          linear(texels[mip.index(x.second, y.first)]) * x.share;
    const glm::vec4 bottom = linear(texels[mip.index(x.first, y.second)]) * (1.0f - x.share) +
                             linear(texels[mip.index(x.second, y.second)]) * x.share;
    return top * (1.0f - y.share) + bottom * y.share;
}

glm::vec4 MipTexture::trilinear(float level, const glm::vec2& uv) const {
    const float clamped = std::clamp(level, 0.0f, static_cast<float>(level_count() - 1));
    const auto fine = static_cast<std::size_t>(clamped);
    const float blend = clamped - static_cast<float>(fine);
    const glm::vec2 at(folded(uv.x, wrap_u_), folded(uv.y, wrap_v_));
    const glm::vec4 sharp = bilinear(mips_[fine], at);
    return blend == 0.0f ? sharp : sharp * (1.0f - blend) + bilinear(mips_[fine + 1], at) * blend;
}

glm::vec4 MipTexture::sample(glm::vec2 uv, const Footprint& footprint, float max_taps) const {
    // Far outside, texel coordinates mean nothing; nor do those of a NaN.
    if (!(std::abs(uv.x) < 1e6f) || !(std::abs(uv.y) < 1e6f)) uv = glm::vec2(0.0f);
    const glm::vec2 size(static_cast<float>(mips_[0].width), static_cast<float>(mips_[0].height));
    const float major = glm::length(footprint.major * size);
    const float minor = glm::length(footprint.minor * size);

    // As many taps along the long axis as make each about round; what is left over is blurred away.
    const float wanted = std::ceil(major / std::max(minor, 1.0f));
    const float taps = wanted > 1.0f ? std::min(wanted, max_taps) : 1.0f;
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

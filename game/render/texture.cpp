#include "render/texture.h"

#include "base/contracts.h"
#include "base/det_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace gh::render {

namespace {

float linear_from_srgb(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : det::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

// What a byte means, for either encoding, of 65535.
struct Tables {
    std::array<std::uint16_t, 256> unit;
    std::array<std::uint16_t, 256> from_srgb;
};

Tables make_tables() {
    Tables tables;
    for (std::size_t i = 0; i < 256; ++i) {
        tables.unit[i] = static_cast<std::uint16_t>(i * 257);
        const float half_up = linear_from_srgb(static_cast<float>(i) / 255.0f) * 65535.0f + 0.5f;
        tables.from_srgb[i] = static_cast<std::uint16_t>(half_up);
    }
    return tables;
}

const Tables kTables = make_tables();

Edge edge_of(world::Wrap wrap) {
    if (wrap == world::Wrap::Clamp) return Edge::Clamp;
    return wrap == world::Wrap::Mirror ? Edge::Mirror : Edge::Repeat;
}

}  // namespace

MipTexture::Mip::Mip(int mip_width, int mip_height)
    : width(mip_width), height(mip_height), blocks_across((mip_width + kBlockSide - 1) / kBlockSide) {
    const int blocks_down = (mip_height + kBlockSide - 1) / kBlockSide;
    rgba.resize(static_cast<std::size_t>(blocks_across) * static_cast<std::size_t>(blocks_down) * kBlockSide *
                kBlockSide * 4);
}

std::uint16_t* MipTexture::Mip::texel(int x, int y) {
    const auto block = static_cast<std::size_t>(y / kBlockSide) * static_cast<std::size_t>(blocks_across) +
                       static_cast<std::size_t>(x / kBlockSide);
    const auto within = static_cast<std::size_t>(y % kBlockSide * kBlockSide + x % kBlockSide);
    return rgba.data() + 4 * (block * kBlockSide * kBlockSide + within);
}

MipTexture::MipTexture(const world::Texture& texture, Encoding encoding)
    : size_(static_cast<float>(texture.width), static_cast<float>(texture.height)) {
    EXPECTS(texture.width >= 1 && texture.height >= 1);
    const auto& rgb = encoding == Encoding::Srgb ? kTables.from_srgb : kTables.unit;
    Mip whole(texture.width, texture.height);
    const std::uint8_t* bytes = texture.rgba.data();
    for (int y = 0; y < texture.height; ++y) {
        for (int x = 0; x < texture.width; ++x, bytes += 4) {
            std::uint16_t* const texel = whole.texel(x, y);
            for (std::size_t c = 0; c < 3; ++c) texel[c] = rgb[bytes[c]];
            texel[3] = kTables.unit[bytes[3]];
        }
    }
    mips_.push_back(std::move(whole));
    while (mips_.back().width > 1 || mips_.back().height > 1) mips_.push_back(halved(mips_.back()));
    for (std::size_t fine = 0; fine < mips_.size(); ++fine) {
        pairs_.push_back(mip_pair(mips_[fine].view(), mips_[std::min(fine + 1, mips_.size() - 1)].view(),
                                  edge_of(texture.wrap_u), edge_of(texture.wrap_v)));
    }
}

void MipTexture::Mip::average(const glm::ivec2& begin, const glm::ivec2& end, std::uint16_t* mean) {
    std::array<std::uint32_t, 4> sum{};
    for (int y = begin.y; y < end.y; ++y) {
        for (int x = begin.x; x < end.x; ++x) {
            for (std::size_t c = 0; c < 4; ++c) sum[c] += texel(x, y)[c];
        }
    }
    const auto count = static_cast<std::uint32_t>((end.y - begin.y) * (end.x - begin.x));
    for (std::size_t c = 0; c < 4; ++c) mean[c] = static_cast<std::uint16_t>((sum[c] + count / 2) / count);
}

// Half the size, rounded down: each texel the mean of the 2x2 below it, 3 wide where a side is odd.
MipTexture::Mip MipTexture::halved(Mip& big) {
    Mip small(std::max(1, big.width / 2), std::max(1, big.height / 2));
    for (int y = 0; y < small.height; ++y) {
        const int y_begin = y * big.height / small.height, y_end = (y + 1) * big.height / small.height;
        for (int x = 0; x < small.width; ++x) {
            const int x_begin = x * big.width / small.width, x_end = (x + 1) * big.width / small.width;
            big.average({x_begin, y_begin}, {x_end, y_end}, small.texel(x, y));
        }
    }
    return small;
}

TapQuery MipTexture::query(std::size_t fine) const {
    return {.levels = &pairs_[fine],
            .fine = mips_[fine].rgba.data(),
            .coarse = mips_[std::min(fine + 1, mips_.size() - 1)].rgba.data(),
            .blend = 0.0f,
            .uv = {},
            .step = {},
            .taps = 1};
}

glm::vec4 MipTexture::at(glm::vec2 uv) const {
    constexpr float kFarthest = 1e6f;
    if (!(std::abs(uv.x) < kFarthest) || !(std::abs(uv.y) < kFarthest)) uv = glm::vec2(0.0f);
    TapQuery one = query(0);
    one.uv[0] = uv.x;
    one.uv[1] = uv.y;
    glm::vec4 value;
    average_taps(&one, 1, &value.x);
    return value;
}

}  // namespace gh::render

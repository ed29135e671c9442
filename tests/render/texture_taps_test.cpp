// Texture look-ups: against the plain formula in double precision, and alike on every instruction set.
#include "render/texture_taps.h"

#include "base/random.h"
#include "targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace gh {
namespace {

struct Picture {
    int width, height;
    std::vector<std::uint16_t> rgba;  // in blocks

    Picture(Random& random, int w, int h) : width(w), height(h) {
        const int blocks = across() * ((h + render::kBlockSide - 1) / render::kBlockSide);
        for (int i = 0; i < blocks * 16 * 4; ++i)
            rgba.push_back(static_cast<std::uint16_t>(random.below(65536)));
    }
    [[nodiscard]] int across() const { return (width + render::kBlockSide - 1) / render::kBlockSide; }
    [[nodiscard]] render::MipView view() const { return {rgba.data(), width, height, across()}; }
    [[nodiscard]] double at(int x, int y, int channel) const {
        const int block = y / 4 * across() + x / 4;
        return rgba[static_cast<std::size_t>((block * 16 + y % 4 * 4 + x % 4) * 4 + channel)] / 65535.0;
    }
};

int folded(int texel, int size, render::Edge edge) {
    if (edge == render::Edge::Repeat) return ((texel % size) + size) % size;
    if (edge == render::Edge::Clamp) return std::clamp(texel, 0, size - 1);
    const int period = ((texel % (2 * size)) + 2 * size) % (2 * size);
    return std::min(period, 2 * size - 1 - period);
}

// The infinite plane that `edge` makes of the picture, bilinear between the middles of its texels.
double expected(const Picture& picture, const render::MipPair& levels, double u, double v, int channel) {
    const double x = u * picture.width - 0.5, y = v * picture.height - 0.5;
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
    double sum = 0.0;
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 2; ++i) {
            const double share = (1.0 - std::abs(x - (left + i))) * (1.0 - std::abs(y - (top + j)));
            sum += share * picture.at(folded(left + i, picture.width, levels.axis[0].edge),
                                      folded(top + j, picture.height, levels.axis[1].edge), channel);
        }
    }
    return sum;
}

double expected(const Picture& fine, const Picture& coarse, const render::TapQuery& query, int channel) {
    double sum = 0.0;
    for (int tap = 0; tap < query.taps; ++tap) {
        const double u = static_cast<double>(query.uv[0]) + static_cast<double>(query.step[0]) * tap;
        const double v = static_cast<double>(query.uv[1]) + static_cast<double>(query.step[1]) * tap;
        const double blend = static_cast<double>(query.blend);
        sum += (1.0 - blend) * expected(fine, *query.levels, u, v, channel) +
               blend * expected(coarse, *query.levels, u, v, channel);
    }
    return sum / query.taps;
}

TEST(TextureTaps, AreTheFormulaOnEveryInstructionSetInEveryBit) {
    Random random(11);
    constexpr std::array kEdges = {render::Edge::Repeat, render::Edge::Clamp, render::Edge::Mirror};
    for (int round = 0; round < 40; ++round) {
        const Picture fine(random, 1 + static_cast<int>(random.below(21)),
                           1 + static_cast<int>(random.below(21)));
        const Picture coarse(random, std::max(1, fine.width / 2), std::max(1, fine.height / 2));
        const render::MipPair levels =
            render::mip_pair(fine.view(), coarse.view(), kEdges[random.below(3)], kEdges[random.below(3)]);
        std::vector<render::TapQuery> queries;
        for (int i = 0; i < 19; ++i) {  // more than are fetched ahead
            queries.push_back({.levels = &levels,
                               .fine = fine.rgba.data(),
                               .coarse = coarse.rgba.data(),
                               .blend = i % 4 == 0 ? 0.0f : random.unit(),
                               .uv = {random.unit() * 6.0f - 3.0f, random.unit() * 6.0f - 3.0f},
                               .step = {random.unit() - 0.5f, random.unit() - 0.5f},
                               .taps = 1 + static_cast<int>(random.below(8))});
        }
        std::vector<float> first;
        test::on_every_target([&] {
            std::vector<float> rgba(4 * queries.size());
            render::average_taps(queries.data(), queries.size(), rgba.data());
            if (first.empty()) first = rgba;
            EXPECT_EQ(rgba, first);
        });
        for (std::size_t i = 0; i < queries.size(); ++i) {
            for (int c = 0; c < 4; ++c) {
                // A coordinate of up to 7 is off by 2^-22, that is 21 texels times as much, and a texel may be 1 more
                // than the next; a dozen roundings besides.
                EXPECT_NEAR(static_cast<double>(first[4 * i + static_cast<std::size_t>(c)]),
                            expected(fine, coarse, queries[i], c), 2e-5);
            }
        }
    }
}

}  // namespace
}  // namespace gh

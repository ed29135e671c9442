#include "filter/glare.h"

#include <algorithm>
#include <cmath>

namespace gh::filter {

namespace {

constexpr int kRows = 180;  // of the finest veil
constexpr int kFewest = 3;  // rows or columns of the coarsest: it reaches a quarter of the picture

std::size_t rows_of(const Image& image) {
    return static_cast<std::size_t>(image.height);
}

void fit(Image& image, int width, int height) {
    if (image.width != width || image.height != height) image = Image(width, height);
}

// Bounded by its brightest part, so that a warm lamp has a warm halo.
glm::vec3 scattered(const glm::vec3& radiance, float most) {
    const auto positive = [](float c) {
        return c > 0.0f && c < 1e30f ? c : c > 0.0f ? 1e30f : 0.0f;
    };  // NaN: 0
    const glm::vec3 light(positive(radiance.x), positive(radiance.y), positive(radiance.z));
    const float peak = std::max(std::max(light.x, light.y), light.z);
    return peak > most ? light * (most / peak) : light;
}

// Means of blocks of side x side pixels; those at the right and lower border may be smaller.
void shrink(const Image& in, int side, float most, const Jobs& jobs, Image& out) {
    fit(out, (in.width + side - 1) / side, (in.height + side - 1) / side);
    jobs.run(rows_of(out), [&](std::size_t row, int) {
        const int y = static_cast<int>(row), y0 = y * side, y1 = std::min(y0 + side, in.height);
        for (int x = 0; x < out.width; ++x) {
            const int x0 = x * side, x1 = std::min(x0 + side, in.width);
            glm::vec3 sum(0.0f);
            for (int j = y0; j < y1; ++j) {
                const glm::vec3* from = in.pixels.data() + in.index(x0, j);
                for (int i = 0; i < x1 - x0; ++i) sum += scattered(from[i], most);
            }
            out.at(x, y) = sum / static_cast<float>((x1 - x0) * (y1 - y0));
        }
    });
}

// Where pixel `at` of a picture `side` times as fine lies between two of `count` coarse ones.
struct Between {
    int low, high;
    float share;  // of the higher
};
Between between(int at, int side, int count) {
    const float place = (static_cast<float>(at) + 0.5f) / static_cast<float>(side) - 0.5f;
    const int low = static_cast<int>(std::floor(place));
    return {std::clamp(low, 0, count - 1), std::clamp(low + 1, 0, count - 1),
            place - static_cast<float>(low)};
}

glm::vec3 mixed(const glm::vec3& a, const glm::vec3& b, float share) {
    return a + (b - a) * share;
}

// `own` shares the veil with all that is coarser, `coarse`, of which there are `coarser` levels: all levels weigh alike.
void join(const Image& own, const Image& coarse, int coarser, const Jobs& jobs, Image& out) {
    fit(out, own.width, own.height);
    const float share = static_cast<float>(coarser) / static_cast<float>(coarser + 1);
    jobs.run(rows_of(out), [&](std::size_t row, int) {
        const int y = static_cast<int>(row);
        const Between v = between(y, 2, coarse.height);
        for (int x = 0; x < out.width; ++x) {
            const Between h = between(x, 2, coarse.width);
            const glm::vec3 above = mixed(coarse.at(h.low, v.low), coarse.at(h.high, v.low), h.share);
            const glm::vec3 below = mixed(coarse.at(h.low, v.high), coarse.at(h.high, v.high), h.share);
            out.at(x, y) = mixed(own.at(x, y), mixed(above, below, v.share), share);
        }
    });
}

void widen(const Image& in, int side, int width, const Jobs& jobs, Image& out) {
    fit(out, width, in.height);
    jobs.run(rows_of(out), [&](std::size_t row, int) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < width; ++x) {
            const Between h = between(x, side, in.width);
            out.at(x, y) = mixed(in.at(h.low, y), in.at(h.high, y), h.share);
        }
    });
}

// Two rows of the veil, and where between them a row of the picture lies.
struct VeilRows {
    const float *above, *below;
    float lower;  // share of the one below
};

// Plain floats, which compilers turn into vectors.
void lay_over(const float* picture, const VeilRows& rows, float share, std::size_t count, float* out) {
    for (std::size_t i = 0; i < count; ++i) {
        const float veil = rows.above[i] + (rows.below[i] - rows.above[i]) * rows.lower;
        out[i] = picture[i] * (1.0f - share) + veil * share;
    }
}

}  // namespace

void Glare::veil(const Image& picture, const GlareSettings& settings, const Jobs& jobs, Image& out) {
    EXPECTS(0.0f <= settings.share && settings.share <= 1.0f && settings.most > 0.0f && &picture != &out);
    fit(out, picture.width, picture.height);
    if (picture.pixels.empty()) return;
    const int side = std::max(1, (picture.height + kRows / 2) / kRows);
    std::size_t levels = 1;
    for (int shorter = std::min(picture.width, picture.height) / side; shorter >= 2 * kFewest; shorter /= 2)
        ++levels;
    halves_.resize(levels);
    veils_.resize(levels);
    shrink(picture, side, settings.most, jobs, halves_[0]);
    for (std::size_t i = 1; i < levels; ++i) shrink(halves_[i - 1], 2, settings.most, jobs, halves_[i]);
    veils_.back() = halves_.back();
    for (std::size_t i = levels - 1; i-- > 0;)
        join(halves_[i], veils_[i + 1], static_cast<int>(levels - 1 - i), jobs, veils_[i]);
    widen(veils_[0], side, picture.width, jobs, wide_);

    jobs.run(rows_of(picture), [&](std::size_t row, int) {
        const int y = static_cast<int>(row);
        const Between v = between(y, side, wide_.height);
        const VeilRows rows{&wide_.at(0, v.low).x, &wide_.at(0, v.high).x, v.share};
        lay_over(&picture.at(0, y).x, rows, settings.share, 3 * static_cast<std::size_t>(picture.width),
                 &out.at(0, y).x);
    });
}

}  // namespace gh::filter

#include "over_time.h"

#include "shown.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace speed_error {

namespace {

constexpr int kSettling = 16, kWatched = 8, kDark = 40;
constexpr int kTogether = 4;  // one noisy frame alone says little
constexpr double kGone = 0.1;
constexpr double kNever = 99.0;

struct Frames {
    // As a screen shows them, exposed for the lit ones: the radiance of a lamp's bulb would drown all else. The last
    // kWatched lit ones; all kDark dark ones.
    std::vector<gh::Image> lit, dark;
};

Frames film(const Contestant& contestant, const View& view, int width, int height, const gh::Jobs& jobs) {
    Frames frames;
    gh::render::Film picture(width, height);
    const Studio& studio = view.studio;
    const Run make = contestant.begin();
    float exposure = 1.0f;
    const int lit = kSettling + kWatched;
    for (int frame = 0; frame < lit + (studio.has_switches() ? kDark : 0); ++frame) {
        const gh::render::SceneView scene = frame < lit ? studio.lit_view() : studio.dark_view();
        make(
            {.scene = scene, .camera = view.camera, .frame = static_cast<std::uint32_t>(frame), .jobs = jobs},
            picture);
        if (frame < kSettling) continue;
        if (frame == kSettling) exposure = gh::filter::metered_exposure(picture.radiance);
        (frame < lit ? frames.lit : frames.dark).push_back(shown(picture.radiance, exposure, jobs));
    }
    return frames;
}

gh::Image mean_of(const std::vector<gh::Image>& pictures, std::size_t first) {
    gh::Image mean(pictures[0].width, pictures[0].height);
    for (std::size_t k = first; k < pictures.size(); ++k) {
        for (std::size_t i = 0; i < mean.pixels.size(); ++i)
            mean.pixels[i] += pictures[k].pixels[i] / static_cast<float>(pictures.size() - first);
    }
    return mean;
}

// Mean over pixels of what a screen shows, as a share of white.
double deviation_of(const std::vector<gh::Image>& seen) {
    const auto count = static_cast<double>(seen.size());
    double total = 0.0;
    for (std::size_t i = 0; i < seen[0].pixels.size(); ++i) {
        double sum = 0.0, squares = 0.0;
        for (const gh::Image& picture : seen) {
            const double value = brightness(picture.pixels[i]);
            sum += value;
            squares += value * value;
        }
        total += std::sqrt(std::max(0.0, (squares - sum * sum / count) / (count - 1.0)));
    }
    return total / static_cast<double>(seen[0].pixels.size());
}

// How much of (lit - dark) a picture still has, as a screen shows them.
double left_of(const gh::Image& picture, const gh::Image& lit, const gh::Image& dark) {
    double along = 0.0, whole = 0.0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const glm::dvec3 step(lit.pixels[i] - dark.pixels[i]);
        along += glm::dot(glm::dvec3(picture.pixels[i] - dark.pixels[i]), step);
        whole += glm::dot(step, step);
    }
    return whole > 0.0 ? along / whole : 0.0;
}

}  // namespace

Finding judge_over_time(const Contestant& contestant, const View& view, int width, int height,
                        const gh::Jobs& jobs) {
    Finding finding{.table = "over time, of what is shown",
                    .view = view.name,
                    .name = contestant.family,
                    .key = view.key,
                    .values = {}};
    const Frames frames = film(contestant, view, width, height, jobs);
    finding.values.emplace_back("deviation %", 100.0 * deviation_of(frames.lit));
    if (frames.dark.empty()) return finding;
    const gh::Image lit = mean_of(frames.lit, 0);
    const gh::Image dark = mean_of(frames.dark, frames.dark.size() - kWatched);
    std::vector<double> left;
    for (const gh::Image& picture : frames.dark) left.push_back(left_of(picture, lit, dark));
    double gone = kNever;
    for (std::size_t k = left.size() - kTogether + 1; k-- > 0;) {
        const auto first = left.begin() + static_cast<std::ptrdiff_t>(k);
        const double mean = std::accumulate(first, first + kTogether, 0.0) / kTogether;
        if (left[k] <= kGone && mean <= kGone)
            gone = static_cast<double>(k + 1);  // the first such frame stays
    }
    finding.values.emplace_back("frames to 10 %", gone);
    finding.values.emplace_back("left in the first %", 100.0 * left[0]);
    return finding;
}

}  // namespace speed_error

#include "adaptive_gap.h"

#include "clocks.h"
#include "metrics/picture_metrics.h"
#include "render/whitted.h"
#include "shown.h"

#include <fmt/format.h>

namespace speed_error {

namespace {

constexpr int kWidth = 640, kHeight = 360;

}  // namespace

std::vector<Finding> adaptive_gaps(const View& view, const gh::Jobs& jobs) {
    const auto render = [&](const gh::render::WhittedSettings& settings, std::uint32_t seed,
                            gh::render::Film& film) {
        const double start = core_ms();
        gh::render::render_whitted(view.studio.lit_view(), view.camera, settings, seed, jobs, film);
        return core_ms() - start;
    };
    gh::render::Film full(kWidth, kHeight), other(kWidth, kHeight);
    const double full_ms = render({}, 0, full);
    const float exposure = gh::filter::metered_exposure(full.radiance);
    const gh::Image wanted = shown(full.radiance, exposure, jobs);
    std::vector<Finding> gaps;
    const auto compare = [&](const std::string& name, double ms) {
        gaps.push_back(
            {.table = "adaptive against full sampling, same seed, 640x360",
             .view = view.name,
             .name = name,
             .key = view.key,
             .values = {{"FLIP", metrics::flip(shown(other.radiance, exposure, jobs), wanted).mean},
                        {"relMSE", metrics::rel_mse(other.radiance, full.radiance).all},
                        {"core-ms", ms},
                        {"core-ms in full", full_ms},
                        {"light worked out %", 100.0 * static_cast<double>(other.stats.lit_pixels) /
                                                   static_cast<double>(kWidth * kHeight)}}});
    };
    for (const float contrast : {0.05f, 0.1f, 0.25f, 0.5f}) {
        const double ms = render({.is_adaptive = true, .contrast = contrast}, 0, other);
        compare(fmt::format("contrast {:.2g}", contrast), ms);
    }
    compare("full, another seed", render({}, 1, other));
    return gaps;
}

}  // namespace speed_error

#include "filter/atrous.h"

#include "filter/albedo.h"
#include "filter/atrous_kernel.h"
#include "filter/mend.h"
#include "filter/rows.h"

#include <algorithm>

namespace gh::filter {

namespace {

// The furthest a kernel may look beside its row.
constexpr int kFurthest = static_cast<int>(Plane::kMargin);
constexpr int kMostLevels = 7;

void expect_fit(const Guides& guides, const SignalView& in, const AtrousSettings& settings, int level) {
    EXPECTS(settings.radius == 1 || settings.radius == 2);
    EXPECTS(level >= 0 && level < kMostLevels && (settings.radius << level) <= kFurthest);
    EXPECTS(settings.luminance_sigmas > 0.0f);
    EXPECTS(in.light->width() == guides.width() && in.light->height() == guides.height());
}

AtrousRow row_of(const Guides& guides, int radius, int level, int y) {
    AtrousRow row{};
    row.guides = rows_of(guides, y);
    row.radius = radius;
    row.step = 1 << level;
    row.width = guides.width();
    row.height = guides.height();
    row.y = y;
    row.stride = guides.nearness.stride();
    return row;
}

void add_signal(const SignalView& in, const AtrousSettings& settings, bool leaves_variance, Signal& out,
                AtrousRow& row) {
    EXPECTS(row.count < kMostTogether);
    AtrousSignal& signal = row.signals[row.count++];
    point_to(signal.light, *in.light, row.y);
    signal.variance = in.variance->row(row.y);
    signal.stiffness = in.stiffness == nullptr || in.stiffness->empty() ? nullptr : in.stiffness->row(row.y);
    signal.part = in.part == nullptr ? nullptr : in.part->row(row.y);
    point_to(signal.out_light, out.light, row.y);
    signal.out_variance = leaves_variance ? out.variance.row(row.y) : nullptr;
    signal.luminance_sigmas = settings.luminance_sigmas;
}

// One row of a level of all signals that have it. Those of one radius ask the same neighbours.
void smooth_level(const Guides& guides, std::span<const Smoothing> signals, int level, int y) {
    for (const int radius : {1, 2}) {
        AtrousRow row = row_of(guides, radius, level, y);
        for (const Smoothing& signal : signals) {
            if (level >= signal.settings.levels || signal.settings.radius != radius) continue;
            SignalView from = signal.in;
            if (level > 0) {
                const Signal& before = signal.scratch[(level - 1) % 2];
                from.light = &before.light;
                from.variance = &before.variance;
            }
            const bool is_last = level + 1 == signal.settings.levels;
            add_signal(from, signal.settings, signal.leaves_variance || !is_last, signal.scratch[level % 2],
                       row);
        }
        if (row.count > 0) atrous_row(row);
    }
}

}  // namespace

void Signal::fit(int width, int height) {
    fit_together(width, height, light, variance);
}

void atrous_level(const Guides& guides, const SignalView& in, const AtrousSettings& settings, int level,
                  const Jobs& jobs, Signal& out) {
    expect_fit(guides, in, settings, level);
    EXPECTS(in.light != &out.light);
    out.fit(guides.width(), guides.height());
    run_rows_apart(guides.height(), 1 << level, jobs, [&](int y) {
        AtrousRow row = row_of(guides, settings.radius, level, y);
        add_signal(in, settings, true, out, row);
        atrous_row(row);
    });
}

void make_signal(const Plane3& light, const Plane& variance, const Jobs& jobs, Signal& signal) {
    EXPECTS(light.width() == variance.width() && light.height() == variance.height());
    signal.fit(light.width(), light.height());
    mend(light, {.floor = kInfiniteLight, .factor = 1.0f}, jobs, signal.light);
    luma_from(signal.light, jobs, signal.light);
    run_rows(light.height(), jobs, [&](int y) {
        for (int x = 0; x < light.width(); ++x) {
            const float v = variance.at(x, y);
            signal.variance.at(x, y) = v > 0.0f && v < kInfiniteLight ? v : 0.0f;
        }
    });
}

void add_atrous(const Guides& guides, std::span<const Smoothing> signals, RowPasses& passes) {
    int levels = 0, radius = 1;
    for (const Smoothing& signal : signals) {
        EXPECTS(signal.settings.levels >= 1);
        levels = std::max(levels, signal.settings.levels);
        radius = std::max(radius, signal.settings.radius);
        expect_fit(guides, signal.in, signal.settings, signal.settings.levels - 1);
        for (int i = 0; i < std::min(2, signal.settings.levels); ++i)
            signal.scratch[i].fit(guides.width(), guides.height());
    }
    for (int level = 0; level < levels; ++level) {
        passes.begin(radius << level);
        passes.add([level, signals, &guides](int y) { smooth_level(guides, signals, level, y); });
    }
}

void atrous(const Guides& guides, std::span<const Smoothing> signals, const Jobs& jobs) {
    RowPasses passes;
    add_atrous(guides, signals, passes);
    passes.run(guides.height(), jobs);
}

const Signal& atrous(const Guides& guides, const SignalView& in, const AtrousSettings& settings,
                     const Jobs& jobs, Signal scratch[2]) {
    const Smoothing one{in, settings, scratch};
    atrous(guides, std::span(&one, 1), jobs);
    return scratch[(settings.levels - 1) % 2];
}

}  // namespace gh::filter

// filter/denoise_settings.h - how much of what the denoiser does.
#pragma once

#include "filter/atrous.h"
#include "filter/mend.h"
#include "filter/temporal.h"

namespace gh::filter {

struct DenoiseSettings {
    MendSettings mend{};
    TemporalSettings temporal{};
    // Levels of 0: not smoothed over the picture.
    AtrousSettings direct{.levels = 2};
    AtrousSettings indirect{.levels = 3, .luminance_sigmas = 8.0f};  // no edges of its own to keep
    AtrousSettings specular{.levels = 2, .luminance_sigmas = 5.0f};
    // So many more, up to five, while nothing is known of the past: still pictures, and the first one after a cut.
    int more_levels_at_first = 2;
    // Whether they are filtered at half the picture's sides and then spread by its surfaces (halve.h). Both together spare a
    // fifth of the time, one alone nothing; in small pictures smooth floors mirror sharper than that.
    bool halves_indirect = false;
    bool halves_specular = false;
    // Whether unknown changes are looked for: paths that are asked again (Light::change_then) know nothing of the light on what
    // moves by itself.
    bool settles = true;
    float settle_sigmas = 2.0f;
    // Light::change_then counts so many times: a little noise for a moment is less to be seen than light that lingers.
    float change_sharpness = 4.0f;
    // Whether pictures are added up at the end (picture_mean.h): for those taken through other places of their pixels.
    bool adds_up = false;
};

}  // namespace gh::filter

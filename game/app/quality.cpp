#include "app/quality.h"

#include <algorithm>

namespace gh::app {

Quality quality_of(present::QualityName name) {
    Quality quality{.whitted = {.texture_taps = 4.0f, .is_adaptive = true},
                    .path = render::realtime_path(),
                    .fewest_shown = 480.0f * 270.0f,  // with fewer a room can not be read
                    .most_lit = 3840.0f * 2160.0f};
    switch (name) {
        case present::QualityName::Low:
            quality.whitted.texture_taps = 2.0f;
            quality.whitted.contrast = 0.5f;
            quality.whitted.max_depth = 4;
            quality.path.texture_taps = 2.0f;
            quality.path.max_depth = 4;
            quality.fewest_shown = 384.0f * 216.0f;
            quality.most_lit = 640.0f * 360.0f;
            break;
        case present::QualityName::Medium:
            break;
        case present::QualityName::High:
            quality.whitted.texture_taps = 8.0f;
            quality.whitted.contrast = 0.1f;
            quality.path.texture_taps = 8.0f;
            quality.fewest_shown = 720.0f * 405.0f;
            break;
        case present::QualityName::Ultra:
            quality.whitted.texture_taps = 8.0f;
            quality.whitted.is_adaptive = false;
            quality.path.texture_taps = 8.0f;
            quality.path.max_scatters = 2;
            quality.fewest_shown = 960.0f * 540.0f;
            break;
    }
    return quality;
}

std::optional<present::QualityName> quality_named(std::string_view word) {
    const auto found = std::find(present::kQualityWords.begin(), present::kQualityWords.end(), word);
    if (found == present::kQualityWords.end()) return std::nullopt;
    return static_cast<present::QualityName>(found - present::kQualityWords.begin());
}

}  // namespace gh::app

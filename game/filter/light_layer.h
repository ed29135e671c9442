// filter/light_layer.h - the lights that are filtered at one size, through the frames: what denoiser.h is made of.
//
// Threads   belongs to one caller at a time. Same bits and bad input as denoiser.h says.
#pragma once

#include "filter/anti_lag.h"
#include "filter/atrous.h"
#include "filter/denoise_settings.h"
#include "filter/gbuffer.h"
#include "filter/guides.h"
#include "filter/reproject.h"
#include "filter/rows.h"
#include "filter/temporal.h"

#include <array>
#include <cstddef>

namespace gh::filter {

class LightLayer {
  public:
    // What one frame brings; all of it must live until its passes have run.
    struct Frame {
        const GBuffer& surfaces;
        const Light& light;
        const DenoiseSettings& settings;
        bool leaves_indirect = false, leaves_specular = false;  // to another layer
        bool is_plain = false;  // light that was mended and taken off its colour already
        int pixels = 1;         // of the picture, along a side, that one of these is
    };
    // From samples to what is shown, as passes of rows after those that fill the frame.
    void add_passes(const Frame& frame, RowPasses& passes);
    // Once they have run.
    void finish(const GBuffer& surfaces);

    // Null: there is no such light. Valid once passes were added, filled when they have run.
    [[nodiscard]] const Luma3* direct() const { return direct_.smooth; }
    [[nodiscard]] const Luma3* indirect() const { return indirect_.smooth; }
    [[nodiscard]] const Luma3* specular() const { return specular_.smooth; }
    [[nodiscard]] const Guides& guides() const { return guides_; }
    // Of direct light.
    [[nodiscard]] const Plane& history_length() const { return direct_.mean.length; }
    [[nodiscard]] const Plane& variance() const { return direct_.variance; }
    // Of the light that was added last; empty if nobody asked paths again.
    [[nodiscard]] const Plane* change(const Light& light) const {
        return asks_change(light) ? &change_ : nullptr;
    }

    // Of surfaces since the last picture; null: nobody found it. Filled when the passes have run.
    [[nodiscard]] const Movement* movement() const { return has_movement_ ? &movement_ : nullptr; }

  private:
    // One of the lights through the frames.
    struct Track {
        Accumulated mean, before;
        Plane variance;
        Plane sums[2];      // while it settles
        Signal scratch[2];  // the a-trous levels by turns; before them, the samples as they are mended
        const Luma3* smooth = nullptr;  // what is shown; null: there is no such light
    };

    [[nodiscard]] bool asks_change(const Light& light) const;
    void find_past(Motion motion, const Frame& frame, RowPasses& passes);
    void add_samples(const Plane3& light, const Plane& told, const Plane3& albedo, const Frame& frame,
                     RowPasses& passes, Track& track);
    void accumulate_tracks(const Frame& frame, RowPasses& passes);
    void settle_tracks(const Frame& frame, RowPasses& passes);
    void smooth_tracks(const Frame& frame, RowPasses& passes);

    Guides guides_;
    SeenSurfaces seen_;
    PlaneU32 part_;  // of this frame
    Taps taps_;
    Movement movement_;
    bool has_movement_ = false;
    Track direct_, indirect_, specular_;
    std::array<Smoothing, 3> smoothing_;
    Plane stiffness_;
    Plane change_;
};

}  // namespace gh::filter

// filter/temporal.h - light of many frames added up where reproject() found the same surface.
//
// A signal's history is the running mean of its samples: the n-th counts 1/n, so noise falls as 1/sqrt(n), until n
// reaches a cap and the mean becomes one over the last frames. Beside it run the mean square of the luminance, for the
// variance (Schied et al. 2017, equation 4), and a second, fast mean over two or three frames, by which settle() in
// anti_lag.h notices that light has changed.
//
// Cost      about 12 cycles a pixel and signal; 30 where motion tears neighbours apart.
// Threads   reads its arguments only. Same bits for any number of threads and any instruction set.
// Energy    constant in, constant out, exactly; a mean of samples is what comes out, nothing is clamped here.
// Bad input a sample that is not finite is skipped: history stands in for it, black where there is none.
#pragma once

#include "base/jobs.h"
#include "filter/plane.h"
#include "filter/reproject.h"

namespace gh::filter {

struct TemporalSettings {
    float longest = 32.0f;      // frames a mean goes over at most, >= 1
    float fast_longest = 2.0f;  // of the fast mean, >= 1
};

// A signal with all that was learnt of it over the frames.
struct Accumulated {
    Luma3 light;   // mean
    Plane square;  // mean square of the samples' luminance
    Plane length;  // samples in the mean; 0: none yet. Not whole where taps differ
    Plane fast;    // luminance of the fast mean

    void fit(int width, int height);
};

// What the last frame left, empty at the beginning, and where in it each pixel was.
struct Past {
    const Taps& taps;
    const Accumulated& before;
};

// `out` is made to fit, and is not what the past is in. `change` (may be empty) is the share of the light known to be
// new, 0 ... 1: the mean forgets that share of its past.
void accumulate(const Plane3& samples, const Plane& change, const Past& past,
                const TemporalSettings& settings, const Jobs& jobs, Accumulated& out);
[[nodiscard]] RowWork accumulate_rows(const Plane3& samples, const Plane& change, const Past& past,
                                      const TemporalSettings& settings, Accumulated& out);

}  // namespace gh::filter

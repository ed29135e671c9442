// filter/glare.h - the halo that the eye puts round a lamp: a share of all light that enters it is scattered by lens and
// retina and veils what lies beside (Vos 1984; Spencer, Shirley, Zimmerman and Greenberg 1995). Lamps are a thousand times
// as bright as white, and a screen has only white: by their halos one sees that they burn.
//
// The veil falls off about as one over the squared angle, as Spencer's does from a third of a degree on, to a ninth of the
// picture's height; a quarter away it ends. It is a sum of blurs, each as strong as the one before and twice as wide,
// made on a picture 180 rows high, so that halos do not depend on the resolution.
//
// Cost      1280x720: 4.7 core-ms. Keeps its small pictures between calls.
// Same bits for any number of threads: rows are independent.
// Energy    a constant stays that constant to 1e-6; what lies beyond the picture is taken to be like its border.
// Bad input what is not a number gives no light; what is brighter than `most` veils as if it were that bright: a lamp
//           smaller than a pixel, met in one frame and missed in the next, is not to flicker in half of the picture.
#pragma once

#include "base/image.h"
#include "base/jobs.h"

#include <vector>

namespace gh::filter {

struct GlareSettings {
    float share = 0.05f;  // of the light is scattered, in [0, 1]; a healthy eye's is .05 to .1 (Vos 1984)
    float most = 100.0f;  // radiance
};

class Glare {
  public:
    // The picture through an eye that scatters. `out` is made to fit and is not `picture`.
    void veil(const Image& picture, const GlareSettings& settings, const Jobs& jobs, Image& out);

  private:
    std::vector<Image> halves_;  // each half as large as the one before, both ways
    std::vector<Image> veils_;   // of the same sizes
    Image wide_;                 // the first of them, as wide as the picture
};

}  // namespace gh::filter

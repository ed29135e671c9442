// speed_error/over_time.h - what a way of making pictures does from frame to frame: boil where nothing changes, and lag
// where a lamp goes out.
#pragma once

#include "contestants.h"
#include "findings.h"
#include "studio.h"

namespace speed_error {

// "deviation %": of a pixel as it is shown, of white, over eight frames of a view in which nothing moves, after sixteen.
// "frames to 10 %": after all lamps with a switch went off, until no more than a tenth of what they gave is left, in this
// frame and in the mean of four from it: frame 1 is the first picture of the dark room; 99 if that is never so. "left in
// the first": of what was shown, in per cent.
// What is left is the picture's part along (lit - dark), both as this very way shows them when it has settled, so that
// neither noise nor bias counts as lag.
[[nodiscard]] Finding judge_over_time(const Contestant& contestant, const View& view, int width, int height,
                                      const gh::Jobs& jobs);

}  // namespace speed_error

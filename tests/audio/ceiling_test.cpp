#include "audio/ceiling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gh::audio {
namespace {

TEST(Ceiling, LeavesWhatIsNotLoudAsItIs) {
    for (const float sample : {0.0f, 1e-8f, 0.3f, -0.5f, 0.8f, -0.8f})
        EXPECT_EQ(under_ceiling(sample), sample);
}

TEST(Ceiling, LouderStaysLouderAndBelowOneForEitherSign) {
    float before = 0.0f;
    for (float sample = 0.01f; sample < 50.0f; sample *= 1.01f) {
        const float bent = under_ceiling(sample);
        EXPECT_GT(bent, before) << sample;
        EXPECT_LT(bent, 1.0f) << sample;
        EXPECT_EQ(under_ceiling(-sample), -bent) << sample;
        before = bent;
    }
}

// A step in the slope would be heard as a rasp: a click is what a limiter is there to avoid.
TEST(Ceiling, BendsWithoutAnEdge) {
    constexpr float kStep = 1e-3f;
    const float at_knee = (under_ceiling(kKnee + kStep) - under_ceiling(kKnee)) / kStep;
    EXPECT_NEAR(at_knee, 1.0f, 0.01f);
}

TEST(Ceiling, WhatIsNoNumberIsSilence) {
    EXPECT_EQ(under_ceiling(std::nanf("")), 0.0f);
    EXPECT_LT(under_ceiling(std::numeric_limits<float>::infinity()), 1.0f);
    EXPECT_GT(under_ceiling(-std::numeric_limits<float>::infinity()), -1.0f);
}

}  // namespace
}  // namespace gh::audio

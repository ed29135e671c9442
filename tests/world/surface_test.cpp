// What a wall is made of decides what one hears through it.
#include "world/surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gh::world {
namespace {

TEST(Surface, HasANameThatLeadsBackToIt) {
    for (std::size_t i = 0; i < kSurfaceCount; ++i) {
        const auto surface = static_cast<Surface>(i);
        EXPECT_EQ(surface_from_name(surface_name(surface)), surface);
    }
    EXPECT_EQ(surface_name(Surface::Parquet), "parquet");
    EXPECT_EQ(surface_from_name("cardboard"), std::nullopt);
    EXPECT_EQ(surface_from_name(""), std::nullopt);
}

TEST(Surface, AbsorbsAShareOfTheSound) {
    for (std::size_t i = 0; i < kSurfaceCount; ++i) {
        for (const float share : acoustics(static_cast<Surface>(i)).absorption) {
            EXPECT_GT(share, 0.0f);
            EXPECT_LT(share, 1.0f);
        }
    }
}

// TL = 20 log10(f m) - 47 dB: four times the frequency is 12 dB more, and the mass gives the rest.
TEST(Surface, StopsSoundByTheMassLaw) {
    const struct {
        Surface surface;
        double mass;  // kg/m2
    } walls[] = {{Surface::Marble, 500}, {Surface::Plaster, 180}, {Surface::Stud, 22},
                 {Surface::Glass, 10},   {Surface::Pane, 15},     {Surface::Oak, 28},
                 {Surface::Metal, 7.8},  {Surface::Curtain, 1}};
    constexpr double kBand[kBands] = {250.0, 1000.0, 4000.0};
    for (const auto& [surface, mass] : walls) {
        for (std::size_t b = 0; b < kBands; ++b) {
            EXPECT_NEAR(acoustics(surface).transmission_loss_db[b], 20.0 * std::log10(kBand[b] * mass) - 47.0,
                        0.6)
                << surface_name(surface) << " at " << kBand[b] << " Hz";
        }
    }
}

}  // namespace
}  // namespace gh::world

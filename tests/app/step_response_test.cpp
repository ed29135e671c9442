// What path-traced pictures in a row leave of light that is no longer there, when nobody tells: a tenth at most after four
// of them, whether a lamp goes out or moves on by a metre a picture.
#include "app/view.h"

#include "render/studio.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gh::app {
namespace {

constexpr int kWidth = 96, kHeight = 54;
constexpr int kPicturesAllowed = 4;
constexpr float kShareAllowed = 0.1f;
constexpr float kWallZ = -2.0f;

// A long grey room, and a lamp just before its far wall.
class Gallery {
  public:
    Gallery() {
        studio_.add_box({-12, 0, kWallZ}, {12, 4, 10}, test::matte(glm::vec3(0.5f)), true);
        world::Lamp lamp;
        lamp.shape = world::LampShape::Sphere;
        lamp.radius = 0.1f;
        lamp.intensity = glm::vec3(50.0f);
        lamp.position = {-8.0f, 2.0f, kWallZ + 0.5f};
        studio_.add_lamp(lamp);
        studio_.open({.bakes_ambient = false, .lamp_list_rays = 0});
    }

    void light(float x, float radiance) {
        studio_.level.lamps[0].position.x = x;
        studio_.level.lamps[0].intensity = glm::vec3(radiance);
    }

    // The next picture of the row.
    void show(View& view, std::uint32_t frame) const {
        const render::SceneView scene{studio_.level, studio_.snapshot, studio_.prepared, &studio_.snapshot};
        view.expose_next(scene, kCamera, settings(), frame, {{kWidth, kHeight}, 1}, Jobs(2));
    }

    [[nodiscard]] Image truth() const {
        render::PathSettings many = settings();
        many.samples_per_pixel = 16;
        many.fills_planes = false;
        render::Film film(kWidth, kHeight);
        render::render_path({studio_.level, studio_.snapshot, studio_.prepared}, kCamera, many, 1000, Jobs(2),
                            film);
        return film.radiance;
    }

    // Mean luminance of the wall within half a metre of the place before which the lamp stands at `x`.
    [[nodiscard]] static float on_wall(const Image& picture, float x) {
        const render::Lens lens(kCamera, kWidth, kHeight);
        float sum = 0.0f;
        int count = 0;
        for (int row = 0; row < kHeight; ++row) {
            for (int column = 0; column < kWidth; ++column) {
                const rc::Ray ray = lens.ray(glm::vec2(column, row) + 0.5f);
                const glm::vec3 at =
                    ray.origin + ray.direction * ((kWallZ - ray.origin.z) / ray.direction.z);
                if (std::abs(at.x - x) > 0.5f || std::abs(at.y - 2.0f) > 0.5f) continue;
                sum += picture.at(column, row).y;
                ++count;
            }
        }
        EXPECT_GT(count, 8);
        return sum / static_cast<float>(count);
    }

  private:
    static render::PathSettings settings() {
        render::PathSettings settings = render::realtime_path();
        settings.ends_in_bake = false;
        return settings;
    }

    static constexpr render::Camera kCamera{.position = {0.0f, 2.0f, 9.0f}, .fov_y = 0.9f};
    test::Studio studio_;
};

TEST(StepResponse, ALampThatGoesOutUntoldIsDarkWithinFourPictures) {
    Gallery gallery;
    View view(kWidth, kHeight);
    gallery.light(0.0f, 50.0f);
    std::uint32_t frame = 0;
    for (; frame < 24; ++frame) gallery.show(view, frame);
    const float lit = Gallery::on_wall(view.shown(), 0.0f);
    ASSERT_GT(lit, 0.2f);
    gallery.light(0.0f, 0.0f);
    for (int picture = 0; picture < kPicturesAllowed; ++picture) gallery.show(view, frame++);
    EXPECT_LT(Gallery::on_wall(view.shown(), 0.0f), kShareAllowed * lit);
}

TEST(StepResponse, ALampThatMovesAMetreAPictureDragsNoTrailLongerThanFourMetres) {
    Gallery gallery;
    View view(kWidth, kHeight);
    float left_behind = 0.0f, worst = -1.0f;
    int counted = 0;
    for (std::uint32_t frame = 0; frame <= 14; ++frame) {
        const float x = static_cast<float>(frame) - 7.0f;
        gallery.light(x, 50.0f);
        gallery.show(view, frame);
        if (frame < 10) continue;
        const Image truth = gallery.truth();
        const float passed = x - static_cast<float>(kPicturesAllowed);
        const float share = (Gallery::on_wall(view.shown(), passed) - Gallery::on_wall(truth, passed)) /
                            Gallery::on_wall(truth, x);
        left_behind += share;
        worst = std::max(worst, share);
        ++counted;
    }
    RecordProperty("worst", std::to_string(worst));
    RecordProperty("mean", std::to_string(left_behind / static_cast<float>(counted)));
    EXPECT_LT(worst, kShareAllowed);
    EXPECT_GT(left_behind / static_cast<float>(counted), -0.05f) << "nor is light taken away that is there";
}

}  // namespace
}  // namespace gh::app

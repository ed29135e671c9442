// What a scene needs is found, and a kernel made for it gives the bits of the kernel that can do everything.
#include "render/scene_needs.h"

#include "path_studio.h"

#include <gtest/gtest.h>

namespace gh {
namespace {

using render::Need;
using test::Studio;

render::SceneNeeds needing(std::initializer_list<Need> all) {
    render::SceneNeeds needs;
    for (const Need need : all) needs.add(need);
    return needs;
}

void add_room(Studio& studio) {
    studio.add_box({-2, 0, -2}, {2, 3, 2}, test::matte(glm::vec3(0.6f)), true);
    studio.add_sheet({0, 2.9f, 0}, {0.4f, 0, 0}, {0, 0, 0.4f}, test::glowing(8.0f));
}

TEST(SceneNeeds, ADullRoomNeedsItsLampAlone) {
    Studio studio;
    add_room(studio);
    studio.open();
    EXPECT_EQ(studio.prepared.needs, needing({Need::Emitters}));
    EXPECT_EQ(render::sentence_of(studio.prepared.needs), "emitters");
    EXPECT_EQ(render::sentence_of({}), "nothing");
}

TEST(SceneNeeds, WhatNoTriangleIsMadeOfIsNotNeeded) {
    Studio studio;
    add_room(studio);
    studio.level.materials.push_back(test::clear_glass(1.5f));
    studio.open();
    EXPECT_EQ(studio.prepared.needs, needing({Need::Emitters}));
}

TEST(SceneNeeds, EachThingInARoomIsNoticed) {
    const auto found = [](const auto& furnish) {
        Studio studio;
        add_room(studio);
        furnish(studio);
        studio.open();
        EXPECT_EQ(render::scene_needs(studio.level), studio.prepared.needs) << "found without preparing";
        return studio.prepared.needs;
    };
    const auto box_of = [](const world::Material& material) {
        return [material](Studio& studio) { studio.add_box({0, 1, 0}, {1, 2, 1}, material); };
    };
    world::Material gloss = test::mirror(0.9f);
    gloss.roughness = 0.4f;
    EXPECT_EQ(found(box_of(gloss)), needing({Need::Emitters, Need::Gloss}));
    EXPECT_EQ(found(box_of(test::mirror(0.9f))), needing({Need::Emitters, Need::Gloss, Need::Mirrors}));
    world::Material leaf = test::matte(glm::vec3(0.3f));
    leaf.alpha_mode = world::AlphaMode::Mask;
    EXPECT_EQ(found(box_of(leaf)), needing({Need::Emitters, Need::Holes}));
    world::Material glass = test::clear_glass(1.5f);
    const render::SceneNeeds solid = needing({Need::Emitters, Need::Gloss, Need::Mirrors, Need::SolidGlass});
    EXPECT_EQ(found(box_of(glass)), solid);
    const auto pane = [&](Studio& studio) { studio.add_sheet({0, 1, 0}, {1, 0, 0}, {0, 1, 0}, glass); };
    EXPECT_TRUE(found(pane).has(Need::Sheets));
    EXPECT_FALSE(found(pane).has(Need::SolidGlass));
    glass.attenuation_distance = 0.5f;
    EXPECT_TRUE(found(box_of(glass)).has(Need::Absorption));
    world::Material cloth = test::matte(glm::vec3(0.3f));
    cloth.has_layers = true;
    cloth.layers.sheen_color = glm::vec3(0.5f);
    EXPECT_EQ(found(box_of(cloth)), needing({Need::Emitters, Need::Cloth}));
    const auto apart = [&](Studio& studio) {
        studio.add_box({0, 1, 0}, {1, 2, 1}, glass);
        studio.add_box({-1.5f, 1, 0}, {-0.5f, 2, 1}, glass);
    };
    EXPECT_FALSE(found(apart).has(Need::NestedGlass));
    const auto touching = [&](Studio& studio) {
        studio.add_box({0, 1, 0}, {1, 2, 1}, glass);
        studio.add_box({-1, 1, 0}, {0, 2, 1}, glass);
    };
    EXPECT_TRUE(found(touching).has(Need::NestedGlass));
    const auto many = [](Studio& studio) {
        for (int i = 0; i < 20; ++i) studio.add_lamp({.name = {}, .position = {0, 1, 0}});
    };
    EXPECT_EQ(found(many), needing({Need::Emitters, Need::BareLamps, Need::ManyLights}));
}

std::vector<glm::vec3> positions_of(const render::Film& film) {
    std::vector<glm::vec3> positions;
    if (film.planes.part.empty()) return positions;
    for (int y = 0; y < film.radiance.height; ++y) {
        for (int x = 0; x < film.radiance.width; ++x) positions.push_back(film.planes.position.get(x, y));
    }
    return positions;
}

// Pictures of scenes with and without what kernels differ in, by the kernel that is picked and by the one for everything.
void expect_same_bits(const Studio& studio, const std::string& what) {
    const render::Camera camera{.position = {0.3f, 1.4f, 1.9f}, .yaw = 0.1f, .pitch = -0.1f, .fov_y = 1.2f};
    std::vector<render::PathSettings> all(4, test::reference(3));
    all[1].fills_planes = true;
    all[2] = render::realtime_path();
    all[3] = render::cook_path();
    for (std::size_t i = 0; i < all.size(); ++i) {
        render::Film picked(40, 24), general(40, 24);
        const render::SceneView view{studio.level, studio.snapshot, studio.prepared};
        render::render_path(view, camera, all[i], 1, Jobs(1), picked);
        all[i].uses_general_kernel = true;
        render::render_path(view, camera, all[i], 1, Jobs(1), general);
        EXPECT_EQ(picked.radiance.pixels, general.radiance.pixels) << what << ", settings " << i;
        EXPECT_EQ(positions_of(picked), positions_of(general)) << what << ", settings " << i;
        EXPECT_EQ(picked.stats.total(), general.stats.total()) << what << ", settings " << i;
    }
}

TEST(SceneNeeds, AKernelForLessGivesTheBitsOfTheKernelForAll) {
    Studio dull;
    add_room(dull);
    dull.add_box({-1, 0.01f, -1}, {0, 1, 0}, test::matte({0.7f, 0.3f, 0.1f}));
    dull.open({.bakes_ambient = true});
    expect_same_bits(dull, "dull");
    world::Material varnished = test::matte({0.2f, 0.4f, 0.1f});
    varnished.has_layers = true;
    varnished.layers.coat = 0.7f;
    varnished.layers.coat_roughness = 0.1f;
    Studio shiny = dull;
    shiny.add_ball({1, 0.6f, -0.5f}, 0.4f, 12, test::mirror(0.8f));
    shiny.add_box({-1.9f, 0.01f, 0.2f}, {-1.2f, 0.8f, 0.9f}, varnished);
    shiny.open({.bakes_ambient = true});
    expect_same_bits(shiny, "shiny");
    Studio glassy = shiny;
    glassy.add_ball({0.3f, 1.2f, 0.3f}, 0.3f, 12, test::clear_glass(1.5f));
    glassy.add_sheet({-0.8f, 1.5f, 0.5f}, {0.5f, 0, 0}, {0, 0.5f, 0}, test::clear_glass(1.5f));
    glassy.open({.bakes_ambient = true});
    expect_same_bits(glassy, "glassy");
}

}  // namespace
}  // namespace gh

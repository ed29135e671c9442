// A sound asks for the walls on its way a few at a time. However few, each wall takes its share exactly once: none is
// passed over because another lies at the same distance, and none is counted again.
#include "support/brute_force.h"
#include "support/isas.h"
#include "support/shapes.h"

#include "raycore/query.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace {

using test::Random;

class Crossings : public ::testing::TestWithParam<rc::Isa> {};

std::vector<rc::Hit> page_by_page(const rc::Scene& scene, const glm::vec3& from, const glm::vec3& to,
                                  std::size_t page, std::size_t most) {
    std::vector<rc::Hit> all, out(page);
    std::size_t n = rc::crossings(scene, from, to, rc::kAllLayers, out);
    while (n > 0 && all.size() <= most) {
        all.insert(all.end(), out.begin(), out.begin() + static_cast<std::ptrdiff_t>(n));
        if (n < page) break;
        n = rc::crossings_after(scene, from, to, rc::kAllLayers, all.back(), out);
    }
    return all;
}

void expect_same(const std::vector<rc::Hit>& truth, const std::vector<rc::Hit>& pages, std::size_t page) {
    ASSERT_EQ(truth.size(), pages.size()) << "in pages of " << page;
    for (std::size_t i = 0; i < truth.size(); ++i)
        ASSERT_EQ(std::memcmp(&truth[i], &pages[i], sizeof(rc::Hit)), 0)
            << "hit " << i << " in pages of " << page;
}

// Panes that many instances and primitives share, so that dozens lie at one t, between soup at all distances.
test::TestScene make_stack_of_panes(rc::BuildQuality quality) {
    Random random(31);
    test::TestScene scene(quality);
    scene.add(test::make_soup(random, 300, 1.0f, 1.2f));
    test::Mesh panes;
    for (int i = 0; i < 12; ++i) test::append(panes, test::make_sheet(1.5f, 0.25f * float(i / 4), 2));
    scene.add(panes);
    for (int i = 0; i < 3; ++i) scene.add_instance_of_last(glm::mat4x3(1.0f));
    scene.add_instance_of_last(
        {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0.25f, 0)});
    scene.commit();
    return scene;
}

TEST_P(Crossings, EveryWallComesOnceHoweverFewAreAskedForAtATime) {
    const test::IsaScope scope(GetParam());
    for (const rc::BuildQuality quality : {rc::BuildQuality::Default, rc::BuildQuality::High}) {
        const test::TestScene scene = make_stack_of_panes(quality);
        Random random(7);
        std::size_t ties = 0;
        for (int i = 0; i < 60; ++i) {
            glm::vec3 from = random.in_cube(1.0f), to = random.in_cube(1.0f);
            from.y = 2.0f;
            to.y = -2.0f;
            if (i % 3 == 0) to = {from.x, -2.0f, from.z};                         // along an axis
            if (i % 3 == 1) from = glm::vec3(0, 2, 0), to = glm::vec3(0, -2, 0);  // through shared corners
            const std::vector<rc::Hit> truth =
                scene.all_hits({.origin = from, .direction = to - from, .t_max = 1.0f});
            ASSERT_GT(truth.size(), 40u);
            for (std::size_t k = 1; k < truth.size(); ++k) ties += truth[k].t == truth[k - 1].t;
            for (const std::size_t page : {1u, 2u, 3u, 7u, 64u, 1000u})
                expect_same(truth, page_by_page(scene.scene(), from, to, page, truth.size()), page);
        }
        EXPECT_GT(ties, 1000u) << "panes that lie at one distance are what this is about";
    }
}

TEST_P(Crossings, NothingFollowsAMissOrTheLastWall) {
    const test::IsaScope scope(GetParam());
    const test::TestScene scene = make_stack_of_panes(rc::BuildQuality::Default);
    const glm::vec3 from(0.1f, 2, 0.2f), to(0.1f, -2, 0.2f);
    std::vector<rc::Hit> out(1000);
    EXPECT_EQ(rc::crossings_after(scene.scene(), from, to, rc::kAllLayers, rc::Hit{}, out), 0u);
    const std::size_t n = rc::crossings(scene.scene(), from, to, rc::kAllLayers, out);
    ASSERT_GT(n, 0u);
    const rc::Hit last = out[n - 1];
    EXPECT_EQ(rc::crossings_after(scene.scene(), from, to, rc::kAllLayers, last, out), 0u);
    EXPECT_EQ(rc::crossings_after(scene.scene(), from, to, rc::kAllLayers, out[0], std::span<rc::Hit>()), 0u);
    rc::Hit nowhere = last;
    nowhere.t = std::nanf("");
    EXPECT_EQ(rc::crossings_after(scene.scene(), from, to, rc::kAllLayers, nowhere, out), 0u);
}

INSTANTIATE_TEST_SUITE_P(EveryIsa, Crossings, ::testing::ValuesIn(test::supported_isas()),
                         test::isa_test_name);

}  // namespace

// Guards walk where the navmesh lets them, and a level is only fair when everything in it can be reached.
#include "load/navmesh.h"

#include "base/file.h"
#include "level_bytes.h"
#include "load/level_check.h"
#include "load/walkways.h"

#include <gmock/gmock.h>
#include <unistd.h>

namespace gh {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

world::Level loaded(const test::Bytes& bytes) {
    Result<world::Level> level = load::load_level_from_memory(bytes, "tiny.glb", {});
    EXPECT_TRUE(level) << level.error().sentence;
    return level ? std::move(*level) : world::Level{};
}

TEST(Navmesh, LeadsThroughTheDoorThoughItIsShut) {
    const world::Level level = loaded(test::tiny_level_glb());
    ASSERT_FALSE(level.navmesh.empty());
    const load::Walkways ways(level.navmesh);
    const std::vector<bool> reached = ways.reached_polygons({&level.spawn.position, 1});
    EXPECT_TRUE(ways.is_reached({3.0f, 0.0f, 2.0f}, reached)) << "the same room";
    EXPECT_TRUE(ways.is_reached({-3.0f, 0.0f, -2.0f}, reached)) << "the other room";
    EXPECT_FALSE(ways.is_on_floor({6.0f, 0.0f, 0.0f})) << "outside";
    EXPECT_FALSE(ways.is_on_floor({-2.3f, 4.5f, 0.0f})) << "on the roof";
}

TEST(Navmesh, HasTheSameBytesEachTime) {
    EXPECT_EQ(loaded(test::tiny_level_glb()).navmesh, loaded(test::tiny_level_glb()).navmesh);
}

TEST(Navmesh, IsClosedWhereTheDoorwayIs) {
    // The walls grow until they meet: scale 3.4 m -> 4.6 m.
    const test::Bytes walled = test::with(test::with(test::tiny_level_glb(), "[3.4,3,0.2]", "[4.6,3,0.2]"),
                                          "[3.4,3,0.2]", "[4.6,3,0.2]");
    const load::LevelReport report = load::check_level(loaded(walled));
    EXPECT_THAT(report.errors, Contains(HasSubstr("lens 'lens' at (0.00, 1.20, -2.50) cannot be reached")));
    EXPECT_EQ(report.errors.size(), 1u) << "guard and patrol share the back room, spawn and exit the front";
}

TEST(Navmesh, TellsOfASpawnInTheAirAndAPatrolPointOutside) {
    const test::Bytes flying = test::with(test::tiny_level_glb(), "[0,0,2.2]", "[0,2,2.2]");
    EXPECT_THAT(load::check_level(loaded(flying)).errors,
                Contains(HasSubstr("the spawn at (0.00, 2.00, 2.20) is not on")));
    const test::Bytes outside = test::with(test::tiny_level_glb(), "[1.5,0,-1]", "[9.5,0,-1]");
    EXPECT_THAT(load::check_level(loaded(outside)).errors,
                Contains(HasSubstr("guard 'watchman' cannot walk to patrol point 'p2'")));
}

class NavmeshFile : public ::testing::Test {
  protected:
    void SetUp() override {
        folder = std::filesystem::temp_directory_path() / ("navmesh_test_" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder);
        path = folder / "tiny.glb";
        ASSERT_TRUE(write_file_atomically(path, test::tiny_level_glb()));
        const Result<void> baked = load::bake_navmesh_file(path);
        ASSERT_TRUE(baked) << baked.error().sentence;
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    [[nodiscard]] std::optional<std::vector<std::byte>> read_for(const test::Bytes& level) const {
        const Result<load::Ground> ground = load::collect_ground(loaded(level));
        return ground ? load::read_navmesh_file(load::navmesh_path(path), *ground) : std::nullopt;
    }
    std::filesystem::path folder, path;
};

TEST_F(NavmeshFile, IsUsedByTheLevelItWasBakedFrom) {
    const std::optional<std::vector<std::byte>> kept = read_for(test::tiny_level_glb());
    ASSERT_TRUE(kept);
    const Result<world::Level> level = load::load_level(path);
    ASSERT_TRUE(level) << level.error().sentence;
    EXPECT_EQ(level->navmesh, *kept);
}

TEST_F(NavmeshFile, IsNotUsedByALevelWhoseWallHasMoved) {
    EXPECT_FALSE(read_for(test::with(test::tiny_level_glb(), "[-2.3,1.5,0]", "[-2.2,1.5,0]")));
}

TEST_F(NavmeshFile, IsNotUsedWhenItIsDamagedAnywhere) {
    const Result<std::vector<std::byte>> whole = read_file(load::navmesh_path(path), 1u << 20);
    ASSERT_TRUE(whole);
    for (std::size_t at = 0; at < whole->size(); at += 97) {
        std::vector<std::byte> broken = *whole;
        broken[at] ^= std::byte{0x10};
        ASSERT_TRUE(write_file_atomically(load::navmesh_path(path), broken));
        ASSERT_FALSE(read_for(test::tiny_level_glb())) << "byte " << at;
    }
    std::filesystem::remove(load::navmesh_path(path));
    EXPECT_FALSE(read_for(test::tiny_level_glb()));
}

}  // namespace
}  // namespace gh

// The night watchman himself: what the loader makes of his file bends as his clips say, and he looks out of his eyes.
#include "base/file.h"
#include "load/level_loader.h"
#include "spatial/pose.h"
#include "spatial/skinning.h"
#include "spatial/transforms.h"
#include "world/level.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gh::spatial {
namespace {

// A body to wear is never drawn where it stands, and a level without a triangle is none: the file, with the mesh put
// into its scene once more as a statue.
std::vector<std::byte> with_a_statue(std::span<const std::byte> glb) {
    const auto word = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) value |= std::to_integer<std::uint32_t>(glb[at + i]) << (8 * i);
        return value;
    };
    const std::size_t json_size = word(12);
    nlohmann::json json = nlohmann::json::parse(reinterpret_cast<const char*>(glb.data()) + 20,
                                                reinterpret_cast<const char*>(glb.data()) + 20 + json_size);
    json["scenes"][0]["nodes"].push_back(json["nodes"].size());
    json["nodes"].push_back({{"name", "statue"}, {"mesh", 0}});
    std::string text = json.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');

    std::vector<std::byte> out(glb.begin(), glb.begin() + 20);
    const auto put = [&](std::size_t at, std::size_t value) {
        for (std::size_t i = 0; i < 4; ++i) out[at + i] = static_cast<std::byte>((value >> (8 * i)) & 0xFFu);
    };
    put(8, glb.size() - json_size + text.size());
    put(12, text.size());
    for (const char c : text) out.push_back(static_cast<std::byte>(c));
    out.insert(out.end(), glb.begin() + static_cast<std::ptrdiff_t>(20 + json_size), glb.end());
    return out;
}

class Watchman : public ::testing::Test {
  protected:
    void SetUp() override {
        const auto file = read_file(std::string(GLASSHOUSE_SOURCE_DIR) + "/tests/assets/guard.glb", 1u << 26);
        ASSERT_TRUE(file) << file.error().sentence;
        Result<world::Level> loaded = load::load_level_from_memory(with_a_statue(*file), "guard.glb", {});
        ASSERT_TRUE(loaded) << loaded.error().sentence;
        level_ = std::move(*loaded);
        ASSERT_EQ(level_.models.size(), 1u);
        ASSERT_LT(level_.models[0].mesh, level_.meshes.size());
    }
    [[nodiscard]] const world::Model& model() const { return level_.models[0]; }
    [[nodiscard]] const world::Mesh& mesh() const { return level_.meshes[model().mesh]; }
    [[nodiscard]] std::vector<glm::mat4x3> skin_of(const PoseKey& key) const {
        std::vector<glm::mat4x3> skin(model().joints.size());
        pose_body(model(), key, skin);
        return skin;
    }

    world::Level level_;
};

// Between the keys around a time, in double; two quaternions on the same side first.
glm::dvec4 value_at(const world::Channel& channel, float seconds) {
    std::size_t next = 0;
    while (next < channel.times.size() && channel.times[next] <= seconds) ++next;
    if (next == 0) return glm::dvec4(channel.values.front());
    const glm::dvec4 before(channel.values[next - 1]);
    if (next == channel.times.size() || channel.is_step) return before;
    glm::dvec4 after(channel.values[next]);
    if (channel.path == world::ChannelPath::Rotation && glm::dot(before, after) < 0.0) after = -after;
    const double t0 = static_cast<double>(channel.times[next - 1]),
                 t1 = static_cast<double>(channel.times[next]);
    return glm::mix(before, after, (static_cast<double>(seconds) - t0) / (t1 - t0));
}

// A textbook's worth of it in double: clips sampled, joints one under the other, weights summed.
std::vector<glm::dmat4> joints_in_double(const world::Model& model, const world::Clip& clip, float seconds) {
    std::vector<glm::dmat4> mesh_from_joint;
    for (std::uint32_t j = 0; j < model.joints.size(); ++j) {
        const world::Joint& rest = model.joints[j];
        glm::dvec3 translation(rest.rest_translation), scale(rest.rest_scale);
        glm::dquat rotation(rest.rest_rotation);
        for (const world::Channel& channel : clip.channels) {
            if (channel.joint != j) continue;
            const glm::dvec4 value = value_at(channel, seconds);
            if (channel.path == world::ChannelPath::Translation) translation = glm::dvec3(value);
            if (channel.path == world::ChannelPath::Scale) scale = glm::dvec3(value);
            if (channel.path == world::ChannelPath::Rotation)
                rotation = glm::dquat(value.w, value.x, value.y, value.z);
        }
        glm::dmat4 local = glm::mat4_cast(glm::normalize(rotation));
        for (glm::length_t c = 0; c < 3; ++c) local[c] *= scale[c];
        local[3] = glm::dvec4(translation, 1.0);
        mesh_from_joint.push_back(rest.parent == world::kNoIndex ? local
                                                                 : mesh_from_joint[rest.parent] * local);
    }
    return mesh_from_joint;
}

TEST_F(Watchman, InHisWalkEveryVertexIsWhereDoublePrecisionPutsIt) {
    const std::uint32_t walk = model().clip[static_cast<std::size_t>(world::ClipId::Walk)];
    ASSERT_NE(walk, world::kNoIndex);
    const world::Clip& clip = model().clips[walk];
    PoseKey pose;
    pose.clip = pose.clip_before = world::ClipId::Walk;
    pose.clip_time = 0.2345f;
    world::PosedMesh posed;
    skin_mesh(mesh(), skin_of(pose), posed);

    const std::vector<glm::dmat4> joints = joints_in_double(model(), clip, pose.clip_time);
    double worst = 0.0, moved = 0.0;
    for (std::size_t i = 0; i < mesh().positions.size(); ++i) {
        glm::dvec4 expected(0.0);
        for (glm::length_t k = 0; k < 4; ++k) {
            const std::uint32_t j = mesh().joints[i][k];
            const glm::dvec4 rest(glm::dvec3(mesh().positions[i]), 1.0);
            const glm::dvec3 in_joint = glm::dmat4x3(model().joints[j].joint_from_mesh) * rest;
            expected += joints[j] * glm::dvec4(in_joint, 1.0) * static_cast<double>(mesh().weights[i][k]);
        }
        worst = std::max(worst, glm::distance(glm::dvec3(posed.positions[i]), glm::dvec3(expected)));
        moved =
            std::max(moved, glm::distance(glm::dvec3(posed.positions[i]), glm::dvec3(mesh().positions[i])));
    }
    EXPECT_LT(worst, 1e-5) << "metres; a chain of eight joints in float";
    EXPECT_GT(moved, 0.2) << "he does not walk";
}

TEST_F(Watchman, LooksOutOfHisEyes) {
    ASSERT_NE(model().head_joint, world::kNoIndex);
    for (const float head_yaw : {0.0f, 0.8f}) {
        PoseKey pose;
        pose.head_yaw = head_yaw;
        const std::vector<glm::mat4x3> skin = skin_of(pose);
        world::PosedMesh posed;
        skin_mesh(mesh(), skin, posed);
        glm::vec3 between_eyes(0.0f);
        int corners = 0;
        for (std::size_t t = 0; t < mesh().triangles.size(); ++t) {
            if (level_.materials[mesh().materials[t]].name != "guard_iris") continue;
            for (glm::length_t c = 0; c < 3; ++c, ++corners)
                between_eyes += posed.positions[mesh().triangles[t][c]];
        }
        ASSERT_GT(corners, 0);
        between_eyes = point_through(model().model_from_mesh, between_eyes / static_cast<float>(corners));
        EXPECT_LT(glm::distance(gaze_of(model(), head_yaw, skin).eye, between_eyes), 0.03f)
            << "head yaw " << head_yaw;
    }
}

}  // namespace
}  // namespace gh::spatial

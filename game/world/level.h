// world/level.h - the nouns of a place that never change: geometry, materials, lamps and what the file says of
// doors, mirrors, guards and goals. Filled by load, checked once by level_check; behind that door all indices
// are in range and all numbers finite.
//
// Units     metres, seconds, radians, linear radiance (W/m2/sr per colour), right-handed, +y up.
// Threads   immutable after loading.
#pragma once

#include "world/material.h"

#include "raycore/ray.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace gh::world {

// Capacities: State is a plain struct, so what can change is bounded, and the loader refuses more.
inline constexpr std::size_t kMaxDoors = 64;
inline constexpr std::size_t kMaxMirrors = 32;  // turnable and fixed panes together
inline constexpr std::size_t kMaxSwitches = 64;
inline constexpr std::size_t kMaxLamps = 256;
inline constexpr std::size_t kMaxLenses = 16;
inline constexpr std::size_t kMaxGuards = 16;
inline constexpr std::size_t kMaxStones = 16;
inline constexpr std::size_t kMaxLampGroups = 64;

// ---- what is drawn -------------------------------------------------------------------------------------------

// Triangles of one glTF mesh, all primitives together. Arrays of vertices have equal length; uvs, tangents and
// the skin's arrays may be empty.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;   // unit
    std::vector<glm::vec2> uvs;       // glTF: v runs down
    std::vector<glm::vec4> tangents;  // w: handedness
    std::vector<glm::vec4> colors;    // linear, with alpha: times the material's
    std::vector<glm::uvec3> triangles;
    std::vector<std::uint32_t> materials;  // one a triangle
    std::vector<glm::u16vec4> joints;      // of the Model that wears this mesh
    std::vector<glm::vec4> weights;        // sum to 1
};

// What moves a part: the State's entry `index` of that kind. A part's rest pose is relative to its mover.
enum class Mover : std::uint8_t { None, Door, Mirror, Guard, Stone, Lens };

// One mesh somewhere in the level: instance i of the tick's Scene draws part i (stones and guards included; a
// stone that does not fly, and a lens that is taken, have empty masks).
struct Part {
    std::string name;  // the glTF node's
    std::uint32_t mesh = 0;
    glm::mat4x3 mover_from_part{1.0f};  // world_from_part when mover is None
    rc::LayerMask layers = 0;
    Mover mover = Mover::None;
    std::uint32_t mover_index = 0;
    std::uint32_t lamp_group = kNoIndex;  // emissive parts go dark with their group
    bool is_shell = false;
};

// ---- light ---------------------------------------------------------------------------------------------------

enum class LampShape : std::uint8_t { Point, Spot, Sun, Sphere, Rect };

struct Lamp {
    std::string name;
    LampShape shape = LampShape::Point;
    glm::vec3 position{0.0f};
    glm::vec3 direction{0.0f, -1.0f, 0.0f};  // unit: spot and sun shine along it, a rect on this side only
    glm::vec3 intensity{
        0.0f};            // point, spot: W/sr; sun: W/m2 across the direction; sphere, rect: radiance W/m2/sr
    float radius = 0.0f;  // sphere; 0 otherwise
    glm::vec3 half_u{0.0f};  // rect: half edges, orthogonal
    glm::vec3 half_v{0.0f};
    float cos_inner = 1.0f;  // spot: full light within, none beyond outer
    float cos_outer = 0.0f;
    float range =
        rc::kInfinity;  // metres beyond which it gives less than 1e-3 W/m2 (or the file's own range)
    std::uint32_t group = kNoIndex;
    std::uint32_t part = kNoIndex;  // the visible bulb, which must not shadow its own lamp
    bool starts_on = true;
};

// ---- what can be done ----------------------------------------------------------------------------------------

struct Door {
    std::string name, title;
    glm::vec3 hinge{0.0f};                              // world
    glm::quat world_from_rest{1.0f, 0.0f, 0.0f, 0.0f};  // rotation of the closed door
    glm::vec3 axis{0.0f, 1.0f, 0.0f};                   // unit, in the door's own frame
    float open_angle = 1.65f;                           // radians, signed
    float open_ticks = 48.0f;
    glm::vec3 handle{0.0f};  // world, closed: where a hand (and a prompt) goes
};

// A flat pane that guards see in. Fixed when turn_step == 0, unless it is the hand mirror: that one lies at its rest
// pose until it is picked up, and is held upright with its own +y up (spatial/hand_mirror.h).
struct Mirror {
    std::string name, title;
    glm::vec3 pivot{0.0f};
    glm::quat world_from_rest{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec3 axis{0.0f, 1.0f, 0.0f};
    float turn_step = 0.0f;       // radians a use
    glm::vec3 pane_centre{0.0f};  // in the mirror's frame (origin pivot, axes world_from_rest)
    glm::vec3 pane_half_u{0.0f};  // cross(half_u, half_v) points out of the reflecting side
    glm::vec3 pane_half_v{0.0f};
    glm::vec3 reflectance{0.9f};
    std::uint32_t pane_part = kNoIndex;
};

struct Switch {
    std::string name, title;
    glm::vec3 position{0.0f};
    std::uint32_t group = kNoIndex;
};

struct Lens {
    std::string name, title;
    glm::mat4x3 world_from_lens{1.0f};
    glm::vec3 centre{0.0f};
};

struct Aabb {
    glm::vec3 min{0.0f};
    glm::vec3 max{0.0f};
};

struct Room {
    std::string name, title;
    Aabb box;
};

struct PatrolPoint {
    std::string name;
    glm::vec3 position{0.0f};  // feet
    float yaw = 0.0f;          // 0 faces -z, positive turns left
    float wait_ticks = 120.0f;
    bool looks_round = false;
};

struct Guard {
    std::string name, title;
    glm::vec3 position{0.0f};  // feet
    float yaw = 0.0f;
    std::vector<PatrolPoint> patrol;
    std::uint32_t model = kNoIndex;  // of Level::models
};

struct Spawn {
    glm::vec3 position{0.0f};  // feet
    float yaw = 0.0f;
};

struct Viewpoint {  // a glTF camera
    std::string name;
    glm::vec3 position{0.0f};
    float yaw = 0.0f, pitch = 0.0f;
    float roll = 0.0f;
    float fov_y = 1.0f;
};

// ---- bodies that bend ----------------------------------------------------------------------------------------

struct Joint {
    std::string name;
    std::uint32_t parent = kNoIndex;    // always lower than the joint's own index
    glm::mat4x3 joint_from_mesh{1.0f};  // inverse bind
    glm::vec3 rest_translation{0.0f};
    glm::quat rest_rotation{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec3 rest_scale{1.0f};
};

enum class ChannelPath : std::uint8_t { Translation, Rotation, Scale };

struct Channel {
    std::uint32_t joint = 0;
    ChannelPath path = ChannelPath::Rotation;
    bool is_step = false;           // otherwise linear; cubic splines are resampled at load
    std::vector<float> times;       // seconds, rising
    std::vector<glm::vec4> values;  // xyz, or quaternion as xyzw
};

struct Clip {
    std::string name;
    float duration = 0.0f;  // seconds
    std::vector<Channel> channels;
};

// The clips a guard needs; a model without one stands.
enum class ClipId : std::uint8_t { Stand, Walk, Look, Run, Reach };
inline constexpr std::size_t kClipCount = 5;

struct Model {
    std::string name;
    std::uint32_t mesh = kNoIndex;
    glm::mat4x3 model_from_mesh{1.0f};  // of the armature: feet at the origin, facing -z
    std::vector<Joint> joints;
    std::vector<Clip> clips;
    std::uint32_t clip[kClipCount] = {kNoIndex, kNoIndex, kNoIndex, kNoIndex, kNoIndex};
    std::uint32_t head_joint = kNoIndex;  // by name: the joint called "head", if any
};

// ---- the whole -----------------------------------------------------------------------------------------------

struct Level {
    std::string name;
    std::uint64_t file_hash = 0;     // of the bytes it came from
    std::uint64_t navmesh_hash = 0;  // of `navmesh`

    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Part> parts;
    std::vector<Model> models;

    std::vector<Lamp> lamps;
    std::vector<std::string> lamp_groups;
    std::vector<Door> doors;
    std::vector<Mirror> mirrors;
    std::uint32_t hand_mirror = kNoIndex;  // of `mirrors`: the one that can be picked up, if there is one
    std::vector<Switch> switches;
    std::vector<Lens> lenses;
    std::vector<Room> rooms;
    std::vector<Guard> guards;
    std::vector<Aabb> exits;
    std::vector<Viewpoint> viewpoints;
    Spawn spawn;

    std::uint32_t stone_part_begin = 0;  // kMaxStones parts from here are the stones, in order
    float stone_radius = 0.035f;
    Aabb bounds;
    std::vector<std::string> remarks;  // what was odd in the file: load/level_check says it as warnings
    glm::dvec3 origin{0.0};  // of the world, in the file it came from: not 0 where that stands far from its own
    std::vector<std::byte> navmesh;  // Detour's tile; empty: guards stand still
};

}  // namespace gh::world

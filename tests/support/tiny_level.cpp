#include "support/tiny_level.h"

#include "support/glb_writer.h"

#include <array>
#include <cstdint>
#include <string>

namespace gh::test {
namespace {

using Floats = std::vector<float>;
using Indices = std::vector<std::uint16_t>;

std::string id(int value) {
    return std::to_string(value);
}

// A unit cube around the origin, each side with its own corners.
struct Cube {
    Floats positions, normals, uvs;
    Indices indices;

    explicit Cube(bool is_inside_out) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const float sign : {-1.0f, 1.0f}) add_side(axis, sign, is_inside_out);
        }
    }

    void add_side(int axis, float sign, bool is_inside_out) {
        const auto first = static_cast<std::uint16_t>(positions.size() / 3);
        for (const std::array<float, 2> corner :
             {std::array{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
            std::array<float, 3> p{}, n{};
            p[static_cast<std::size_t>(axis)] = 0.5f * sign;
            p[static_cast<std::size_t>((axis + 1) % 3)] =
                0.5f * corner[0] * sign;  // so that winding follows the side
            p[static_cast<std::size_t>((axis + 2) % 3)] = 0.5f * corner[1];
            n[static_cast<std::size_t>(axis)] = is_inside_out ? -sign : sign;
            positions.insert(positions.end(), p.begin(), p.end());
            normals.insert(normals.end(), n.begin(), n.end());
            uvs.insert(uvs.end(), {0.5f + 0.5f * corner[0], 0.5f + 0.5f * corner[1]});
        }
        const auto at = [first](int i) { return static_cast<std::uint16_t>(first + i); };
        if (is_inside_out) {
            indices.insert(indices.end(), {at(0), at(2), at(1), at(0), at(3), at(2)});
        } else {
            indices.insert(indices.end(), {at(0), at(1), at(2), at(0), at(2), at(3)});
        }
    }
};

std::string primitive(const std::string& attributes, int indices, int material, int mode = 4) {
    return R"({"primitives":[{"attributes":{)" + attributes + R"(},"indices":)" + id(indices) +
           R"(,"material":)" + id(material) + R"(,"mode":)" + id(mode) + "}]}";
}

int add_cube(GlbWriter& glb, const Cube& cube, int material) {
    const std::string attributes = R"("POSITION":)" + id(glb.add_floats(cube.positions, "VEC3")) +
                                   R"(,"NORMAL":)" + id(glb.add_floats(cube.normals, "VEC3")) +
                                   R"(,"TEXCOORD_0":)" + id(glb.add_floats(cube.uvs, "VEC2"));
    return glb.add("meshes", primitive(attributes, glb.add_indices(cube.indices), material));
}

// Half a metre across, no normals: the loader has to make them.
int add_octahedron(GlbWriter& glb, int material) {
    const Floats positions{1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
    const Indices indices{0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    return glb.add("meshes", primitive(R"("POSITION":)" + id(glb.add_floats(positions, "VEC3")),
                                       glb.add_indices(indices), material));
}

// 1 x 1.6 m facing +z, as a triangle strip.
int add_pane(GlbWriter& glb, int material) {
    const Floats positions{-0.5f, -0.8f, 0, 0.5f, -0.8f, 0, -0.5f, 0.8f, 0, 0.5f, 0.8f, 0};
    const Floats normals{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
    return glb.add("meshes", primitive(R"("POSITION":)" + id(glb.add_floats(positions, "VEC3")) +
                                           R"(,"NORMAL":)" + id(glb.add_floats(normals, "VEC3")),
                                       glb.add_indices({0, 1, 2, 3}), material, 5));
}

// A box from the ground to 1.8 m; the upper corners hang on joint 1, the lower on joint 0.
int add_body(GlbWriter& glb, int material) {
    Cube cube(false);
    Floats weights;
    std::vector<std::uint8_t> joints;
    for (std::size_t i = 0; i < cube.positions.size(); i += 3) {
        const bool is_upper = cube.positions[i + 1] > 0.0f;
        cube.positions[i] *= 0.5f;
        cube.positions[i + 1] = is_upper ? 1.8f : 0.0f;
        cube.positions[i + 2] *= 0.3f;
        joints.insert(joints.end(), {static_cast<std::uint8_t>(is_upper ? 1 : 0), 0, 0, 0});
        weights.insert(weights.end(), {1.0f, 0.0f, 0.0f, 0.0f});
    }
    const std::string attributes = R"("POSITION":)" + id(glb.add_floats(cube.positions, "VEC3")) +
                                   R"(,"NORMAL":)" + id(glb.add_floats(cube.normals, "VEC3")) +
                                   R"(,"JOINTS_0":)" + id(glb.add_joints(joints)) + R"(,"WEIGHTS_0":)" +
                                   id(glb.add_floats(weights, "VEC4"));
    return glb.add("meshes", primitive(attributes, glb.add_indices(cube.indices), material));
}

void add_clip(GlbWriter& glb, const std::string& name, const std::string& interpolation,
              const std::string& target, int times, int values) {
    glb.add("animations", R"({"name":")" + name + R"(","samplers":[{"input":)" + id(times) + R"(,"output":)" +
                              id(values) + R"(,"interpolation":")" + interpolation +
                              R"("}],"channels":[{"sampler":0,"target":{)" + target + "}}]}");
}

struct Meshes {
    int shell, cube, glass, bulb, lens, pane, body;
};

Meshes add_meshes(GlbWriter& glb) {
    const int image = glb.add_image(4, 200, 180, 150);
    glb.add("textures", R"({"source":)" + id(image) + "}");
    const int plaster =
        glb.add("materials", R"({"name":"plaster","extras":{"surface":"marble"},"pbrMetallicRoughness":)"
                             R"({"metallicFactor":0,"baseColorTexture":{"index":0}}})");
    const int oak = glb.add("materials", R"({"name":"oak","extras":{"surface":"oak"},"pbrMetallicRoughness":)"
                                         R"({"metallicFactor":0,"baseColorFactor":[0.5,0.25,0.125,1]}})");
    const int glass = glb.add("materials", R"({"name":"glass","extensions":{"KHR_materials_transmission":)"
                                           R"({"transmissionFactor":1},"KHR_materials_ior":{"ior":1.52}}})");
    const int bulb = glb.add("materials", R"({"name":"bulb","emissiveFactor":[1,0.5,0.25],"extensions":)"
                                          R"({"KHR_materials_emissive_strength":{"emissiveStrength":100}}})");
    const int mirror = glb.add("materials", R"({"name":"mirror","pbrMetallicRoughness":{"metallicFactor":1,)"
                                            R"("roughnessFactor":0,"baseColorFactor":[0.9,0.9,0.9,1]}})");
    Meshes meshes{};
    meshes.shell = add_cube(glb, Cube(true), plaster);
    meshes.cube = add_cube(glb, Cube(false), oak);
    meshes.glass = add_cube(glb, Cube(false), glass);
    meshes.bulb = add_octahedron(glb, bulb);
    meshes.lens = add_octahedron(glb, glass);
    meshes.pane = add_pane(glb, mirror);
    meshes.body = add_body(glb, oak);
    return meshes;
}

// A node with what `json` says beside its name.
int add_node(GlbWriter& glb, const std::string& name, const std::string& json) {
    return glb.add("nodes", R"({"name":")" + name + "\"," + json + "}");
}

std::vector<int> add_rooms(GlbWriter& glb, const Meshes& meshes) {
    const std::string cube = R"("mesh":)" + id(meshes.cube);
    std::vector<int> roots;
    roots.push_back(add_node(glb, "shell",
                             R"("mesh":)" + id(meshes.shell) +
                                 R"(,"translation":[0,1.5,0],"scale":[8,3,6],"extras":{"kind":"shell"})"));
    roots.push_back(add_node(glb, "wall_left", cube + R"(,"translation":[-2.3,1.5,0],"scale":[3.4,3,0.2])"));
    roots.push_back(add_node(glb, "wall_right", cube + R"(,"translation":[2.3,1.5,0],"scale":[3.4,3,0.2])"));
    const int leaf = add_node(glb, "leaf", cube + R"(,"translation":[0.6,1.05,0],"scale":[1.2,2.1,0.06])");
    roots.push_back(add_node(glb, "door",
                             R"("translation":[-0.6,0,0],"children":[)" + id(leaf) +
                                 R"(],"extras":{"kind":"door","open_angle_deg":90,"title":"Inner door"})"));
    roots.push_back(
        add_node(glb, "front",
                 R"("translation":[0,1.5,1.5],"extras":{"kind":"room","size":[8,3,3],"title":"Front"})"));
    roots.push_back(add_node(
        glb, "back", R"("translation":[0,1.5,-1.5],"extras":{"kind":"room","size":[8,3,3],"title":"Back"})"));
    roots.push_back(add_node(glb, "spawn", R"("translation":[0,0,2.2],"extras":{"kind":"spawn"})"));
    roots.push_back(
        add_node(glb, "exit", R"("translation":[-3,1,2],"extras":{"kind":"exit","size":[1,2,1]})"));
    return roots;
}

std::vector<int> add_things(GlbWriter& glb, const Meshes& meshes) {
    std::vector<int> roots;
    roots.push_back(add_node(glb, "bulb",
                             R"("mesh":)" + id(meshes.bulb) +
                                 R"(,"translation":[0,2.6,1.5],"scale":[0.1,0.1,0.1],)"
                                 R"("extras":{"kind":"lamp","shape":"sphere","group":"main"})"));
    roots.push_back(add_node(glb, "switch",
                             R"("mesh":)" + id(meshes.cube) +
                                 R"(,"translation":[-3.95,1.2,1.5],"scale":[0.05,0.1,0.1],)"
                                 R"("extras":{"kind":"switch","group":"main"})"));
    roots.push_back(add_node(glb, "mirror",
                             R"("mesh":)" + id(meshes.pane) +  // turned to face -x
                                 R"(,"translation":[3.5,1.3,1.5],"rotation":[0,-0.7071068,0,0.7071068],)"
                                 R"("extras":{"kind":"mirror","turn_step_deg":22.5})"));
    roots.push_back(add_node(
        glb, "pane", R"("mesh":)" + id(meshes.glass) + R"(,"translation":[3,1,-1.5],"scale":[1,2,0.02])"));
    roots.push_back(add_node(glb, "lens",
                             R"("mesh":)" + id(meshes.lens) +
                                 R"(,"translation":[0,1.2,-2.5],"scale":[0.08,0.08,0.08],)"
                                 R"("extras":{"kind":"lens","title":"A lens"})"));
    glb.add("cameras", R"({"type":"perspective","perspective":{"yfov":1,"znear":0.1}})");
    roots.push_back(add_node(glb, "door_view", R"("translation":[0,1.6,2.8],"camera":0)"));
    roots.push_back(
        add_node(glb, "ceiling_light",
                 R"("translation":[0,2.8,-1.5],"extensions":{"KHR_lights_punctual":{"light":0}})"));
    return roots;
}

std::vector<int> add_guard(GlbWriter& glb, const Meshes& meshes) {
    const int head = add_node(glb, "head", R"("translation":[0,0.7,0])");
    const int hips = add_node(glb, "hips", R"("translation":[0,0.9,0],"children":[)" + id(head) + "]");
    const int binds = glb.add_floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -0.9f, 0, 1,  //
                                      1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1.6f, 0, 1},
                                     "MAT4");
    glb.add("skins",
            R"({"inverseBindMatrices":)" + id(binds) + R"(,"joints":[)" + id(hips) + "," + id(head) + "]}");
    const int body = add_node(glb, "body", R"("mesh":)" + id(meshes.body) + R"(,"skin":0)");
    std::vector<int> roots;
    roots.push_back(add_node(glb, "guard",
                             R"("translation":[20,0,0],"children":[)" + id(hips) + "," + id(body) +
                                 R"(],"extras":{"kind":"guard_model"})"));
    roots.push_back(add_node(glb, "watchman",
                             R"("translation":[-3,0,-2.2],"extras":{"kind":"guard","patrol":"p1, p2"})"));
    roots.push_back(add_node(glb, "p1", R"("translation":[-3,0,-1],"extras":{"kind":"patrol","wait_s":1})"));
    roots.push_back(
        add_node(glb, "p2", R"("translation":[1.5,0,-1],"extras":{"kind":"patrol","look":true})"));

    const int second = glb.add_floats({0, 1}, "SCALAR");
    const int quarter_turn = glb.add_floats({0, 0, 0, 1, 0, 0.70710678f, 0, 0.70710678f}, "VEC4");
    add_clip(glb, "stand", "LINEAR", R"("node":)" + id(hips) + R"(,"path":"rotation")", second, quarter_turn);
    const int bob = glb.add_floats({0, 0, 0, 0, 0.9f, 0, 0, 0, 0, 0, 0, 0, 0, 1.0f, 0, 0, 0, 0}, "VEC3");
    add_clip(glb, "walk", "CUBICSPLINE", R"("node":)" + id(hips) + R"(,"path":"translation")", second, bob);
    add_clip(glb, "look", "STEP", R"("node":)" + id(head) + R"(,"path":"rotation")", second, quarter_turn);
    return roots;
}

}  // namespace

std::vector<std::byte> tiny_level_glb() {
    GlbWriter glb;
    const Meshes meshes = add_meshes(glb);
    std::string roots;
    for (const std::vector<int>& some :
         {add_rooms(glb, meshes), add_things(glb, meshes), add_guard(glb, meshes)}) {
        for (const int root : some) roots += (roots.empty() ? "" : ",") + id(root);
    }
    return glb.finish(R"("scene":0,"scenes":[{"nodes":[)" + roots +
                      R"(]}],"extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":)"
                      R"({"lights":[{"type":"point","intensity":6830,"color":[1,1,0.5]}]}})");
}

}  // namespace gh::test

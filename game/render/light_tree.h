// render/light_tree.h - picks one of many lights, near and bright ones that face us more often (Conty and Kulla 2018).
//
// A light is picked with a probability that is known, and that is above 0 wherever it may give light: estimates stay
// unbiased whatever the tree looks like.
//
// Cost      built in O(n log n) each frame in which a light has changed, 1.0 us a light (a thousand) to 1.3 us (a hundred thousand); picking one of a
//           thousand .4 us, of a hundred thousand 1.3 us, most of it waiting for memory.
// Threads   immutable once built.
// Same bits built and walked in index order; additions, multiplications, square roots.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gh::render {

// What a light, or a group of them, can do: where it is, and the directions it shines into.
struct LightBounds {
    glm::vec3 min{0.0f}, max{0.0f};
    glm::vec3 axis{0.0f, 0.0f, 1.0f};  // unit
    float cos_normals = -1.0f;  // of the cone around it that holds all surface normals; -1: every direction
    float cos_emission = 0.0f;  // of the angle around a normal within which light leaves
    float power = 0.0f;
};

// Who asks. A normal of 0 stands for a surface that takes light from both sides.
struct LightQuery {
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};
};

class LightTree {
  public:
    struct Pick {
        std::uint32_t light = 0;
        float probability = 0.0f;  // 0: nothing can give light here
    };

    LightTree() = default;
    // Lights of power 0 are never picked.
    explicit LightTree(std::span<const LightBounds> lights);

    [[nodiscard]] bool empty() const { return nodes_.empty(); }
    [[nodiscard]] Pick pick(const LightQuery& query, float u) const;
    // Of picking this very light.
    [[nodiscard]] float probability(const LightQuery& query, std::uint32_t light) const;
    // About how much light all of them give there, W/m2.
    [[nodiscard]] float importance(const LightQuery& query) const;

  private:
    struct Node {
        glm::vec3 centre{0.0f};
        float radius2 = 0.0f;  // of the ball around the box
        glm::vec3 axis{0.0f};
        float power = 0.0f;
        float cos_normals = -1.0f, sin_normals = 0.0f;
        float cos_emission = 0.0f;
        std::uint32_t next = 0;  // inner: the second child (the first follows); leaf: the light
        bool is_leaf = false;
    };
    struct Item;
    struct Plane;
    struct Turns {  // down to a node
        std::uint64_t trail = 0;
        int depth = 0;
    };

    [[nodiscard]] static float importance(const Node& node, const LightQuery& query);
    [[nodiscard]] static Node node_of(const LightBounds& bounds);
    [[nodiscard]] static Plane cheapest_plane(std::span<const Item> items);
    [[nodiscard]] static std::size_t part(std::span<Item> items, std::span<Item> scratch, int depth);
    LightBounds build(std::span<Item> items, std::span<Item> scratch, const Turns& turns);

    std::vector<Node> nodes_;
    std::vector<std::uint64_t> trails_;  // the turns down to each light, first turn in the lowest bit
};

// A tree and what it was made from, so that frames in which no lamp changes share one.
struct KeptLightTree {
    std::vector<LightBounds> lights;
    LightTree tree;
};
// `kept` if it was made from these very lights, else a new one. `kept` may be null.
[[nodiscard]] std::shared_ptr<const KeptLightTree> light_tree_of(std::vector<LightBounds> lights,
                                                                 std::shared_ptr<const KeptLightTree> kept);

}  // namespace gh::render

// How the tree is made: split by what its groups cost to be picked from.
#include "base/det_math.h"
#include "render/light_angles.h"
#include "render/light_tree.h"

#include "raycore/ray.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace gh::render {

namespace {

constexpr int kBins = 8;
constexpr int kDeepest = 62;  // turns fit into a trail

// The narrowest cone around both cones of normals.
void merge_cones(LightBounds& a, const LightBounds& b) {
    if (a.cos_normals <= -1.0f || b.cos_normals <= -1.0f) {
        a.cos_normals = -1.0f;
        return;
    }
    const float between = det::acos(std::clamp(glm::dot(a.axis, b.axis), -1.0f, 1.0f));
    const float half_a = det::acos(std::min(a.cos_normals, 1.0f)),
                half_b = det::acos(std::min(b.cos_normals, 1.0f));
    if (std::min(between + half_b, kPi) <= half_a) return;
    if (std::min(between + half_a, kPi) <= half_b) {
        a.axis = b.axis;
        a.cos_normals = b.cos_normals;
        return;
    }
    const float half = 0.5f * (half_a + half_b + between);
    const glm::vec3 across = b.axis - a.axis * glm::dot(a.axis, b.axis);
    const float length = glm::length(across);
    if (half >= kPi || !(length > 0.0f)) {
        a.cos_normals = -1.0f;
        return;
    }
    const auto [sine, cosine] = det::sin_cos(half - half_a);
    a.axis = glm::normalize(a.axis * cosine + across * (sine / length));
    a.cos_normals = det::cos(half);
}

LightBounds merged(const LightBounds& a, const LightBounds& b) {
    if (!(a.power > 0.0f)) return b;
    if (!(b.power > 0.0f)) return a;
    LightBounds both = a;
    both.min = glm::min(a.min, b.min);
    both.max = glm::max(a.max, b.max);
    both.cos_emission = std::min(a.cos_emission, b.cos_emission);
    both.power = a.power + b.power;
    merge_cones(both, b);
    return both;
}

// What a group of lights costs to be picked from, without any trigonometry: planes are compared by it, n log n times.
// Which of them is taken changes no probability's truth, so that it need not be exact; what nodes hold is.
class Group {
  public:
    void add(const LightBounds& light) {
        low_ = glm::min(low_, light.min);
        high_ = glm::max(high_, light.max);
        // The mean of the directions in a cone is its axis times (1 + cos) / 2.
        axis_ += light.axis * (light.power * 0.5f * (1.0f + light.cos_normals));
        cos_emission_ = std::min(cos_emission_, light.cos_emission);
        power_ += light.power;
    }
    void add(const Group& other) {
        low_ = glm::min(low_, other.low_);
        high_ = glm::max(high_, other.high_);
        axis_ += other.axis_;
        cos_emission_ = std::min(cos_emission_, other.cos_emission_);
        power_ += other.power_;
    }
    [[nodiscard]] bool is_dark() const { return !(power_ > 0.0f); }
    [[nodiscard]] float cost() const {
        const glm::vec3 size = high_ - low_;
        // Lamps in a row have no area: their length counts a little.
        const float area = size.x * size.y + size.y * size.z + size.z * size.x;
        return power_ * spread() * (area + 1e-3f * glm::dot(size, size));
    }

  private:
    // How much of the sphere it shines into: the square of 1 - cos (normals + emission), which is within a fifth of what
    // Conty and Kulla integrate.
    [[nodiscard]] float spread() const {
        const float cos_normals = std::clamp(2.0f * glm::length(axis_) / power_ - 1.0f, -1.0f, 1.0f);
        if (!(cos_normals > -cos_emission_)) return 4.0f;  // both angles together are more than half a turn
        const float both = cos_normals * cos_emission_ - sine_of(cos_normals) * sine_of(cos_emission_);
        return (1.0f - both) * (1.0f - both);
    }

    glm::vec3 low_{rc::kInfinity}, high_{-rc::kInfinity};
    glm::vec3 axis_{0.0f};
    float cos_emission_ = 1.0f;
    float power_ = 0.0f;
};

}  // namespace

struct LightTree::Item {
    LightBounds bounds;
    glm::vec3 centre{0.0f};
    std::uint32_t light = 0;
};

// Items in bins across the widest side that is worth it, and the cheapest plane between two bins.
struct LightTree::Plane {
    std::size_t axis = 0;
    float low = 0.0f, per_bin = 0.0f;
    int last = -1;  // bin before it; -1: no plane parts the items

    [[nodiscard]] int bin(const Item& item) const {
        return std::min(kBins - 1, static_cast<int>((item.centre[axis] - low) * per_bin));
    }
    [[nodiscard]] bool is_before(const Item& item) const { return bin(item) <= last; }
};

LightTree::LightTree(std::span<const LightBounds> lights) {
    std::vector<Item> items;
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
        if (lights[i].power > 0.0f) items.push_back({lights[i], 0.5f * (lights[i].min + lights[i].max), i});
    }
    trails_.assign(lights.size(), 0);
    if (items.empty()) return;
    nodes_.reserve(2 * items.size());
    std::vector<Item> scratch(items.size());
    (void)build(items, scratch, {});
}

std::shared_ptr<const KeptLightTree> light_tree_of(std::vector<LightBounds> lights,
                                                   std::shared_ptr<const KeptLightTree> kept) {
    static_assert(sizeof(LightBounds) == 12 * sizeof(float), "compared byte by byte");
    const auto bytes = lights.size() * sizeof(LightBounds);
    if (kept != nullptr && kept->lights.size() == lights.size() &&
        (bytes == 0 || std::memcmp(kept->lights.data(), lights.data(), bytes) == 0))
        return kept;
    const LightTree tree(lights);
    return std::make_shared<const KeptLightTree>(KeptLightTree{std::move(lights), tree});
}

LightTree::Plane LightTree::cheapest_plane(std::span<const Item> items) {
    glm::vec3 low = items[0].centre, high = items[0].centre;
    for (const Item& item : items) {
        low = glm::min(low, item.centre);
        high = glm::max(high, item.centre);
    }
    const glm::vec3 size = high - low;
    const float widest = std::max({size.x, size.y, size.z});
    Plane best;
    float least = rc::kInfinity;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Plane plane{.axis = axis, .low = low[axis], .per_bin = kBins / size[axis]};
        if (!(size[axis] > 0.0f) || !(plane.per_bin < rc::kInfinity)) continue;
        std::array<Group, kBins> bins{};
        for (const Item& item : items) bins[static_cast<std::size_t>(plane.bin(item))].add(item.bounds);
        std::array<Group, kBins> behind = bins;
        for (std::size_t b = kBins - 1; b-- > 0;) behind[b].add(behind[b + 1]);
        Group before;
        for (std::size_t b = 0; b + 1 < kBins; ++b) {
            before.add(bins[b]);
            if (before.is_dark() || behind[b + 1].is_dark()) continue;
            const float price = (before.cost() + behind[b + 1].cost()) * (widest / size[axis]);
            if (!(price < least)) continue;
            least = price;
            best = plane;
            best.last = static_cast<int>(b);
        }
    }
    return best;
}

// Half and half where no plane parts them or the tree gets too deep. `scratch` is as long as `items`.
std::size_t LightTree::part(std::span<Item> items, std::span<Item> scratch, int depth) {
    if (depth >= kDeepest / 2) return items.size() / 2;
    const Plane plane = cheapest_plane(items);
    if (plane.last < 0) return items.size() / 2;
    std::size_t kept = 0, moved = 0;
    for (const Item& item : items) {
        if (plane.is_before(item)) {
            items[kept++] = item;
        } else {
            scratch[moved++] = item;
        }
    }
    std::copy(scratch.begin(), scratch.begin() + static_cast<std::ptrdiff_t>(moved),
              items.begin() + static_cast<std::ptrdiff_t>(kept));
    return kept;
}

// Writes the nodes of these items, children after their parent, and returns what they can do together.
LightBounds LightTree::build(std::span<Item> items, std::span<Item> scratch, const Turns& turns) {
    const std::size_t id = nodes_.size();
    nodes_.emplace_back();
    if (items.size() == 1) {
        nodes_[id] = node_of(items[0].bounds);
        nodes_[id].is_leaf = true;
        nodes_[id].next = items[0].light;
        trails_[items[0].light] = turns.trail;
        return items[0].bounds;
    }
    const std::size_t first = part(items, scratch, turns.depth);
    const LightBounds near =
        build(items.subspan(0, first), scratch.subspan(0, first), {turns.trail, turns.depth + 1});
    const auto second = static_cast<std::uint32_t>(nodes_.size());
    const LightBounds far = build(items.subspan(first), scratch.subspan(first),
                                  {turns.trail | (std::uint64_t{1} << turns.depth), turns.depth + 1});
    const LightBounds both = merged(near, far);
    nodes_[id] = node_of(both);
    nodes_[id].next = second;
    return both;
}

LightTree::Node LightTree::node_of(const LightBounds& bounds) {
    Node node;
    node.centre = 0.5f * (bounds.min + bounds.max);
    const glm::vec3 half = 0.5f * (bounds.max - bounds.min);
    node.radius2 = glm::dot(half, half);
    node.axis = bounds.axis;
    node.power = bounds.power;
    node.cos_normals = bounds.cos_normals;
    node.sin_normals = sine_of(bounds.cos_normals);
    node.cos_emission = bounds.cos_emission;
    return node;
}

}  // namespace gh::render

#include "fuzzed_world.h"

#include <glm/common.hpp>

#include <bit>
#include <cmath>

namespace fuzz {

namespace {

class Reader {
  public:
    explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    std::uint32_t byte() { return at_ < bytes_.size() ? bytes_[at_++] : 0u; }
    std::uint32_t below(std::uint32_t n) { return byte() % n; }
    std::uint32_t word() {
        std::uint32_t value = 0;
        for (int i = 0; i < 4; ++i) value = value << 8 | byte();
        return value;
    }

    // A small whole number, a half, a float a step or two from one, or any bits.
    float number() {
        const std::uint32_t kind = byte();
        const float small = 0.5f * static_cast<float>(static_cast<int>(kind & 15) - 8);
        switch (kind >> 4) {
            case 14:
                return std::bit_cast<float>(word());
            case 13:
                return std::nextafter(small, 100.0f);
            case 12:
                return small * std::ldexp(1.0f, static_cast<int>(byte()) - 128);
            case 11:
                return std::bit_cast<float>(std::bit_cast<std::uint32_t>(small) ^ (1u << 31));
            default:
                return kind >> 4 < 4 ? small : small + static_cast<float>(byte()) / 256.0f;
        }
    }
    glm::vec3 triple() {
        const float x = number(), y = number();
        return {x, y, number()};
    }

  private:
    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

float brought_down(float x) {
    return std::abs(x) > 1e15f && std::abs(x) < 1e19f ? x * 1e-12f : x;
}

glm::vec3 a_place(Reader& in) {
    const glm::vec3 p = in.triple();
    return {brought_down(p.x), brought_down(p.y), brought_down(p.z)};
}

test::Mesh a_mesh(Reader& in) {
    test::Mesh mesh;
    const std::uint32_t vertices = 3 + in.below(24), triangles = in.below(40);
    for (std::uint32_t i = 0; i < vertices; ++i) mesh.positions.push_back(a_place(in));
    for (std::uint32_t i = 0; i < triangles; ++i) {
        glm::uvec3 t(in.below(vertices), in.below(vertices), in.below(vertices));
        const std::uint32_t odd = in.byte();
        if (odd == 1) t.y = t.x;
        if (odd == 2) t.z = in.word();
        mesh.triangles.push_back(t);
    }
    return mesh;
}

// Axes turned, mirrored, stretched up to four times and sheared, or flattened to nothing.
glm::mat4x3 a_transform(Reader& in) {
    glm::mat4x3 m(1.0f);
    const std::uint32_t kind = in.byte();
    const auto stretch = [&] {
        return (in.below(2) ? 1.0f : -1.0f) * 0.5f * static_cast<float>(1 + in.below(8));
    };
    if (kind % 4 != 0) {
        const std::uint32_t turn = in.below(3);
        m = glm::mat4x3(0.0f);
        for (std::size_t c = 0; c < 3; ++c) m[c][(c + turn) % 3] = stretch();
    }
    if (kind % 8 == 5) m[1][0] += 0.25f * static_cast<float>(in.below(9));
    if (kind % 16 == 7) m[2] = glm::vec3(0.0f);
    if (kind % 16 == 15) m[1] = m[0];
    const glm::vec3 offset = in.triple();
    m[3] = glm::vec3(0.0f);
    for (std::size_t a = 0; a < 3; ++a)
        if (std::abs(offset[a]) < 1e9f) m[3][a] = offset[a];
    return m;
}

glm::vec3 a_corner(Reader& in, const World& world) {
    const Placed& placed = world.placed[in.below(static_cast<std::uint32_t>(world.placed.size()))];
    const std::vector<glm::vec3>& p = world.meshes[placed.mesh].positions;
    const glm::vec3 corner = p[in.below(static_cast<std::uint32_t>(p.size()))];
    const glm::mat4x3& m = placed.world_from_mesh;
    return ((m[0] * corner.x + m[1] * corner.y) + m[2] * corner.z) + m[3];
}

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_allowed(const rc::Ray& ray) {
#ifdef RC_CONTRACTS
    return is_finite(ray.origin) && is_finite(ray.direction) && ray.direction != glm::vec3(0.0f) &&
           ray.t_min <= ray.t_max;
#else
    (void)ray;
    return true;
#endif
}

rc::Ray a_ray(Reader& in, const World& world) {
    const std::uint32_t kind = in.byte();
    rc::Ray ray{.origin = kind % 5 == 0 ? a_corner(in, world) : in.triple()};
    switch (kind / 5 % 4) {
        case 0:
            ray.direction = in.triple();
            break;
        case 1: {
            const glm::vec3 a = a_corner(in, world), b = a_corner(in, world);
            ray.direction = a + (b - a) * (static_cast<float>(in.below(5)) * 0.25f) - ray.origin;
            break;
        }
        default:
            ray.direction = a_corner(in, world) - ray.origin;
    }
    if (kind / 20 % 3 == 0) ray.t_max = 1.0f;
    if (kind / 20 % 3 == 1) {
        ray.t_min = in.number();
        ray.t_max = in.number();
    }
    if (kind / 60 == 1) {
        ray.skip_instance = in.below(4);
        ray.skip_primitive = in.below(40);
    }
    return ray;
}

}  // namespace

World world_from(std::span<const std::uint8_t> bytes) {
    Reader in(bytes);
    World world;
    const std::uint32_t meshes = 1 + in.below(3), instances = 1 + in.below(5), rays = 4 + in.below(28);
    for (std::uint32_t i = 0; i < meshes; ++i) {
        world.meshes.push_back(a_mesh(in));
        world.moved.push_back(world.meshes.back().positions);
        for (std::uint32_t k = in.below(6); k > 0; --k)
            world.moved.back()[in.below(static_cast<std::uint32_t>(world.moved.back().size()))] = a_place(in);
    }
    for (std::uint32_t i = 0; i < instances; ++i) {
        const rc::LayerMask layers = in.below(4) == 0 ? in.byte() : rc::kAllLayers;
        world.placed.push_back({in.below(meshes), a_transform(in), layers});
    }
    if (in.below(4) == 0) world.layers = in.byte();
    for (std::uint32_t i = 0; i < rays; ++i) {
        const rc::Ray ray = a_ray(in, world);
        if (is_allowed(ray)) world.rays.push_back(ray);
    }
    for (std::uint32_t i = in.below(5); i > 0; --i) {
        const rc::SphereCast ball{in.triple(), std::abs(in.number()), in.triple()};
        if (is_finite(ball.centre) && std::isfinite(ball.radius) && is_finite(ball.displacement))
            world.balls.push_back(ball);
    }
    return world;
}

}  // namespace fuzz

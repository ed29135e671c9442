#include "support/brute_force.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace test {

namespace {

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_good(const rc::Ray& ray) {
    return is_finite(ray.origin) && is_finite(ray.direction) && ray.direction != glm::vec3(0.0f) &&
           ray.t_min <= ray.t_max;
}

bool is_kept(const Mesh& mesh, const glm::uvec3& t) {
    rc::MeshView one{mesh.positions, std::span(&t, 1)};
    return rc::check_mesh(one).kept() == 1;
}

struct Affine {
    double rows[3][4];
};

// The inverse in double, by cofactors: part of the specification, since a ray is decided in the instance's frame.
std::optional<Affine> inverse_of(const glm::mat4x3& w) {
    double m[3][3], c[3][3];
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t col = 0; col < 3; ++col) m[row][col] = double(w[col][row]);
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t col = 0; col < 3; ++col) {
            const std::size_t r1 = (row + 1) % 3, r2 = (row + 2) % 3, c1 = (col + 1) % 3, c2 = (col + 2) % 3;
            c[row][col] = m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
        }
    }
    const double det = (m[0][0] * c[0][0] + m[0][1] * c[0][1]) + m[0][2] * c[0][2];
    Affine a{};
    if (!(std::abs(det) > 0) || !std::isfinite(det)) return std::nullopt;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t col = 0; col < 3; ++col) a.rows[row][col] = c[col][row] / det;
        a.rows[row][3] = -((a.rows[row][0] * double(w[3][0]) + a.rows[row][1] * double(w[3][1])) +
                           a.rows[row][2] * double(w[3][2]));
        for (const double value : a.rows[row])
            if (!std::isfinite(value)) return std::nullopt;
    }
    return a;
}

glm::vec3 apply(const Affine& a, const glm::vec3& v, bool is_point) {
    glm::vec3 out;
    for (std::size_t r = 0; r < 3; ++r) {
        const double* row = a.rows[r];
        const double linear = (row[0] * double(v.x) + row[1] * double(v.y)) + row[2] * double(v.z);
        out[r] = static_cast<float>(is_point ? linear + row[3] : linear);
    }
    return out;
}

bool precedes(const rc::Hit& a, const rc::Hit& b) {
    if (a.t != b.t) return a.t < b.t;
    return a.instance != b.instance ? a.instance < b.instance : a.primitive < b.primitive;
}

}  // namespace

std::optional<rc::Hit> meet_triangle(const glm::vec3& origin, const glm::vec3& direction,
                                     const glm::vec3 (&corners)[3]) {
    // z is the axis the direction runs along most; of equals, the last.
    const glm::vec3 size = glm::vec3(std::abs(direction.x), std::abs(direction.y), std::abs(direction.z));
    std::size_t kz = 2;
    if (size.x > size.y && size.x > size.z) kz = 0;
    if (size.y >= size.x && size.y > size.z) kz = 1;
    const std::size_t kx = (kz + 1) % 3, ky = (kz + 2) % 3;
    if (direction[kz] == 0.0f || !std::isfinite(direction[kz]) || !is_finite(origin)) return std::nullopt;
    const float shear_x = direction[kx] / direction[kz], shear_y = direction[ky] / direction[kz];

    double x[3], y[3], z[3];
    for (int i = 0; i < 3; ++i) {
        const float dz = corners[i][kz] - origin[kz];
        const float px = shear_x * dz, py = shear_y * dz;
        x[i] = double((corners[i][kx] - origin[kx]) - px);
        y[i] = double((corners[i][ky] - origin[ky]) - py);
        z[i] = double(dz);
    }
    const double u = x[2] * y[1] - y[2] * x[1];
    const double v = x[0] * y[2] - y[0] * x[2];
    const double w = x[1] * y[0] - y[1] * x[0];
    const bool same_side = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    const double sum = (u + v) + w;
    if (!same_side || sum == 0) return std::nullopt;
    rc::Hit hit;
    hit.t = static_cast<float>(((u * z[0] + v * z[1]) + w * z[2]) / (sum * double(direction[kz])));
    hit.u = static_cast<float>(v / sum);
    hit.v = static_cast<float>(w / sum);
    return hit;
}

void TestScene::add(const Mesh& mesh, const glm::mat4x3& world_from_mesh, rc::LayerMask layers) {
    placed_.push_back({meshes_.size(), {rc::build_blas(mesh.view(), {quality_}), world_from_mesh, layers}});
    meshes_.push_back(mesh);
}

void TestScene::add_instance_of_last(const glm::mat4x3& world_from_mesh, rc::LayerMask layers) {
    placed_.push_back({meshes_.size() - 1, {placed_.back().instance.blas, world_from_mesh, layers}});
}

void TestScene::commit() {
    rc::SceneBuilder builder;
    for (const Placed& placed : placed_) builder.add(placed.instance);
    scene_ = builder.commit();
}

std::vector<rc::Hit> TestScene::all_hits(const rc::Ray& ray, rc::LayerMask layers) const {
    std::vector<rc::Hit> hits;
    if (!is_good(ray)) return hits;
    for (std::uint32_t id = 0; id < placed_.size(); ++id) {
        const std::optional<Affine> local = inverse_of(placed_[id].instance.world_from_instance);
        if (!local || !(placed_[id].instance.layers & layers)) continue;
        const glm::vec3 origin = apply(*local, ray.origin, true),
                        direction = apply(*local, ray.direction, false);
        const Mesh& mesh = meshes_[placed_[id].mesh];
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            const glm::uvec3& t = mesh.triangles[i];
            if (id == ray.skip_instance && i == ray.skip_primitive) continue;
            if (std::max({t.x, t.y, t.z}) >= mesh.positions.size()) continue;
            const glm::vec3 corners[3] = {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
            std::optional<rc::Hit> hit = meet_triangle(origin, direction, corners);
            if (!hit || !(ray.t_min <= hit->t && hit->t <= ray.t_max && std::isfinite(hit->t))) continue;
            if (!is_kept(mesh, t)) continue;
            hit->instance = id;
            hit->primitive = i;
            hits.push_back(*hit);
        }
    }
    std::sort(hits.begin(), hits.end(), precedes);
    return hits;
}

std::optional<rc::Hit> TestScene::closest(const rc::Ray& ray, rc::LayerMask layers) const {
    const std::vector<rc::Hit> hits = all_hits(ray, layers);
    if (hits.empty()) return std::nullopt;
    return hits.front();
}

bool same_bits(const rc::Hit& a, const rc::Hit& b) {
    const auto bits = [](float f) { return std::bit_cast<std::uint32_t>(f); };
    return bits(a.t) == bits(b.t) && bits(a.u) == bits(b.u) && bits(a.v) == bits(b.v) &&
           a.primitive == b.primitive && a.instance == b.instance;
}

}  // namespace test

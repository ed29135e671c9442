#include "filter/synthetic.h"

#include "base/random.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gh::test {

namespace {

constexpr float kBallRadius = 0.8f;
const glm::vec3 kLamp(1.2f, 3.2f, -1.0f);

struct Hit {
    float t = 1e30f;
    std::uint32_t part = filter::kNoSurface;
    glm::vec3 point{0.0f}, normal{0.0f};
};

void meet_plane(const glm::vec3& o, const glm::vec3& d, const glm::vec3& n, float offset, std::uint32_t part,
                Hit& hit) {
    const float toward = glm::dot(n, d);
    if (toward >= 0.0f) return;
    const float t = (offset - glm::dot(n, o)) / toward;
    if (t <= 1e-4f || t >= hit.t) return;
    const glm::vec3 p = o + d * t;
    if (p.z < -6.01f || std::abs(p.x) > 4.01f || p.y < -0.01f || p.y > 3.01f || p.z > 4.0f) return;
    hit = {t, part, p, n};
}

Hit meet(const Room& room, const glm::vec3& o, const glm::vec3& d) {
    Hit hit;
    meet_plane(o, d, {0, 1, 0}, 0.0f, kFloor, hit);
    meet_plane(o, d, {0, 0, 1}, -6.0f, kBackWall, hit);
    meet_plane(o, d, {1, 0, 0}, -4.0f, kLeftWall, hit);
    meet_plane(o, d, {-1, 0, 0}, -4.0f, kRightWall, hit);
    const glm::vec3 to = o - room.ball;
    const float b = glm::dot(to, d), c = glm::dot(to, to) - kBallRadius * kBallRadius;
    const float root = b * b - c;
    if (root > 0.0f && -b - std::sqrt(root) > 1e-4f && -b - std::sqrt(root) < hit.t) {
        const float t = -b - std::sqrt(root);
        hit = {t, kBall, o + d * t, glm::normalize(o + d * t - room.ball)};
    }
    return hit;
}

glm::vec3 albedo_at(const Hit& hit) {
    const auto cell = [](float v) { return static_cast<int>(std::floor(v * 2.0f)); };
    if (hit.part == kFloor)
        return glm::vec3(((cell(hit.point.x) + cell(hit.point.z)) & 1) != 0 ? 0.7f : 0.15f);
    if (hit.part == kLeftWall) return {0.7f, 0.2f, 0.15f};
    if (hit.part == kRightWall) return {0.2f, 0.3f, 0.7f};
    if (hit.part == kBall) return {0.6f, 0.55f, 0.2f};
    return {0.6f, 0.6f, 0.6f};
}

// Share of the lamp that the ball leaves visible, with a soft edge.
float visible_share(const Room& room, const Hit& hit) {
    if (hit.part == kBall) return 1.0f;
    const glm::vec3 to = kLamp - hit.point;
    const float along = std::clamp(glm::dot(room.ball - hit.point, to) / glm::dot(to, to), 0.0f, 1.0f);
    const float apart = glm::length(hit.point + to * along - room.ball);
    const float t = std::clamp((apart - 0.7f * kBallRadius) / (0.6f * kBallRadius), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

// Without albedo and without the ball's shadow.
glm::vec3 lamp_light(const Room& room, const Hit& hit) {
    const glm::vec3 to = kLamp - hit.point;
    const float r2 = glm::dot(to, to);
    const float cosine = std::max(0.0f, glm::dot(hit.normal, to) / std::sqrt(r2));
    return glm::vec3(1.0f, 0.85f, 0.6f) * (room.lamp_power * cosine / r2 * 0.3183099f);
}

glm::vec3 indirect_light(const Room& room, const Hit& hit) {
    const float slope = 0.6f + 0.4f * hit.normal.y + 0.05f * hit.point.x - 0.03f * hit.point.z;
    return glm::vec3(0.9f, 0.8f, 0.8f) * (0.012f * room.lamp_power * slope);
}

glm::vec3 radiance(const Room& room, const Hit& hit) {
    if (hit.part == filter::kNoSurface) return glm::vec3(room.sky);
    return albedo_at(hit) * (lamp_light(room, hit) * visible_share(room, hit) + indirect_light(room, hit));
}

struct Size {
    int width, height;
};

void fit(filter::Light& light, Size size) {
    for (filter::Plane3* planes : {&light.direct, &light.indirect, &light.specular, &light.clean}) {
        planes->fit(size.width, size.height);
    }
}

// `ray` and `hit`: of the pixel at (x, y).
void shade(const Room& room, const Hit& hit, const glm::vec3& ray, glm::ivec2 pixel, Random& random,
           Frame& frame) {
    const int x = pixel.x, y = pixel.y;
    frame.surfaces.part.at(x, y) = hit.part;
    if (hit.part == filter::kNoSurface) {
        frame.truth.clean.set(x, y, glm::vec3(room.sky));
        frame.noisy.clean.set(x, y, glm::vec3(room.sky));
        return;
    }
    filter::GBuffer& surfaces = frame.surfaces;
    surfaces.position.set(x, y, hit.point);
    surfaces.previous.set(x, y, hit.part == kBall ? hit.point - room.ball + room.ball_before : hit.point);
    surfaces.normal.set(x, y, hit.normal);
    const glm::vec3 albedo = albedo_at(hit);
    surfaces.albedo.set(x, y, albedo);
    surfaces.roughness.at(x, y) = hit.part == kFloor ? 0.3f : 1.0f;

    const float share = visible_share(room, hit);
    const glm::vec3 lamp = albedo * lamp_light(room, hit), around = albedo * indirect_light(room, hit);
    frame.truth.direct.set(x, y, lamp * share);
    frame.truth.indirect.set(x, y, around);
    // One shadow ray; a bounce that finds light one time in four.
    const float lit = random.unit() < share ? 1.0f : 0.0f;
    frame.noisy.direct.set(x, y, lamp * (lit * (0.5f + random.unit())));
    const float found = random.unit() < 0.25f ? 4.0f : 0.0f;
    frame.noisy.indirect.set(x, y, around * (found * (0.5f + random.unit())));
    if (hit.part != kFloor) return;
    const glm::vec3 away = ray - hit.normal * (2.0f * glm::dot(ray, hit.normal));
    const Hit seen = meet(room, hit.point, away);
    surfaces.reflected.at(x, y) = seen.part == filter::kNoSurface ? 1000.0f : seen.t;
    const glm::vec3 gloss = 0.2f * radiance(room, seen);
    frame.truth.specular.set(x, y, gloss);
    frame.noisy.specular.set(x, y, gloss * (random.unit() < 0.5f ? 2.0f : 0.0f));
}

}  // namespace

filter::Pinhole lens_of(const Room& room, int width, int height) {
    const glm::vec3 right(std::cos(room.yaw), 0.0f, -std::sin(room.yaw));
    const glm::vec3 ahead(-std::sin(room.yaw), 0.0f, -std::cos(room.yaw));
    const float pixel = 1.2f / static_cast<float>(height);
    return {
        .eye = room.eye,
        .corner = ahead - right * (0.5f * pixel * static_cast<float>(width)) + glm::vec3(0.0f, 0.6f, 0.0f),
        .right = right * pixel,
        .down = {0.0f, -pixel, 0.0f}};
}

Frame render(const Room& room, int width, int height, std::uint32_t seed, bool jitters) {
    Frame frame;
    frame.surfaces.lens = lens_of(room, width, height);
    frame.surfaces.fit(width, height);
    frame.surfaces.previous.fit(width, height);
    frame.surfaces.albedo.fit(width, height);
    frame.surfaces.roughness.fit(width, height);
    frame.surfaces.reflected.fit(width, height);
    fit(frame.truth, {width, height});
    fit(frame.noisy, {width, height});
    const filter::Pinhole& lens = frame.surfaces.lens;
    for (int y = 0; y < height; ++y) {
        Random random((std::uint64_t{seed} << 32) | static_cast<std::uint32_t>(y));
        for (int x = 0; x < width; ++x) {
            const float dx = random.unit(), dy = random.unit();
            const float at_x = static_cast<float>(x) + (jitters ? dx : 0.5f);
            const float at_y = static_cast<float>(y) + (jitters ? dy : 0.5f);
            const glm::vec3 d = glm::normalize(lens.corner + lens.right * at_x + lens.down * at_y);
            shade(room, meet(room, room.eye, d), d, {x, y}, random, frame);
        }
    }
    return frame;
}

filter::Plane3 total(const filter::Light& light) {
    filter::Plane3 sum(light.direct.width(), light.direct.height());
    for (int y = 0; y < sum.height(); ++y) {
        for (int x = 0; x < sum.width(); ++x) {
            sum.set(x, y,
                    light.direct.get(x, y) + light.indirect.get(x, y) + light.specular.get(x, y) +
                        light.clean.get(x, y));
        }
    }
    return sum;
}

double rel_mse(const filter::Plane3& picture, const filter::Plane3& truth) {
    double sum = 0.0;
    for (int y = 0; y < truth.height(); ++y) {
        for (int x = 0; x < truth.width(); ++x) {
            const glm::dvec3 a(picture.get(x, y)), b(truth.get(x, y));
            sum += glm::dot(a - b, a - b) / (glm::dot(b, b) + 0.01);
        }
    }
    return sum / (static_cast<double>(truth.width()) * truth.height());
}

}  // namespace gh::test

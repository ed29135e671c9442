#include "cast_math.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace rc::cast {

namespace {

// How far beyond its end a piece still counts, in shares of its size: more than rounding, less than a float
// sees.
constexpr double kBeyond = 1e-12;

bool is_share(double x) {
    return x >= -kBeyond && x <= 1.0 + kBeyond;
}

// The first moment at which the moving point enters a piece, and where on K and on the axis that is.
struct Entry {
    double t = std::numeric_limits<double>::infinity();
    glm::dvec3 on_k{0.0};
    double along_axis = 0.0;  // K's point is the triangle's minus this share of the axis
    glm::dvec3 normal{0.0};
};

// A point against K thickened by `radius`, from which it starts outside.
class Sweep {
  public:
    Sweep(const Body& body, double radius, const Corners& triangle)
        : body_(body), radius_(radius), corners_(triangle), speed_square_(square(body.displacement)) {}

    // At any t >= 0, also beyond the end of the way; nothing when the point never enters.
    [[nodiscard]] std::optional<Contact> first_entry() {
        const bool is_capsule = square(body_.axis) > 0.0;
        const std::size_t ends = is_capsule ? 2 : 1;
        for (std::size_t end = 0; end < ends; ++end) {
            const auto share = static_cast<double>(end);
            const glm::dvec3 shift = -share * body_.axis;
            enter_face({corners_[0] + shift, corners_[1] - corners_[0], corners_[2] - corners_[0], true},
                       share);
            for (std::size_t i = 0; i < 3; ++i) {
                enter_cylinder(corners_[i] + shift, corners_[(i + 1) % 3] - corners_[i], share, 0.0);
                enter_ball(corners_[i] + shift, share);
            }
        }
        for (std::size_t i = 0; is_capsule && i < 3; ++i) {
            enter_face({corners_[i], corners_[(i + 1) % 3] - corners_[i], -body_.axis, false}, 0.0);
            enter_cylinder(corners_[i], -body_.axis, 0.0, 1.0);
        }
        if (!(first_.t < std::numeric_limits<double>::infinity())) return std::nullopt;
        return Contact{.t = first_.t,
                       .depth = 0.0,
                       .point = first_.on_k + first_.along_axis * body_.axis,
                       .normal = first_.normal};
    }

  private:
    // A triangle or a parallelogram of K: corner + u * side1 + v * side2.
    struct Face {
        glm::dvec3 corner, side1, side2;
        bool is_triangle;
    };

    void enter_face(const Face& face, double along_axis) {
        const glm::dvec3 cross = glm::cross(face.side1, face.side2);
        const double area_square = square(cross);
        if (!(area_square > 0.0)) return;
        const glm::dvec3 normal = cross / std::sqrt(area_square);
        const double height = glm::dot(normal, -face.corner);
        const double side = height > 0.0 ? 1.0 : -1.0;
        const double rounding = kBeyond * (glm::dot(glm::abs(face.corner), glm::dvec3(1.0)) + radius_);
        double gap = std::abs(height) - radius_;
        if (!(gap >= -rounding)) return;  // beside the face: it can only be entered through an edge
        gap = gap > 0.0 ? gap : 0.0;
        const double approach = -side * glm::dot(normal, body_.displacement);
        if (!(approach > 0.0)) return;

        const double t = gap / approach;
        if (!(t < first_.t)) return;
        const glm::dvec3 outward = side * normal;
        const glm::dvec3 at = (t * body_.displacement - radius_ * outward) - face.corner;
        const double u = glm::dot(glm::cross(at, face.side2), cross) / area_square;
        const double v = glm::dot(glm::cross(face.side1, at), cross) / area_square;
        if (!is_share(u) || !is_share(v) || (face.is_triangle && !is_share(u + v))) return;
        // The second side of a parallelogram is the axis, backwards.
        const double share = face.is_triangle ? along_axis : v;
        first_ = {t, face.corner + u * face.side1 + v * face.side2, share, outward};
    }

    // Round the edge from `from` to `from + edge`; a share of the edge is a share of the axis times
    // `axis_per_edge`.
    void enter_cylinder(const glm::dvec3& from, const glm::dvec3& edge, double along_axis,
                        double axis_per_edge) {
        const double edge_square = square(edge);
        if (!(edge_square > 0.0)) return;
        // Crossed with the edge's direction, a vector is its part across the edge, turned by a right angle.
        const glm::dvec3 direction = edge / std::sqrt(edge_square);
        const glm::dvec3 start = glm::cross(-from, direction);
        const glm::dvec3 way = glm::cross(body_.displacement, direction);
        const double t = time_to_circle(start, way);
        if (!(t < first_.t)) return;
        const glm::dvec3 at = t * body_.displacement;
        const double share = glm::dot(at - from, edge) / edge_square;
        if (!is_share(share)) return;
        const glm::dvec3 on_k = from + share * edge;
        first_ = {t, on_k, along_axis + axis_per_edge * share, (at - on_k) / radius_};
    }

    void enter_ball(const glm::dvec3& corner, double along_axis) {
        const double t = time_to_circle(-corner, body_.displacement);
        if (!(t < first_.t)) return;
        first_ = {t, corner, along_axis, (t * body_.displacement - corner) / radius_};
    }

    // When a point at `start` moving by `way` comes within the radius of 0; infinity when it never does. The
    // point of nearest approach is formed first: the textbook's b * b - a * c would cancel from afar.
    [[nodiscard]] double time_to_circle(const glm::dvec3& start, const glm::dvec3& way) const {
        constexpr double kNever = std::numeric_limits<double>::infinity();
        const double way_square = square(way);
        if (!(radius_ > 0.0) || !(way_square > speed_square_ * kBeyond * kBeyond))
            return kNever;  // a point, or parallel
        const double nearest_t = -glm::dot(start, way) / way_square;
        if (!(nearest_t >= 0.0)) return kNever;
        const double spare = radius_ * radius_ - square(start + nearest_t * way);
        if (!(spare >= 0.0)) return kNever;
        const double t = nearest_t - std::sqrt(spare / way_square);
        // Inside already: beyond an edge's ends, which its share will tell, or by rounding, for the body is
        // known not to overlap at the start.
        return t > 0.0 ? t : 0.0;
    }

    const Body& body_;
    double radius_;
    const Corners& corners_;
    double speed_square_;
    Entry first_;
};

// Whether the body stays on one side of the triangle's plane, farther than its radius, all the way.
bool keeps_clear_of_plane(const Body& body, const Corners& triangle) {
    const glm::dvec3 normal = unit_normal(triangle);
    const double from = glm::dot(normal, -triangle[0]);
    const double to = glm::dot(normal, body.axis - triangle[0]);
    const double way = glm::dot(normal, body.displacement);
    const double low = (from < to ? from : to) + (way < 0.0 ? way : 0.0);
    const double high = (from > to ? from : to) + (way > 0.0 ? way : 0.0);
    const double reach = (body.radius + body.touch) * (1.0 + kBeyond);
    return low > reach || high < -reach;
}

Contact at_start(const Body& body, const Closest& closest) {
    const double depth = (body.radius - closest.distance) + closest.way_out;
    return {
        .t = 0.0, .depth = depth > 0.0 ? depth : 0.0, .point = closest.on_triangle, .normal = closest.normal};
}

bool overlaps(const Body& body, const Closest& closest) {
    return closest.goes_through || body.radius - closest.distance > body.touch;
}

}  // namespace

std::optional<Contact> resting_contact(const Body& body, const Corners& triangle) {
    if (keeps_clear_of_plane(body, triangle)) return std::nullopt;
    const Closest closest = closest_points(body.axis, triangle, body.displacement);
    if (!overlaps(body, closest)) return std::nullopt;
    return at_start(body, closest);
}

std::optional<Contact> first_contact(const Body& body, const Corners& triangle) {
    if (keeps_clear_of_plane(body, triangle)) return std::nullopt;
    const Closest closest = closest_points(body.axis, triangle, body.displacement);
    if (overlaps(body, closest)) return at_start(body, closest);
    if (!(square(body.displacement) > 0.0)) return std::nullopt;
    // The distance to something convex that does not shrink at first never shrinks: resting bodies are done
    // here.
    const bool is_touching = closest.distance <= body.radius + body.touch;
    if (is_touching && glm::dot(closest.normal, body.displacement) >= 0.0) return std::nullopt;

    const std::optional<Contact> contact = closest.distance <= body.radius
                                               ? at_start(body, closest)
                                               : Sweep(body, body.radius, triangle).first_entry();
    if (!contact || !(contact->t <= 1.0)) return std::nullopt;
    // What only ever grazes, even if it went on for ever, is not met: else a ball that rolls over a floor
    // would stop at each seam. A ball smaller by `touch` passes the same gaps, so that nothing closed is ever
    // left like this.
    if (body.touch > 0.0 && !Sweep(body, body.radius - body.touch, triangle).first_entry())
        return std::nullopt;
    return contact;
}

}  // namespace rc::cast

#include "metrics/blur.h"
#include "metrics/picture_metrics.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

// Numbers of equations and tables are those of the paper named in the header.
namespace metrics {

namespace {

constexpr double kPi = 3.14159265358979323846;

// Linear BT.709 to CIE XYZ, D65, by rows; white is what (1, 1, 1) becomes.
const glm::dmat3 kXyzFromRgb =
    glm::transpose(glm::dmat3(0.41238656, 0.35759149, 0.18045049, 0.21263682, 0.71518298, 0.07218020,
                              0.01933062, 0.11919716, 0.95037259));
const glm::dvec3 kWhite = kXyzFromRgb * glm::dvec3(1.0);

double linear_from_shown(float shown) {
    const double c = shown > 0.0f ? static_cast<double>(std::min(shown, 1.0f)) : 0.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// The linearised opponent space in which the eye's sensitivity is known: Y Cx Cz (section 4.1.1).
glm::dvec3 opponent_from_xyz(const glm::dvec3& xyz) {
    const glm::dvec3 r = xyz / kWhite;
    return {116.0 * r.y - 16.0, 500.0 * (r.x - r.y), 200.0 * (r.y - r.z)};
}

glm::dvec3 xyz_from_opponent(const glm::dvec3& o) {
    const double y = (o.x + 16.0) / 116.0;
    return glm::dvec3(y + o.y / 500.0, y, y - o.z / 200.0) * kWhite;
}

// CIE L*a*b* with Hunt's adjustment: colours in the dark differ less (section 4.1.2).
glm::dvec3 perceived(const glm::dvec3& rgb) {
    const auto bent = [](double t) {
        constexpr double kDelta = 6.0 / 29.0;
        return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
    };
    const glm::dvec3 r = kXyzFromRgb * rgb / kWhite;
    const double x = bent(r.x), y = bent(r.y), z = bent(r.z);
    const double lightness = 116.0 * y - 16.0;
    return {lightness, 0.01 * lightness * 500.0 * (x - y), 0.01 * lightness * 200.0 * (y - z)};
}

constexpr double kColourExponent = 0.7;

// HyAB, for large differences (section 4.1.3), compressed.
double colour_distance(const glm::dvec3& a, const glm::dvec3& b) {
    const double chroma = std::hypot(a.y - b.y, a.z - b.z);
    return std::pow(std::abs(a.x - b.x) + chroma, kColourExponent);
}

// The small ones, that one sees most of, get most of [0, 1].
double spread(double distance) {
    static const double kLargest = colour_distance(perceived({0, 1, 0}), perceived({0, 0, 1}));
    constexpr double kSmall = 0.4, kShareOfSmall = 0.95;
    const double knee = kSmall * kLargest;
    if (distance < knee) return distance * kShareOfSmall / knee;
    return kShareOfSmall + (distance - knee) / (kLargest - knee) * (1.0 - kShareOfSmall);
}

struct Channels {
    std::array<Grid, 3> grid;
};

Channels opponent_of(const gh::Image& shown) {
    Channels out{
        {Grid(shown.width, shown.height), Grid(shown.width, shown.height), Grid(shown.width, shown.height)}};
    for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
        const glm::vec3& c = shown.pixels[i];
        const glm::dvec3 linear(linear_from_shown(c.x), linear_from_shown(c.y), linear_from_shown(c.z));
        const glm::dvec3 opponent = opponent_from_xyz(kXyzFromRgb * linear);
        for (std::size_t k = 0; k < 3; ++k) out.grid[k].values[i] = opponent[static_cast<glm::length_t>(k)];
    }
    return out;
}

// Table 1: the eye's contrast sensitivity as sums of Gaussians a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees. In two
// dimensions the factor is that of x^2 + y^2, so it is not squared.
struct Bell {
    double a, b;
};
constexpr Bell kSensitivity[3][2] = {
    {{1.0, 0.0047}, {0.0, 1e-5}}, {{1.0, 0.0053}, {0.0, 1e-5}}, {{34.1, 0.04}, {13.5, 0.025}}};

Grid as_seen(const Grid& in, const Bell bells[2], double ppd) {
    const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * kPi * kPi)) * ppd));
    Grid out(in.width, in.height);
    double share[2], total = 0.0;
    Kernel kernels[2];
    for (int k = 0; k < 2; ++k) {
        const double sigma = std::sqrt(bells[k].b / (2.0 * kPi * kPi)) * ppd;
        double sum = 0.0;  // of the bell over a line of pixels
        for (int i = -radius; i <= radius; ++i) sum += std::exp(-0.5 * i * i / (sigma * sigma));
        kernels[k] = gaussian_kernel(sigma, radius);
        share[k] = bells[k].a * std::sqrt(kPi / bells[k].b) * sum * sum;
        total += share[k];
    }
    for (int k = 0; k < 2; ++k) {
        if (share[k] == 0.0) continue;
        const Grid part = convolved(in, kernels[k], kernels[k]);
        for (std::size_t i = 0; i < out.values.size(); ++i)
            out.values[i] += share[k] / total * part.values[i];
    }
    return out;
}

std::vector<glm::dvec3> colours_as_seen(const Channels& opponent, double ppd) {
    const Grid y = as_seen(opponent.grid[0], kSensitivity[0], ppd);
    const Grid cx = as_seen(opponent.grid[1], kSensitivity[1], ppd);
    const Grid cz = as_seen(opponent.grid[2], kSensitivity[2], ppd);
    const glm::dmat3 rgb_from_xyz = glm::inverse(kXyzFromRgb);
    std::vector<glm::dvec3> out(y.values.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const glm::dvec3 rgb = rgb_from_xyz * xyz_from_opponent({y.values[i], cx.values[i], cz.values[i]});
        out[i] = perceived(
            {std::clamp(rgb.x, 0.0, 1.0), std::clamp(rgb.y, 0.0, 1.0), std::clamp(rgb.z, 0.0, 1.0)});
    }
    return out;
}

// Edges by a Gaussian's first derivative, points by its second; positive and negative weights sum to 1 and -1.
Kernel feature_kernel(double sigma, int radius, bool points) {
    Kernel kernel;
    double above = 0.0, under = 0.0;
    for (int i = -radius; i <= radius; ++i) {
        const double bell = std::exp(-0.5 * i * i / (sigma * sigma));
        kernel.push_back(points ? (i * i / (sigma * sigma) - 1.0) * bell : -i * bell);
        (kernel.back() > 0.0 ? above : under) += std::abs(kernel.back());
    }
    for (double& weight : kernel) weight /= weight > 0.0 ? above : under;
    return kernel;
}

// How strong an edge (or a point) is at each pixel (section 4.2).
std::vector<double> features(const Grid& lightness, double ppd, bool points) {
    const double sigma = 0.5 * 0.082 * ppd;
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    const Kernel along = feature_kernel(sigma, radius, points), across = gaussian_kernel(sigma, radius);
    const Grid x = convolved(lightness, along, across), y = convolved(lightness, across, along);
    std::vector<double> out(x.values.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::hypot(x.values[i], y.values[i]);
    return out;
}

Grid lightness_of(const Channels& opponent) {
    Grid out = opponent.grid[0];
    for (double& y : out.values) y = (y + 16.0) / 116.0;
    return out;
}

}  // namespace

double pixels_per_degree(double distance_m, double screen_width_m, int screen_width_px) {
    return distance_m * (screen_width_px / screen_width_m) * (kPi / 180.0);
}

Flip flip(const gh::Image& shown, const gh::Image& reference, double ppd) {
    EXPECTS(shown.width == reference.width && shown.height == reference.height && !shown.pixels.empty());
    EXPECTS(ppd > 0.0);
    const Channels a = opponent_of(shown), b = opponent_of(reference);
    const std::vector<glm::dvec3> colour_a = colours_as_seen(a, ppd), colour_b = colours_as_seen(b, ppd);
    const Grid light_a = lightness_of(a), light_b = lightness_of(b);
    const std::vector<double> edge_a = features(light_a, ppd, false), edge_b = features(light_b, ppd, false);
    const std::vector<double> point_a = features(light_a, ppd, true), point_b = features(light_b, ppd, true);
    Flip out;
    out.map.reserve(colour_a.size());
    for (std::size_t i = 0; i < colour_a.size(); ++i) {
        const double colour = spread(colour_distance(colour_a[i], colour_b[i]));
        const double feature = std::max(std::abs(edge_a[i] - edge_b[i]), std::abs(point_a[i] - point_b[i]));
        const double noticed = std::sqrt(std::min(1.0, feature / std::sqrt(2.0)));
        const double error = std::pow(colour, 1.0 - noticed);
        out.map.push_back(static_cast<float>(error));
        out.mean += error;
    }
    out.mean /= static_cast<double>(out.map.size());
    return out;
}

}  // namespace metrics

// filter/geometry-inl.h - how far a neighbour is from being on the same surface: the edge-stopping function by depth
// and normal that all filters over the picture share. Compiled once per instruction set; see simd-inl.h.
#if defined(GH_FILTER_GEOMETRY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GH_FILTER_GEOMETRY_INL_H_
#undef GH_FILTER_GEOMETRY_INL_H_
#else
#define GH_FILTER_GEOMETRY_INL_H_
#endif

#include "filter/guides.h"
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

constexpr float kDepthTolerance = 0.01f;  // off the plane as a share of the distance: falls to 1/e
constexpr float kSlantTolerance =
    0.1f;  // the same, as a share of what the plane's slant amounts to over the reach
constexpr float kNormalSharpness = 128.0f;  // about the exponent of cos in Schied et al. 2017, equation 4

// The surface of a vector of pixels, readied for asking its neighbours within `reach` pixels.
struct Surface {
    Floats nearness, slope_x, slope_y;
    Floats nx, ny, nz;  // normal times sharpness / 4
    Floats scale;       // of nearness
};

static HWY_INLINE Surface surface_at(const GuideRows& guides, std::size_t x, float reach) {
    const Floats sharp = splat(0.25f * kNormalSharpness);
    Surface s;
    s.nearness = load(guides.nearness + x);
    s.slope_x = load(guides.slope_x + x);
    s.slope_y = load(guides.slope_y + x);
    s.nx = hn::Mul(load(guides.normal[0] + x), sharp);
    s.ny = hn::Mul(load(guides.normal[1] + x), sharp);
    s.nz = hn::Mul(load(guides.normal[2] + x), sharp);
    const Floats slant =
        hn::Mul(hn::Add(hn::Abs(s.slope_x), hn::Abs(s.slope_y)), splat(kSlantTolerance * reach));
    const Floats tolerance = hn::Add(hn::Mul(s.nearness, splat(kDepthTolerance)), slant);
    s.scale = hn::Div(splat(0.25f), hn::Add(tolerance, splat(1e-20f)));
    return s;
}

// The argument of falloff() for the neighbour that begins at `at`, where the surface foretells nearness `foretold`.
static HWY_INLINE Floats apart(const Surface& s, const GuideRows& guides, std::ptrdiff_t at,
                               Floats foretold) {
    const Floats off = hn::Mul(hn::Abs(hn::Sub(load(guides.nearness + at), foretold)), s.scale);
    const Floats cosine = dot(s.nx, s.ny, s.nz, load(guides.normal[0] + at), load(guides.normal[1] + at),
                              load(guides.normal[2] + at));
    return hn::Add(off, hn::Abs(hn::Sub(splat(0.25f * kNormalSharpness), cosine)));
}

// What the surface foretells `dx` pixels to the right of `base`, itself foretold in some row.
static HWY_INLINE Floats beside(const Surface& s, Floats base, int dx) {
    return hn::Add(base, hn::Mul(s.slope_x, splat(static_cast<float>(dx))));
}
static HWY_INLINE Floats below(const Surface& s, int dy) {
    return hn::Add(s.nearness, hn::Mul(s.slope_y, splat(static_cast<float>(dy))));
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GH_FILTER_GEOMETRY_INL_H_

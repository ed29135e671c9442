#include "filter/gbuffer.h"

namespace gh::filter {

namespace {

void fit_if_used(Plane3& plane, int width, int height) {
    if (!plane.empty()) plane.fit(width, height);
}

void fit_if_used(Plane& plane, int width, int height) {
    if (!plane.empty()) plane.fit(width, height);
}

}  // namespace

void GBuffer::fit(int width, int height) {
    part.resize(width, height, kNoSurface);
    position.fit(width, height);
    normal.fit(width, height);
    fit_if_used(previous, width, height);
    fit_if_used(geometric, width, height);
    fit_if_used(albedo, width, height);
    fit_if_used(gloss, width, height);
    fit_if_used(roughness, width, height);
    fit_if_used(reflected, width, height);
}

}  // namespace gh::filter

#include "app/guided_picture.h"

#include "render/guide.h"
#include "render/last_picture.h"

#include <optional>
#include <utility>

namespace gh::app {

glm::vec2 GuidedPicture::begin(const render::SceneView& scene, const render::Camera& camera,
                               render::WhittedSettings settings, std::uint32_t frame,
                               const PictureShape& shape, const Jobs& jobs) {
    render::SceneView view = scene;
    std::swap(guide_, guide_before_);
    std::optional<render::LastPicture> last;
    if (has_picture_) {
        last.emplace(picture_, guide_before_, shape_.shown());
        view.last = &*last;
    }
    shape_ = shape;
    jitter_ = filter::halton_jitter(frame);
    offset_ = filter::lit_offset(frame, shape.step);
    settings.jitter = jitter_;
    settings.texture_blur = static_cast<float>(shape.step) * texture_blur(shape);
    render::render_guide(view, camera, settings, shape.shown(), jobs, guide_);
    return filter::small_jitter(jitter_, offset_, shape.step);
}

void GuidedPicture::add(const Image& radiance, const Jobs& jobs) {
    const filter::Guide guide{.width = shape_.shown().x,
                              .height = shape_.shown().y,
                              .lens = {guide_.eye, guide_.corner, guide_.right, guide_.down},
                              .jitter = jitter_,
                              .part = guide_.part,
                              .position = guide_.position,
                              .previous = guide_.previous,
                              .geometric = guide_.geometric,
                              .albedo = guide_.albedo,
                              .clean = guide_.clean.pixels,
                              .outshone = guide_.outshone};
    upscaler_.add({radiance, shape_.step, offset_, guide, shape_.doubles}, jobs, picture_);
    has_picture_ = true;
}

}  // namespace gh::app

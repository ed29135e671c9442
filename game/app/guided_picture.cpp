#include "app/guided_picture.h"

#include "render/guide.h"

namespace gh::app {

glm::vec2 GuidedPicture::begin(const render::SceneView& scene, const render::Camera& camera,
                               render::WhittedSettings settings, std::uint32_t frame,
                               const PictureShape& shape, const Jobs& jobs) {
    shape_ = shape;
    jitter_ = filter::halton_jitter(frame);
    offset_ = filter::lit_offset(frame, shape.step);
    settings.jitter = jitter_;
    settings.texture_blur = static_cast<float>(shape.step) * texture_blur(shape);
    render::render_guide(scene, camera, settings, shape.shown(), jobs, guide_);
    return filter::small_jitter(jitter_, offset_, shape.step);
}

void GuidedPicture::add(const Image& radiance, const Jobs& jobs, Image& out) {
    const filter::Guide guide{.width = shape_.shown().x,
                              .height = shape_.shown().y,
                              .lens = {guide_.eye, guide_.corner, guide_.right, guide_.down},
                              .jitter = jitter_,
                              .part = guide_.part,
                              .position = guide_.position,
                              .previous = guide_.previous,
                              .geometric = guide_.geometric,
                              .albedo = guide_.albedo,
                              .clean = guide_.clean.pixels};
    upscaler_.add({radiance, shape_.step, offset_, guide, shape_.doubles}, jobs, out);
}

}  // namespace gh::app

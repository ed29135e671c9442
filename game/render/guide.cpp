#include "render/guide.h"

#include "base/contracts.h"
#include "render/frame_light.h"
#include "render/guide_colors.h"
#include "render/guide_gleams.h"
#include "render/guide_point.h"
#include "render/sky.h"
#include "render/tile.h"
#include "world/layers.h"

#include "raycore/query.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace gh::render {

namespace {

constexpr std::size_t kIndicesAhead = 12, kCornersAhead = 6;  // hits whose memory is asked for

// Most pixels show a plain surface and need no more than the triangle and its colour there. The others go the way that
// every ray of a picture goes.
class GuideTracer {
  public:
    explicit GuideTracer(const Frame& frame)
        : colors_(frame.settings.texture_taps), tracer_(frame), frame_(frame) {
        if (frame.view.last != nullptr)
            gleams_.emplace(
                GleamTracer::World{frame.view, frame.light, frame.gloss, frame.settings.guides_lamps});
    }

    void trace(int tile_x, int tile_y) {
        const int left = tile_x * kTileSide, top = tile_y * kTileSide;
        const int columns = std::min(kTileSide, frame_.width - left);
        const int rows = std::min(kTileSide, frame_.height - top);
        rays_.clear();
        for (int y = 0; y < rows; ++y) {
            for (int x = 0; x < columns; ++x)
                rays_.push_back(
                    frame_.lens.ray(glm::vec2(left + x, top + y) + 0.5f + frame_.settings.jitter));
        }
        hits_.resize(rays_.size());
        rc::closest_hits(*frame_.view.snapshot.scene, rays_, world::Light, hits_);
        not_plain_.clear();
        met_.clear();
        for (std::size_t i = 0; i < hits_.size(); ++i) {
            if (i + kIndicesAhead < hits_.size()) fetch_indices(frame_.view, hits_[i + kIndicesAhead]);
            if (i + kCornersAhead < hits_.size()) fetch_corners(frame_.view, hits_[i + kCornersAhead]);
            const auto pixel = static_cast<int>(i);
            const std::size_t at =
                static_cast<std::size_t>(top + pixel / columns) * static_cast<std::size_t>(frame_.width) +
                static_cast<std::size_t>(left + pixel % columns);
            if (note_plain(rays_[i], hits_[i], at)) continue;
            not_plain_.push_back(static_cast<std::uint16_t>(i));
            met_.push_back(hits_[i]);
        }
        colors_.flush();
        if (!not_plain_.empty()) tracer_.look_at(tile_x, tile_y, not_plain_, met_);
        if (gleams_) gleams_->trace(*frame_.guide);
    }

  private:
    // False, and nothing done, for what is not plain.
    bool note_plain(const rc::Ray& ray, const rc::Hit& hit, std::size_t at) {
        glm::vec3& clean = frame_.guide->clean.pixels[at];
        if (hit.is_miss()) {
            note({}, at, *frame_.guide);
            clean = sky_radiance(frame_.light.sun, ray.direction);
            return true;
        }
        const GuideTriangle& triangle = triangles_.of(frame_.view, hit);
        if (!triangle.is_plain && !(gleams_ && triangle.is_polished)) {
            note({}, at, *frame_.guide);  // should nothing come of it
            return false;
        }
        const GuidePoint point = plain_point(frame_.view, triangle, ray, hit);
        note(point, at, *frame_.guide);
        clean = glm::vec3(0.0f);
        const float width = frame_.lens.pixel_angle() * hit.t * frame_.settings.texture_blur;
        const float weight = frame_.light.emission_on[hit.instance] != 0 ? 1.0f : 0.0f;
        colors_.add(frame_.view, triangle, hit, {ray.direction, point.geometric, width},
                    {&frame_.guide->albedo[at], &clean, glm::vec3(weight)});
        if (gleams_ && triangle.is_polished) gleams_->add(triangle, ray, hit, at, *frame_.guide);
        return true;
    }

    GuideColors colors_;
    TileTracer tracer_;
    std::optional<GleamTracer> gleams_;
    const Frame& frame_;
    std::vector<rc::Ray> rays_;
    std::vector<rc::Hit> hits_;
    std::vector<std::uint16_t> not_plain_;
    std::vector<rc::Hit> met_;  // by those
    GuideTriangles triangles_;
};

void fit(GuidePlanes& planes, glm::ivec2 size) {
    const std::size_t count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    planes.part.resize(count);
    planes.outshone.assign(count, 0);
    for (auto* plane : {&planes.position, &planes.previous, &planes.geometric, &planes.albedo})
        plane->resize(count);
    if (planes.clean.width != size.x || planes.clean.height != size.y) planes.clean = Image(size.x, size.y);
}

}  // namespace

void render_guide(const SceneView& scene, const Camera& camera, const WhittedSettings& settings,
                  glm::ivec2 size, const Jobs& jobs, GuidePlanes& planes) {
    EXPECTS(size.x >= 1 && size.y >= 1);
    fit(planes, size);
    WhittedSettings looks = settings;
    looks.samples_per_pixel = 1;
    looks.shares_samples = true;
    const FrameLight light = frame_light(scene, scene.last != nullptr);
    const Frame frame{.view = scene,
                      .settings = looks,
                      .light = light,
                      .gloss = scene.prepared.gloss,
                      .lens = Lens(camera, size.x, size.y),
                      .width = size.x,
                      .height = size.y,
                      .guide = &planes};
    planes.eye = frame.lens.position();
    planes.corner = frame.lens.corner();
    planes.right = frame.lens.right();
    planes.down = frame.lens.down();
    const int across = (size.x + kTileSide - 1) / kTileSide, down = (size.y + kTileSide - 1) / kTileSide;
    std::vector<std::unique_ptr<GuideTracer>> tracers(static_cast<std::size_t>(jobs.threads()));
    jobs.run(static_cast<std::size_t>(across) * static_cast<std::size_t>(down),
             [&](std::size_t tile, int worker) {
                 std::unique_ptr<GuideTracer>& tracer = tracers[static_cast<std::size_t>(worker)];
                 if (tracer == nullptr) tracer = std::make_unique<GuideTracer>(frame);
                 tracer->trace(static_cast<int>(tile) % across, static_cast<int>(tile) / across);
             });
}

}  // namespace gh::render

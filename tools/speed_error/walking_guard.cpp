#include "walking_guard.h"

#include "render/path_tracer.h"
#include "shown.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <memory>

namespace speed_error {

namespace {

constexpr int kFrames = 28, kFirstJudged = 15, kBetween = 4;  // the last one is judged
constexpr int kLeftWithin = 4;                                // pictures
constexpr float kMoves = 1e-3f;                               // metres; less is rounding
constexpr int kTruthSamples = 32;
constexpr float kAway = 50.0f;  // metres under the floor
constexpr float kAhead = 4.0f, kSpeed = 1.4f, kSeconds = 1.0f / 30.0f;

}  // namespace

// One moment of the walk.
struct Moment {
    gh::world::Snapshot world;
    std::vector<bool> is_guard;  // of each pixel
};

struct Walk {
    const View& view;
    int width, height;
    const gh::Jobs& jobs;
    std::vector<Moment> moments;
    gh::world::Snapshot empty;  // without him

    [[nodiscard]] gh::render::SceneView scene(std::size_t i) const {
        return {*view.studio.level, moments[i].world, view.studio.prepared,
                i > 0 ? &moments[i - 1].world : nullptr};
    }
};

namespace {

gh::world::Snapshot walked(const Walk& walk, int frame) {
    const gh::render::Camera& eye = walk.view.camera;
    const glm::vec3 ahead(-std::sin(eye.yaw), 0.0f, -std::cos(eye.yaw)), right(-ahead.z, 0.0f, ahead.x);
    gh::world::State state = walk.view.studio.snapshot.state;
    gh::world::GuardState& guard = state.guards[0];
    const float along = kSpeed * kSeconds * static_cast<float>(frame - kFrames / 2);
    const float feet = guard.position.y;
    guard.position = eye.position + ahead * kAhead + right * along;
    guard.position.y = feet;
    guard.yaw = std::atan2(-right.x, -right.z);
    guard.clip = guard.clip_before = gh::world::ClipId::Walk;
    guard.clip_time = guard.clip_before_time = 0.5f + kSeconds * static_cast<float>(frame);
    return walk.view.studio.stage->commit(state, walk.jobs);
}

// Which pixels show something that moved by itself.
std::vector<bool> moving_pixels(const Walk& walk, std::size_t moment) {
    gh::render::PathSettings settings = gh::render::realtime_path();
    settings.jitters = false;
    gh::render::Film film(walk.width, walk.height);
    render_path(walk.scene(moment), walk.view.camera, settings, 0, walk.jobs, film);
    std::vector<bool> moves;
    for (int y = 0; y < walk.height; ++y) {
        for (int x = 0; x < walk.width; ++x) {
            const glm::vec3 now = film.planes.position.get(x, y), then = film.planes.previous.get(x, y);
            moves.push_back(glm::distance(now, then) > kMoves);
        }
    }
    return moves;
}

gh::Image true_picture(const Walk& walk, std::size_t moment, const std::string& truth) {
    gh::render::Film film(walk.width, walk.height);
    const Contestant contestant = truth_of(truth, kTruthSamples);
    contestant.begin()(
        {.scene = walk.scene(moment), .camera = walk.view.camera, .seed = 77, .jobs = walk.jobs}, film);
    return film.radiance;
}

// Squares of differences, and what is left of one picture in another.
struct Sums {
    double squares = 0.0, pixels = 0.0;
    [[nodiscard]] double rms_percent() const {
        return pixels > 0.0 ? 100.0 * std::sqrt(squares / pixels) : 0.0;
    }
};
// As a screen shows them: what is judged, what this very way shows where nobody ever walked, and the truth, of the moment
// and of kLeftWithin pictures ago.
struct Pictures {
    gh::Image seen, empty, now, before;
};
struct Judged {
    Sums left, on, elsewhere;
    double along = 0.0, whole = 0.0;
};

void judge(const Walk& walk, std::size_t moment, const Pictures& pictures, Judged& judged) {
    for (std::size_t i = 0; i < pictures.now.pixels.size(); ++i) {
        bool was = false;
        for (std::size_t back = 1; back <= kLeftWithin; ++back)
            was = was || walk.moments[moment - back].is_guard[i];
        const bool is = walk.moments[moment].is_guard[i];
        const glm::dvec3 off(pictures.seen.pixels[i] - pictures.now.pixels[i]);
        Sums& sums = is ? judged.on : was ? judged.left : judged.elsewhere;
        sums.squares += glm::dot(off, off) / 3.0;
        sums.pixels += 1.0;
        if (is || !walk.moments[moment - kLeftWithin].is_guard[i]) continue;
        const glm::dvec3 step(pictures.before.pixels[i] - pictures.now.pixels[i]);
        judged.along += glm::dot(glm::dvec3(pictures.seen.pixels[i] - pictures.empty.pixels[i]), step);
        judged.whole += glm::dot(step, step);
    }
}

Walk walk_by(const View& view, int width, int height, const gh::Jobs& jobs) {
    Walk walk{view, width, height, jobs, {}, {}};
    gh::world::State away = view.studio.snapshot.state;
    away.guards[0].position.y -= kAway;
    walk.empty = view.studio.stage->commit(away, jobs);
    for (int frame = 0; frame < kFrames; ++frame) {
        walk.moments.push_back({walked(walk, frame), {}});
        walk.moments.back().is_guard = frame == 0
                                           ? std::vector<bool>(static_cast<std::size_t>(width * height))
                                           : moving_pixels(walk, walk.moments.size() - 1);
    }
    return walk;
}

}  // namespace

WalkingGuard::WalkingGuard(const View& view, int width, int height, const gh::Jobs& jobs)
    : walk_(std::make_unique<Walk>(walk_by(view, width, height, jobs))) {}
WalkingGuard::~WalkingGuard() = default;

const gh::Image& WalkingGuard::true_picture_at(std::size_t moment, const std::string& truth) {
    gh::Image& picture = truths_[{truth, moment}];
    if (picture.pixels.empty()) picture = true_picture(*walk_, moment, truth);
    return picture;
}

namespace {

// The mean of what a screen shows of the last pictures of an empty place.
gh::Image empty_place(const Walk& walk, const Contestant& contestant, float exposure) {
    gh::render::Film film(walk.width, walk.height);
    gh::Image mean(walk.width, walk.height);
    const Run make = contestant.begin();
    constexpr std::uint32_t kMeanOf = 12;
    for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
        make({.scene = {*walk.view.studio.level, walk.empty, walk.view.studio.prepared, &walk.empty},
              .camera = walk.view.camera,
              .frame = frame,
              .jobs = walk.jobs},
             film);
        if (frame + kMeanOf < kFrames) continue;
        const gh::Image picture = shown(film.radiance, exposure, walk.jobs);
        for (std::size_t i = 0; i < mean.pixels.size(); ++i)
            mean.pixels[i] += picture.pixels[i] / static_cast<float>(kMeanOf);
    }
    return mean;
}

}  // namespace

std::vector<Finding> WalkingGuard::judge(const Contestant& contestant) {
    const Walk& walk = *walk_;
    gh::render::Film film(walk.width, walk.height);
    const Run make = contestant.begin();
    Judged judged;
    float exposure = 1.0f;
    Pictures pictures;
    for (std::size_t frame = 0; frame < kFrames; ++frame) {
        make({.scene = walk.scene(frame),
              .camera = walk.view.camera,
              .frame = static_cast<std::uint32_t>(frame),
              .jobs = walk.jobs},
             film);
        if (frame < kFirstJudged || (frame - kFirstJudged) % kBetween != 0) continue;
        if (frame == kFirstJudged) {
            exposure = gh::filter::metered_exposure(film.radiance);
            pictures.empty = empty_place(walk, contestant, exposure);
        }
        const auto true_at = [&](std::size_t moment) {
            return shown(true_picture_at(moment, contestant.truth), exposure, walk.jobs);
        };
        pictures.seen = shown(film.radiance, exposure, walk.jobs);
        pictures.now = true_at(frame);
        pictures.before = true_at(frame - kLeftWithin);
        speed_error::judge(walk, frame, pictures, judged);
    }
    if (!(judged.whole > 0.0) || !(judged.on.pixels > 0.0)) return {};
    Finding finding{.table = kWalkingGuardTable,
                    .view = walk.view.name,
                    .name = contestant.family,
                    .key = walk.view.key,
                    .values = {}};
    finding.values.emplace_back("where he was %", judged.left.rms_percent());
    finding.values.emplace_back("on him %", judged.on.rms_percent());
    finding.values.emplace_back("elsewhere %", judged.elsewhere.rms_percent());
    finding.values.emplace_back("ghost %", 100.0 * judged.along / judged.whole);
    return {finding};
}

}  // namespace speed_error

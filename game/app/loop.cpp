#include "app/loop.h"

#include "app/quality.h"
#include "present/hud.h"
#include "present/profiler.h"
#include "sim/rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iostream>

namespace gh::app {

namespace {

constexpr int kMostTicksAPicture = 6;
constexpr float kRadiansADegree = 0.017453293f;
constexpr const char* kPhaseNames[sim::kPhaseCount] = {"decide", "doors",  "motion",   "stones",
                                                       "noise",  "commit", "perceive", "judge"};

// The clock for the phases of a tick.
class PhaseClock final : public sim::PhaseObserver {
  public:
    explicit PhaseClock(Stopwatch& watch) : watch_(watch) { watch_.begin_round(); }
    void begin(sim::Phase phase) override { watch_.enter(kPhaseNames[static_cast<std::size_t>(phase)]); }
    void end() override { watch_.end_round(); }

  private:
    Stopwatch& watch_;
};

present::ProfileModel profile_model(const Stopwatch& frames, const Stopwatch& ticks,
                                    const render::FrameStats& stats) {
    present::ProfileModel model;
    model.frame_ms = frames.round_ms();
    model.tick_ms = ticks.round_ms();
    model.frame_rooms = frames.rooms();
    model.tick_rooms = ticks.rooms();
    model.frame_history_ms = frames.history_ms();
    model.rays = {{"primary", stats.primary_rays},     {"lit pixels", stats.lit_pixels},
                  {"reflected", stats.reflected_rays}, {"refracted", stats.refracted_rays},
                  {"shadow", stats.shadow_rays},       {"shadow in glass", stats.glass_shadow_rays},
                  {"ambient", stats.ambient_rays}};
    return model;
}

}  // namespace

Loop::Loop(Session& session, present::Window& window, std::string level_name,
           std::optional<std::vector<input::Command>> watched)
    : session_(session),
      window_(window),
      level_name_(std::move(level_name)),
      watched_(std::move(watched)),
      devices_(window.device()),
      menu_(devices_, settings_path()) {
    for (const std::string& complaint : menu_.complaints()) say(complaint);
    auto sound = Sound::open_device();
    if (sound) {
        sound_ = *std::move(sound);
        sound_->set_volume(menu_.settings().volume);
    } else {
        std::cerr << "glasshouse: " << sound.error().sentence << '\n';
    }
    const world::PlayerState& player = session_.simulation->state().player;
    devices_.look_along(player.yaw, player.pitch);
}

Loop::~Loop() = default;

void Loop::begin_recording(const std::filesystem::path& path) {
    if (is_watching()) return;
    auto recorder = Recorder::start(path, recording_header(level_name_, *session_.level, seed_));
    if (!recorder) return lose_recording(recorder.error());
    recorder_ = *std::move(recorder);
}

void Loop::finish_recording() {
    if (!recorder_) return;
    if (auto finished = recorder_->finish(); !finished) return lose_recording(finished.error());
    std::cerr << "recorded in " << recorder_->path().string() << '\n';
    recorder_.reset();
}

void Loop::lose_recording(const Error& why) {
    unrecorded_ = why;
    recorder_.reset();
    say("this run is not recorded: " + why.sentence);
}

void Loop::say(const std::string& sentence) {
    std::cerr << "glasshouse: " << sentence << '\n';
    hud_.say(sentence);
}

bool Loop::run(const std::filesystem::path& record_to) {
    const bool is_asked_for = !record_to.empty();
    begin_recording(is_asked_for ? record_to : fresh_recording_path(level_name_));
    if (unrecorded_ && is_asked_for) return false;
    window_.capture_cursor(true);
    last_time_ = Clock::now();
    while (!wants_to_quit_ && !window_.wants_to_close()) {
        window_.poll_events();
        handle_keys();
        advance_time();
        draw();
    }
    if (is_paused_) keep_settings();
    finish_recording();
    return !(unrecorded_ && is_asked_for);
}

void Loop::handle_keys() {
    const input::ProgramKeys keys = devices_.program_keys(menu_.keys());
    if (keys.menu && !(is_paused_ && menu_.go_back())) set_paused(!is_paused_);
    if (menu_.asks_for_key()) return;
    if (keys.profiler) shows_profiler_ = !shows_profiler_;
    if (keys.next_plane) show_next_plane();
    if (keys.fullscreen) window_.toggle_fullscreen();
    // A player who has gone to another window is not playing; losing the focus has already freed the cursor.
    if (!is_paused_ && !window_.is_cursor_captured() && !is_watching()) set_paused(true);
}

// Planes are what path tracing leaves, whatever traces the picture itself.
void Loop::show_next_plane() {
    const bool traced = traced_.has_value() || plane_ != PlaneView::Picture;
    plane_ = next_of(plane_);
    if (traced != (traced_.has_value() || plane_ != PlaneView::Picture)) view_.forget();
}

void Loop::set_paused(bool is_paused) {
    is_paused_ = is_paused;
    window_.capture_cursor(!is_paused);
    if (sound_) sound_->set_paused(is_paused);
    if (is_paused) return menu_.open();
    devices_.begin_listening();
    keep_settings();
}

void Loop::keep_settings() {
    const auto saved = menu_.save();
    if (!saved) say(saved.error().sentence);
}

void Loop::advance_time() {
    const Clock::time_point now = Clock::now();
    const float passed = std::chrono::duration<float>(now - last_time_).count();
    last_time_ = now;
    picture_seconds_ += passed;
    if (is_paused_) {
        owed_seconds_ = 0.0f;
        return;
    }
    owed_seconds_ = std::min(owed_seconds_ + passed, kMostTicksAPicture * world::kTickSeconds);
    while (owed_seconds_ >= world::kTickSeconds && !wants_to_quit_) {
        owed_seconds_ -= world::kTickSeconds;
        run_tick();
    }
}

input::Command Loop::next_command() {
    if (is_watching()) return (*watched_)[watched_next_++];
    const present::MenuSettings& chosen = menu_.settings();
    const input::DeviceSettings settings{.mouse_sensitivity = chosen.mouse_sensitivity,
                                         .inverts_y = chosen.inverts_y,
                                         .toggles_crouch = chosen.toggles_crouch};
    return devices_.sample(settings, menu_.keys());
}

void Loop::run_tick() {
    if (is_watching() && watched_next_ >= watched_->size()) {
        wants_to_quit_ = true;
        return;
    }
    const input::Command command = next_command();
    const bool goes_back = sim::wants_checkpoint(session_.simulation->state(), command);
    PhaseClock clock(tick_watch_);
    session_.simulation->step(command, &clock);
    const std::shared_ptr<const world::Snapshot> now = session_.simulation->snapshot();
    if (goes_back) devices_.look_along(now->state.player.yaw, now->state.player.pitch);
    if (recorder_) {
        if (auto noted = recorder_->note_tick(command, now->state); !noted) lose_recording(noted.error());
    }
    hud_.note_tick(*session_.level, *now);
    if (sound_) sound_->note_tick(*session_.level, *now);
}

void Loop::expose(const render::SceneView& scene, const render::Camera& camera, const PictureShape& shape) {
    const Quality quality = quality_of(menu_.settings().quality);
    if (traced_ || plane_ != PlaneView::Picture) {
        const render::PathSettings path = following(quality.path, traced_.value_or(render::LightPaths::All));
        view_.expose_next(scene, camera, path, frame_, shape, *session_.jobs);
    } else {
        view_.expose_next(scene, camera, quality.whitted, frame_, shape, *session_.jobs);
    }
}

void Loop::draw() {
    const Quality quality = quality_of(menu_.settings().quality);
    const bool is_path = traced_ || plane_ != PlaneView::Picture;
    resolution_.bound(quality.fewest_shown, quality.most_lit, is_path ? kMostPathStep : kMostStep);
    const PictureShape shape = resolution_.shape_for(window_.framebuffer_size());
    const std::shared_ptr<const world::Snapshot> now = session_.simulation->snapshot();
    const render::Camera camera =
        player_camera(now->state.player, menu_.settings().field_of_view * kRadiansADegree);
    frame_watch_.begin_round();
    if (shape.lit.x > 0) {
        frame_watch_.enter("render");
        const Clock::time_point start = Clock::now();
        if (!seen_before_ || seen_before_->state.tick > now->state.tick) view_.forget();
        const render::SceneView scene{*session_.level, *now, *session_.prepared, seen_before_.get()};
        expose(scene, camera, shape);
        seen_before_ = now;
        frame_watch_.enter("filter");
        view_.develop(frame_, picture_seconds_, menu_.settings().brightness, *session_.jobs);
        if (plane_ != PlaneView::Picture) view_.develop_plane(plane_, *session_.jobs);
        const float ticks_ms = tick_watch_.round_ms() * menu_.settings().frames_a_second / 60.0f;
        resolution_.note_frame(milliseconds_since(start) + ticks_ms,
                               1000.0f / menu_.settings().frames_a_second, window_.framebuffer_size());
        picture_seconds_ = 0.0f;
        ++frame_;
    }
    frame_watch_.enter("present");
    window_.begin_frame(view_.picture());
    draw_ui(camera);
    window_.end_frame();
    frame_watch_.end_round();
}

void Loop::draw_ui(const render::Camera& camera) {
    const std::shared_ptr<const world::Snapshot> now = session_.simulation->snapshot();
    const glm::vec2 shown = window_.picture_size();
    const present::MenuSettings& chosen = menu_.settings();
    const HudChoices choices{.captions = chosen.shows_captions,
                             .hints = chosen.shows_hints && !is_watching(),
                             .keys = menu_.words()};
    if (!is_paused_)
        present::draw_hud(window_, hud_.model(*session_.level, *now, camera, shown.x / shown.y, choices));
    if (plane_ != PlaneView::Picture)
        present::draw_title(window_, menu_.words().one(input::Action::Planes) + ": " + words_of(plane_));
    if (shows_profiler_) {
        present::ProfileModel model = profile_model(frame_watch_, tick_watch_, view_.film().stats);
        const glm::ivec2 window_size = window_.framebuffer_size();
        model.machine = fmt::format("{} threads, {}, {}x{} lit -> {}x{} -> {}x{}", session_.jobs->threads(),
                                    rc::isa_name(rc::active_isa()), view_.film().radiance.width,
                                    view_.film().radiance.height, view_.picture().width,
                                    view_.picture().height, window_size.x, window_size.y);
        present::draw_profiler(model);
    }
    if (is_paused_) {
        obey(menu_.draw(recording_note()));
        if (sound_) sound_->set_volume(menu_.settings().volume);
    }
}

std::string Loop::recording_note() const {
    if (recorder_) return "this run is recorded in " + recorder_->path().string();
    return unrecorded_ ? "this run is not recorded: " + unrecorded_->sentence : std::string();
}

void Loop::obey(present::MenuAction action) {
    switch (action) {
        case present::MenuAction::Resume:
            set_paused(false);
            return;
        case present::MenuAction::Quit:
            wants_to_quit_ = true;
            return;
        case present::MenuAction::RestartLevel:
            return start_again();
        default:
            return;  // it concerned the menu alone
    }
}

// A new run, and a recording of its own.
void Loop::start_again() {
    finish_recording();
    watched_next_ = 0;
    session_.restart(seed_);
    const world::PlayerState& player = session_.simulation->state().player;
    devices_.look_along(player.yaw, player.pitch);
    begin_recording(fresh_recording_path(level_name_));
    set_paused(false);
}

}  // namespace gh::app

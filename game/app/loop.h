// app/loop.h - the game in its window: the only place where time passes by the clock.
//
// Sixty ticks for every second that passes, at most a few a picture: under overload the game slows, it never skips.
// Commands come from the devices, or from a recording that is watched.
#pragma once

#include "app/hud_model.h"
#include "app/pause_menu.h"
#include "app/profile.h"
#include "app/recording.h"
#include "app/resolution.h"
#include "app/session.h"
#include "app/sound.h"
#include "app/view.h"
#include "input/devices.h"
#include "present/window.h"

#include <optional>
#include <vector>

namespace gh::app {

class Loop {
  public:
    // Borrows the session and the window. `watched`: commands to play instead of the devices', then the window closes.
    Loop(Session& session, present::Window& window, std::string level_name,
         std::optional<std::vector<input::Command>> watched = std::nullopt);
    ~Loop();

    // Pictures by path tracing from now on.
    void trace_paths(render::LightPaths lights) { traced_ = lights; }
    // Instead of what was saved.
    void use_quality(present::QualityName quality) { menu_.settings().quality = quality; }
    // Until the player quits; recorded in `record_to`, or in a file of a fresh name if that is empty. A run that can not be
    // recorded any more is played all the same, and a sentence says so. False: `record_to` was asked for, and is not there.
    [[nodiscard]] bool run(const std::filesystem::path& record_to);

  private:
    void handle_keys();
    void set_paused(bool is_paused);
    void show_next_plane();
    void advance_time();
    void run_tick();
    void draw();
    void expose(const render::SceneView& scene, const render::Camera& camera, const PictureShape& shape);
    void draw_ui(const render::Camera& camera);
    void obey(present::MenuAction action);
    void start_again();
    void keep_settings();
    void begin_recording(const std::filesystem::path& path);
    void finish_recording();
    void lose_recording(const Error& why);
    [[nodiscard]] std::string recording_note() const;
    void say(const std::string& sentence);
    [[nodiscard]] input::Command next_command();
    [[nodiscard]] bool is_watching() const { return watched_.has_value(); }

    Session& session_;
    present::Window& window_;
    std::string level_name_;
    std::optional<std::vector<input::Command>> watched_;
    std::size_t watched_next_ = 0;

    input::Devices devices_;
    PauseMenu menu_;
    std::optional<Recorder> recorder_;
    std::optional<Error> unrecorded_;  // why this run, or one before it, is not
    std::unique_ptr<Sound> sound_;
    HudReader hud_;
    View view_{8, 8};
    Resolution resolution_;
    Stopwatch frame_watch_;
    Stopwatch tick_watch_;

    Clock::time_point last_time_ = Clock::now();
    float owed_seconds_ = 0.0f;                           // of simulation
    float picture_seconds_ = 0.0f;                        // since the last picture
    std::shared_ptr<const world::Snapshot> seen_before_;  // in the last picture
    std::uint32_t frame_ = 0;
    std::uint32_t seed_ = 0;
    PlaneView plane_ = PlaneView::Picture;
    std::optional<render::LightPaths> traced_;  // none: Whitted
    bool is_paused_ = false;
    bool shows_profiler_ = false;
    bool wants_to_quit_ = false;
};

}  // namespace gh::app

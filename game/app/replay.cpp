// glasshouse replay: the same commands again. Verifies them, shows them, or turns them into frames and sound.
#include "app/assets.h"
#include "app/commands.h"
#include "app/film_strip.h"
#include "app/loop.h"
#include "app/quality.h"
#include "base/progress.h"
#include "record/wav.h"
#include "world/state_hash.h"

#include <fmt/format.h>

#include <iostream>
#include <optional>

namespace gh::app {

namespace {

// What a headless replay leaves behind, tick by tick.
class Output {
  public:
    static Result<Output> open(const ReplayOptions& options) {
        auto sky = sky_named(options.renderer);
        if (!sky) return sky.error();
        Output output(options, *std::move(sky));
        if (options.audio.empty()) return output;
        auto sound = Sound::open_loopback();
        if (!sound) return sound.error();
        output.sound_ = *std::move(sound);
        auto wav = record::WavWriter::open(options.audio);
        if (!wav) return wav.error();
        output.wav_ = *std::move(wav);
        return output;
    }

    Result<void> note_tick(Session& session, std::size_t tick) {
        const std::shared_ptr<const world::Snapshot> now = session.simulation->snapshot();
        if (sound_) {
            sound_->note_tick(*session.level, *now);
            if (auto written = wav_->write(sound_->rendered_tick()); !written) return written;
        }
        const std::size_t every = static_cast<std::size_t>(options_.every);
        if (options_.frames.empty() || tick % every != 0) return {};
        session.prepare_pictures();
        return film_.shoot({*session.level, *now, *session.prepared}, tick, *session.jobs);
    }

    Result<void> close() { return wav_ ? wav_->close() : Result<void>(); }
    [[nodiscard]] std::uint32_t pictures() const { return film_.pictures(); }

  private:
    Output(const ReplayOptions& options, std::optional<render::Environment> sky)
        : options_(options), film_(options, std::move(sky)) {}

    ReplayOptions options_;
    std::unique_ptr<Sound> sound_;
    std::optional<record::WavWriter> wav_;
    FilmStrip film_;
};

// Compares one tick with the recording; a sentence where they part.
std::optional<std::string> divergence(const input::Replay& replay, std::size_t tick,
                                      const world::StateHash& hash) {
    if (hash.total == replay.state_hashes[tick]) return std::nullopt;
    const std::string room(replay.first_difference(tick, hash.part).value_or("state"));
    return fmt::format("diverged at tick {} in {}: hash {:016x}, recorded {:016x}", tick, room, hash.total,
                       replay.state_hashes[tick]);
}

// How it ended, and how often the player was caught on the way there.
std::string outcome_words(const world::RulesState& rules) {
    const bool is_won = rules.outcome == world::Outcome::Won;
    std::string end = is_won                                    ? "won"
                            : rules.outcome == world::Outcome::Caught ? "caught"
                                                                      : "still playing";
    if (rules.times_caught == 0) return end;
    return fmt::format("{}, caught {} {}", end, rules.times_caught,
                       rules.times_caught == 1 ? "time" : "times");
}

int run_headless(const ReplayOptions& options, const input::Replay& replay, Session& session) {
    auto output = Output::open(options);
    if (!output) return refuse(output.error());
    Progress progress("replaying", replay.ticks());
    std::uint64_t last_hash = 0;
    for (std::size_t tick = 0; tick < replay.ticks(); ++tick) {
        session.simulation->step(replay.commands[tick]);
        const world::StateHash hash = world::state_hash(session.simulation->state());
        last_hash = hash.total;
        if (options.verifies) {
            if (const auto where = divergence(replay, tick, hash)) {
                progress.end_line();
                std::cerr << "glasshouse: " << options.file.string() << ": " << *where << '\n';
                return kExitDiverged;
            }
        }
        if (auto noted = output->note_tick(session, tick); !noted) {
            progress.end_line();
            return refuse(noted.error());
        }
        progress.show(tick + 1);
    }
    if (auto closed = output->close(); !closed) return refuse(closed.error());
    if (options.verifies && replay.is_cut_short) {
        return refuse({fmt::format("{}: is cut short; the {} ticks that are whole are true",
                                   options.file.string(), replay.ticks())});
    }
    if (options.verifies) {
        std::cout << fmt::format("verified {} ticks, hash {:016x}\n", replay.ticks(), last_hash);
    } else {
        const world::State& state = session.simulation->state();
        std::cout << fmt::format("{}: {} ticks ({:.1f} s), {}, {} of {} lenses, {} pictures, hash {:016x}\n",
                                 options.file.string(), replay.ticks(),
                                 static_cast<double>(replay.ticks()) / world::kTicksPerSecond,
                                 outcome_words(state.rules), int{state.rules.lenses_taken_count},
                                 session.level->lenses.size(), output->pictures(), last_hash);
    }
    return replay.is_cut_short ? kExitUnusable : kExitFine;
}

int run_in_window(const ReplayOptions& options, const input::Replay& replay, Session& session) {
    auto window = present::Window::open({.title = "Glasshouse: " + options.file.filename().string(),
                                         .width = options.size.width,
                                         .height = options.size.height});
    if (!window) return refuse(window.error());
    session.prepare_pictures();
    Loop loop(session, *window, replay.header.level_name, replay.commands);
    if (const auto lights = light_paths(options.renderer.renderer)) loop.trace_paths(*lights);
    if (const auto quality = quality_named(options.quality)) loop.use_quality(*quality);
    return loop.run({}) ? kExitFine : kExitUnusable;
}

}  // namespace

int replay(const ReplayOptions& options) {
    const auto replay = input::read_replay(options.file);
    if (!replay) return refuse(replay.error());
    const auto level_path = resolve_level(replay->header.level_name);
    if (!level_path) return refuse({options.file.string() + ": its " + level_path.error().sentence});
    auto session =
        open_session(*level_path, static_cast<std::uint32_t>(replay->header.seed), options.machine);
    if (!session) return refuse(session.error());
    const input::ReplayHeader here = recording_header(replay->header.level_name, *session->level,
                                                      static_cast<std::uint32_t>(replay->header.seed));
    if (const auto fits = input::check_fits(replay->header, here, options.file.string()); !fits)
        return refuse(fits.error());
    if (replay->is_cut_short && replay->ticks() == 0)
        return refuse({options.file.string() + ": is cut short in its first second; there is nothing to play"});
    if (replay->is_cut_short && !options.verifies) {
        std::cerr << "glasshouse: " << options.file.string() << ": is cut short; playing the "
                  << replay->ticks() << " ticks that are whole\n";
    }
    return options.opens_window ? run_in_window(options, *replay, *session)
                                : run_headless(options, *replay, *session);
}

}  // namespace gh::app

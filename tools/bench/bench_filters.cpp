// filter_bench - core-milliseconds of every filter at a picture's size, on one core, and how much error it leaves.
//
//   filter_bench --width 640 --height 360 --rounds 15
//
// The scene is the tests' synthetic room with one sample a pixel, so that the truth is known.
#include "figures.h"
#include "filter/albedo.h"
#include "filter/denoiser.h"
#include "filter/enlarge.h"
#include "filter/glare.h"
#include "filter/isa.h"
#include "filter/synthetic.h"
#include "filter/temporal_upscale.h"
#include "filter/tone_map.h"
#include "filter/variance.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

namespace {

namespace filter = gh::filter;

struct Options {
    int width = 640, height = 360;
    int window_width = 1280, window_height = 720;
    int rounds = 15;
    std::string isa;
};

Options read_options(int argc, char** argv) {
    Options options;
    CLI::App app("What filters cost, and what they leave of the noise.");
    app.add_option("--width", options.width, "of the rendered picture")->check(CLI::Range(16, 8192));
    app.add_option("--height", options.height, "of the rendered picture")->check(CLI::Range(16, 8192));
    app.add_option("--window-width", options.window_width, "of the upscaled picture")
        ->check(CLI::Range(16, 8192));
    app.add_option("--window-height", options.window_height, "of the upscaled picture")
        ->check(CLI::Range(16, 8192));
    app.add_option("--rounds", options.rounds, "samples; medians are over them")->check(CLI::Range(3, 1000));
    app.add_option("--isa", options.isa, "one of those listed at the start");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::exit(app.exit(error) == 0 ? 0 : 2);
    }
    return options;
}

std::uint64_t answer_of(const filter::Plane& plane) {
    std::uint64_t hash = 1469598103934665603u;
    for (int y = 0; y < plane.height(); ++y) {
        for (int x = 0; x < plane.width(); ++x) {
            std::uint32_t bits;
            std::memcpy(&bits, &plane.at(x, y), sizeof(bits));
            hash = (hash ^ bits) * 1099511628211u;
        }
    }
    return hash;
}

// What the stages hand to each other, after a few frames.
struct Bench {
    Options options;
    gh::Jobs jobs{1};
    std::vector<gh::test::Frame> frames;

    explicit Bench(const Options& chosen) : options(chosen) {
        gh::test::Room room;
        for (std::uint32_t i = 0; i < 12; ++i) {
            frames.push_back(gh::test::render(room, options.width, options.height, i));
            room.eye.x += 0.01f;  // a walking eye: nothing falls on whole pixels
            room.yaw += 0.002f;
        }
    }

    void row(const char* name, const std::function<void(int)>& work, const filter::Plane& answer) const {
        const bench::Samples samples = bench::measure(bench::cpu_ms, options.rounds, 1, work);
        bench::print_row(name, samples, answer_of(answer));
    }
};

void bench_stages(const Bench& b) {
    const gh::test::Frame &last = b.frames[10], &now = b.frames[11];
    filter::Plane3 mended, demodulated;
    b.row(
        "mend", [&](int) { filter::mend(now.noisy.indirect, {}, b.jobs, mended); }, mended.x);
    b.row(
        "demodulate", [&](int) { filter::demodulate(mended, now.surfaces.albedo, b.jobs, demodulated); },
        demodulated.x);
    filter::Guides guides;
    b.row(
        "guides", [&](int) { filter::make_guides(now.surfaces, b.jobs, guides); }, guides.slope_x);
    filter::SeenSurfaces seen{last.surfaces.lens, {}, last.surfaces.part};
    filter::make_guides(last.surfaces, b.jobs, seen.guides);
    filter::Taps taps;
    const auto reproject = [&](filter::Motion motion) {
        filter::reproject(now.surfaces, guides, seen, motion, b.jobs, taps);
    };
    b.row(
        "reproject reflections", [&](int) { reproject(filter::Motion::OfReflection); }, taps.weight[0]);
    b.row(
        "reproject", [&](int) { reproject(filter::Motion::OfSurface); }, taps.weight[0]);

    filter::Accumulated before, mean;
    filter::accumulate(last.noisy.indirect, {}, {taps, {}}, {}, b.jobs, before);
    b.row(
        "accumulate a signal",
        [&](int) {
            filter::accumulate(demodulated, {}, {taps, before}, {}, b.jobs, mean);
        },
        mean.light.x);
    filter::Plane sums[2];
    b.row(
        "settle a signal", [&](int) { filter::settle({}, b.jobs, mean, sums); }, mean.light.x);
    filter::Plane variance;
    b.row(
        "variance, short history", [&](int) { filter::estimate_variance(mean, b.jobs, variance); }, variance);
    mean.length = filter::Plane(b.options.width, b.options.height, 8.0f);
    b.row(
        "variance, long history", [&](int) { filter::estimate_variance(mean, b.jobs, variance); }, variance);

    const filter::SignalView signal{&mean.light, &variance};
    filter::Signal scratch[2];
    for (const int radius : {1, 2}) {
        const filter::AtrousSettings settings{.levels = 5, .radius = radius};
        const std::string name = std::string("a-trous ") + (radius == 1 ? "3x3" : "5x5") + ", 5 levels";
        b.row(
            name.c_str(), [&](int) { filter::atrous(guides, signal, settings, b.jobs, scratch); },
            scratch[0].light.x);
    }
    filter::Plane3 out;
    b.row(
        "remodulate",
        [&](int) {
            filter::remodulate({&mean.light, &mean.light, &mean.light, &now.noisy.clean}, now.surfaces.albedo,
                               b.jobs, out);
        },
        out.x);
}

void bench_enlarging(const Bench& b) {
    const gh::test::Frame& now = b.frames[11];
    const gh::test::Frame window = gh::test::render({}, b.options.window_width, b.options.window_height, 0);
    const filter::Plane3 small = gh::test::total(now.truth);
    filter::Plane3 out(b.options.window_width, b.options.window_height);
    b.row(
        "enlarge to the window, cubic", [&](int) { filter::enlarge(small, b.jobs, out); }, out.x);
    filter::Guides guides, large;
    filter::make_guides(now.surfaces, b.jobs, guides);
    filter::make_guides(window.surfaces, b.jobs, large);
    b.row(
        "enlarge to the window, by its surfaces",
        [&](int) { filter::joint_enlarge(small, guides, large, b.jobs, out); }, out.x);
}

// The picture as the window gets it: lit in every fourth pixel, added up over frames, and made into what a screen takes.
void bench_showing(const Bench& b) {
    constexpr int kStep = 2;
    const gh::test::Frame now = gh::test::render({}, kStep * b.options.width, kStep * b.options.height, 11);
    const filter::Plane3 truth = gh::test::total(now.truth);
    gh::Image small(b.options.width, b.options.height), large;
    std::vector<std::uint32_t> part;
    std::vector<glm::vec3> position, normal, albedo, clean;
    for (int y = 0; y < truth.height(); ++y) {
        for (int x = 0; x < truth.width(); ++x) {
            part.push_back(now.surfaces.part.at(x, y));
            position.push_back(now.surfaces.position.get(x, y));
            normal.push_back(now.surfaces.normal.get(x, y));
            albedo.push_back(now.surfaces.albedo.get(x, y) + 0.15f);
            clean.emplace_back(0.0f);
            if (x % kStep == 0 && y % kStep == 0) small.at(x / kStep, y / kStep) = truth.get(x, y);
        }
    }
    const filter::Guide guide{.width = truth.width(),
                              .height = truth.height(),
                              .lens = now.surfaces.lens,
                              .part = part,
                              .position = position,
                              .previous = position,
                              .geometric = normal,
                              .albedo = albedo,
                              .clean = clean};
    filter::TemporalUpscaler upscaler;
    filter::Plane3 planes;
    const auto answer = [&]() -> const filter::Plane& {
        filter::planes_from(large, planes);
        return planes.x;
    };
    const auto add = [&](int) { upscaler.add({small, kStep, {0, 0}, guide}, b.jobs, large); };
    add(0);
    b.row("add up to the window", add, answer());
    filter::Glare glare;
    gh::Image veiled;
    b.row(
        "glare in the window", [&](int) { glare.veil(large, {}, b.jobs, veiled); }, answer());
    gh::Image8 bytes;
    b.row(
        "tone map the window",
        [&](int round) { filter::tone_map(large, 1.0f, static_cast<std::uint32_t>(round), b.jobs, bytes); },
        answer());
}

// There and back again, so that history always fits.
std::size_t walked(std::size_t round) {
    constexpr std::size_t kThere = 11;
    const std::size_t at = round % (2 * kThere);
    return at <= kThere ? at : 2 * kThere - at;
}

void bench_denoiser(const Bench& b, const char* name, bool has_indirect, bool has_specular) {
    filter::Denoiser denoiser;
    filter::Plane3 out;
    std::vector<gh::test::Frame> frames = b.frames;
    for (gh::test::Frame& frame : frames) {
        if (!has_indirect) frame.noisy.indirect = {};
        if (!has_specular) frame.noisy.specular = {};
    }
    std::size_t next = 0;
    b.row(
        name,
        [&](int) {
            const gh::test::Frame& frame = frames[walked(next++)];
            denoiser.denoise(frame.surfaces, frame.noisy, {}, b.jobs, out);
        },
        out.x);
}

// As the window shows it where every pixel is lit: paths asked again say that no light has changed; denoised, added up, and
// enlarged to the window.
void bench_whole(const Bench& b, const char* name, bool halves) {
    filter::Denoiser denoiser;
    filter::Plane3 small, out(b.options.window_width, b.options.window_height);
    std::vector<gh::test::Frame> frames = b.frames;
    for (gh::test::Frame& frame : frames)
        frame.noisy.change_then = filter::Plane(b.options.width, b.options.height);
    std::size_t next = 0;
    b.row(
        name,
        [&](int) {
            const gh::test::Frame& frame = frames[walked(next++)];
            denoiser.denoise(frame.surfaces, frame.noisy,
                             {.halves_indirect = halves, .halves_specular = halves, .adds_up = true}, b.jobs,
                             small);
            filter::enlarge(small, b.jobs, out);
        },
        out.x);
}

void report_error(const Bench& b) {
    filter::Denoiser denoiser;
    filter::Plane3 out;
    std::printf("\nrelMSE by frame of a walk       noisy     denoised   gain\n");
    for (std::size_t i = 0; i < b.frames.size(); ++i) {
        denoiser.denoise(b.frames[i].surfaces, b.frames[i].noisy, {}, b.jobs, out);
        const gh::filter::Plane3 truth = gh::test::total(b.frames[i].truth);
        const double noisy = gh::test::rel_mse(gh::test::total(b.frames[i].noisy), truth);
        const double left = gh::test::rel_mse(out, truth);
        if (i % 3 == 0 || i == 11) std::printf("%28zu  %8.5f   %8.5f  %5.1f\n", i, noisy, left, noisy / left);
    }
}

int bench_all(int argc, char** argv) {
    const Options options = read_options(argc, argv);
    std::printf("kernels:");
    for (const std::string& name : filter::isa_names()) std::printf(" %s", name.c_str());
    std::printf("\n");
    if (!filter::use_isa(options.isa)) {
        std::fprintf(stderr, "filter_bench: --isa %s: not known here\n", options.isa.c_str());
        return 2;
    }
    const Bench b(options);
    bench::print_head("core-ms a frame");
    bench_stages(b);
    bench_enlarging(b);
    bench_showing(b);
    bench_denoiser(b, "denoise: direct", false, false);
    bench_denoiser(b, "denoise: direct + indirect", true, false);
    bench_denoiser(b, "denoise: direct + indirect + specular", true, true);
    bench_whole(b, "all of it, added up, to the window", false);
    bench_whole(b, "the same, soft light at half the sides", true);
    report_error(b);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return bench_all(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "filter_bench: %s\n", error.what());
        return 2;
    }
}

// app/options.h - the command line, as plain data.
#pragma once

#include "raycore/isa.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>

namespace gh::app {

struct Size {
    int width = 1280;  // pixels
    int height = 720;
};

struct MachineOptions {
    int threads = 0;  // 0: all cores
    std::optional<rc::Isa> isa;
};

// How a still or a film is computed.
struct RendererOptions {
    std::string renderer = "whitted";
    std::string sampler = "sobol";  // path: iid, jittered, sobol, bluenoise
    std::filesystem::path sky;      // path: a picture of all directions; empty: the suns' own sky
    std::uint32_t seed = 0;
    int max_depth = 24;
    // path: most that one bounce or more brings by one path, in multiples of what shows as white; 0: no limit.
    float clamp = 2.0f;
    float least_indirect_roughness = 0.3f;  // path: of gloss, once light was scattered
    bool is_unbiased = false;               // path: neither
    bool is_denoised = false;
    bool bends_light = true;  // path: lamps' light through solid glass and off mirrors
    std::string filter;       // path, cook: box, tent, gaussian; empty: path's box, cook's gaussian
    float aperture = 0.0f;    // path, cook: radius of the lens, metres
    float focus = 3.0f;       // path, cook: metres to what is sharp
    float shutter = 0.0f;     // path, cook, of films: how long it is open, in pictures
};

struct PlayOptions {
    std::string level = "foyer";
    std::filesystem::path record;  // empty: a name made from the date
    Size size;
    std::string renderer = "whitted";
    std::string quality;  // low, medium, high or ultra; empty: as in the menu
    bool is_fullscreen = false;
    MachineOptions machine;
};

struct ReplayOptions {
    std::filesystem::path file;
    bool verifies = false;
    bool opens_window = false;
    std::string quality;           // of the window, as in PlayOptions
    std::filesystem::path frames;  // folder; empty: no pictures
    int every = 1;                 // ticks a picture
    Size size{640, 360};
    int samples_per_pixel = 1;
    RendererOptions renderer;
    bool writes_exr = false;      // otherwise PNG
    std::filesystem::path audio;  // empty: no sound
    MachineOptions machine;
};

struct RenderOptions {
    std::string scene;
    std::filesystem::path output;
    std::string
        camera;  // a viewpoint's name, or x,y,z,yaw,pitch,fov in metres and degrees; empty: the first, or the spawn
    Size size;
    RendererOptions renderer;
    int samples_per_pixel = 16;
    bool is_adaptive = false;
    MachineOptions machine;
};

struct InspectOptions {
    std::string file;
};

using Options = std::variant<PlayOptions, ReplayOptions, RenderOptions, InspectOptions>;

// Either options, or the exit code the program should leave with (0 after --help, 2 after a sentence on stderr).
[[nodiscard]] std::variant<Options, int> parse_options(int argc, char** argv);

}  // namespace gh::app

#include "render/frame_light.h"

namespace gh::render {

namespace {

bool is_part_lit(const SceneView& view, std::size_t part) {
    const std::uint32_t group = view.level.parts[part].lamp_group;
    if (group != world::kNoIndex) return view.snapshot.state.group_on[group] != 0;
    const std::uint32_t lamp = view.prepared.parts[part].lamp;
    return lamp == world::kNoIndex || world::is_lamp_on(view.level, view.snapshot.state, lamp);
}

}  // namespace

FrameLight frame_light(const SceneView& view, bool uses_ambient) {
    FrameLight light;
    for (std::size_t i = 0; i < view.level.lamps.size(); ++i) {
        const bool is_on = world::is_lamp_on(view.level, view.snapshot.state, i);
        light.lamp_on.push_back(is_on ? 1 : 0);
        light.reaches.push_back(lamp_reach(view.level.lamps[i]));
        light.lamps.push_back(lamp_numbers(view.level.lamps[i], light.reaches.back()));
        if (is_on && view.level.lamps[i].shape == world::LampShape::Sun)
            light.sun += view.level.lamps[i].intensity;
    }
    for (std::size_t i = 0; i < view.level.parts.size(); ++i)
        light.emission_on.push_back(is_part_lit(view, i) ? 1 : 0);
    if (uses_ambient) {
        std::vector<std::uint8_t> group_on(view.level.lamp_groups.size());
        for (std::size_t i = 0; i < group_on.size(); ++i) group_on[i] = view.snapshot.state.group_on[i];
        light.ambient = AmbientLight(view.prepared.ambient, group_on);
    }
    return light;
}

}  // namespace gh::render

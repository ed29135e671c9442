// Writes a recording that is not true: whole and well-formed, but with one thing changed, for the tests of what
// `glasshouse replay` says to that.
//
//   alter_recording IN OUT yaw TICK     the command of one tick looks half a turn away; the hashes stay
//   alter_recording IN OUT version      as if another version of the simulation had recorded it
#include "input/replay.h"

#include <cstdint>
#include <iostream>
#include <string>
#include <string_view>

namespace {

int refuse(std::string_view sentence) {
    std::cerr << "alter_recording: " << sentence << '\n';
    return 2;
}

}  // namespace

int main(int count, char** words) {
    if (count < 4) return refuse("takes IN OUT yaw TICK, or IN OUT version");
    auto replay = gh::input::read_replay(words[1]);
    if (!replay) return refuse(replay.error().sentence);
    if (const std::string_view what = words[3]; what == "yaw" && count == 5) {
        gh::input::Command& command = replay->commands.at(std::stoul(words[4]));
        command.yaw = static_cast<std::int16_t>(command.yaw ^ INT16_MIN);
    } else if (what == "version") {
        ++replay->header.simulation_version;
    } else {
        return refuse("knows yaw TICK and version");
    }
    auto writer = gh::input::ReplayWriter::create(words[2], replay->header);
    if (!writer) return refuse(writer.error().sentence);
    for (std::size_t tick = 0; tick < replay->ticks(); ++tick) {
        const auto written =
            writer->append(replay->commands[tick], replay->state_hashes[tick], replay->parts_at(tick));
        if (!written) return refuse(written.error().sentence);
    }
    const auto finished = writer->finish();
    return finished ? 0 : refuse(finished.error().sentence);
}

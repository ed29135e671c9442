#include "app/profile.h"

#include <algorithm>

namespace gh::app {

void Stopwatch::begin_round() {
    round_start_ = Clock::now();
    open_ = 0;
    for (Room& room : rooms_) room.ms[rounds_ % kWindow] = 0.0f;
}

void Stopwatch::close_stretch() {
    if (open_ != 0) rooms_[open_ - 1].ms[rounds_ % kWindow] += milliseconds_since(stretch_start_);
}

void Stopwatch::enter(const std::string& room) {
    close_stretch();
    auto found = std::find_if(rooms_.begin(), rooms_.end(), [&](const Room& r) { return r.name == room; });
    if (found == rooms_.end()) {
        rooms_.push_back({room, {}});
        found = rooms_.end() - 1;
    }
    open_ = static_cast<std::size_t>(found - rooms_.begin()) + 1;
    stretch_start_ = Clock::now();
}

void Stopwatch::end_round() {
    close_stretch();
    open_ = 0;
    round_ms_[rounds_ % kWindow] = milliseconds_since(round_start_);
    ++rounds_;
}

float Stopwatch::mean(const std::array<float, kWindow>& ms) const {
    const std::size_t count = std::min(rounds_, kWindow);
    float sum = 0.0f;
    for (std::size_t i = 0; i < count; ++i) sum += ms[i];
    return count == 0 ? 0.0f : sum / static_cast<float>(count);
}

float Stopwatch::round_ms() const {
    return mean(round_ms_);
}

std::vector<present::ProfileRow> Stopwatch::rooms() const {
    std::vector<present::ProfileRow> rows;
    for (const Room& room : rooms_) rows.push_back({room.name, mean(room.ms)});
    return rows;
}

std::vector<float> Stopwatch::history_ms() const {
    std::vector<float> history;
    const std::size_t count = std::min(rounds_, kWindow);
    for (std::size_t i = rounds_ - count; i < rounds_; ++i) history.push_back(round_ms_[i % kWindow]);
    return history;
}

}  // namespace gh::app

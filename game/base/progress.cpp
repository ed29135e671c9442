#include "base/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

namespace gh {

namespace {

constexpr int kBarWidth = 30;
constexpr int kLogStep = 10;  // percent between two lines of a log

}  // namespace

Progress::Progress(std::string label, std::size_t total)
    : Progress(std::move(label), total, stderr, ::isatty(STDERR_FILENO) == 1) {}

Progress::Progress(std::string label, std::size_t total, std::FILE* out, bool is_terminal)
    : label_(std::move(label)), total_(total), out_(out), is_terminal_(is_terminal) {
    show(0);
}

Progress::~Progress() {
    end_line();
}

void Progress::end_line() {
    if (!is_line_open_) return;
    fmt::print(out_, "\n");
    std::fflush(out_);
    is_line_open_ = false;
}

void Progress::show(std::size_t done) {
    const double share =
        total_ == 0 ? 1.0 : static_cast<double>(std::min(done, total_)) / static_cast<double>(total_);
    int percent = static_cast<int>(share * 100.0);
    if (!is_terminal_) percent -= percent % kLogStep;
    if (percent == shown_percent_) return;
    shown_percent_ = percent;

    if (is_terminal_) {
        const auto filled = static_cast<std::size_t>(percent * kBarWidth / 100);
        const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '.');
        fmt::print(out_, "\r{} [{}] {:3} %", label_, bar, percent);
        is_line_open_ = true;
    } else {
        fmt::print(out_, "{}: {} %\n", label_, percent);
    }
    std::fflush(out_);
    if (percent == 100) end_line();
}

}  // namespace gh

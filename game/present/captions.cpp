#include "present/captions.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace gh::present {

namespace {

constexpr float kLeastSeconds = 4.0f;
constexpr float kLettersASecond = 15.0f;  // what subtitles count on
constexpr std::size_t kMostCaptions = 6;

}  // namespace

float seconds_left(const Caption& caption) {
    return std::max(kLeastSeconds, static_cast<float>(caption.text.size()) / kLettersASecond) - caption.age;
}

void Captions::add(Caption caption) {
    // The same again only starts its time anew: a guard's steps, or one stone's way down a stair, must not push everything
    // else out.
    const auto same = std::find_if(captions_.begin(), captions_.end(), [&](const Caption& c) {
        return c.text == caption.text || (!c.subject.empty() && c.subject == caption.subject);
    });
    if (same != captions_.end()) captions_.erase(same);
    captions_.push_back(std::move(caption));
    if (captions_.size() > kMostCaptions) captions_.erase(captions_.begin());
}

void Captions::grow_older(float seconds) {
    for (Caption& caption : captions_) caption.age += seconds;
    std::erase_if(captions_, [](const Caption& c) { return seconds_left(c) <= 0.0f; });
}

}  // namespace gh::present

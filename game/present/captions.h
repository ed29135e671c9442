// present/captions.h - sounds as words, and what the program has to say: which lines stand at the bottom of the picture.
#pragma once

#include <string>
#include <vector>

namespace gh::present {

struct Caption {
    std::string text;
    std::string
        subject;  // what makes the sound: one line each, the last; empty: every text has a line of its own
    float age = 0.0f;  // seconds
    float bearing = 0.0f;
    bool has_bearing = false;
};

// Until it goes: four seconds after it came, or as long as it takes to read if that is more.
[[nodiscard]] float seconds_left(const Caption& caption);

// "Door creaks", newest last, a subject once; at most six stay.
class Captions {
  public:
    void add(Caption caption);
    void grow_older(float seconds);
    [[nodiscard]] const std::vector<Caption>& list() const { return captions_; }

  private:
    std::vector<Caption> captions_;
};

}  // namespace gh::present

#include "app/hint_words.h"

#include <glm/vector_relational.hpp>

namespace gh::app {

namespace {

using input::Action;

std::string room_of(const world::Level& level, const glm::vec3& place) {
    for (const world::Room& room : level.rooms) {
        if (glm::all(glm::lessThanEqual(room.box.min, place)) &&
            glm::all(glm::lessThanEqual(place, room.box.max)))
            return room.title.empty() ? room.name : room.title;
    }
    return "";
}

// "The Founder's Lens" within a sentence.
std::string within_sentence(const std::string& title) {
    return title.starts_with("The ") ? "the " + title.substr(4) : title;
}

// "Steal the Founder's Lens from the Lens Cabinet"; as much of it as the level tells.
std::string goal_words(const world::Level& level) {
    if (level.lenses.size() > 1) return "Steal every lens, and leave by the exit";
    const world::Lens& lens = level.lenses.front();
    const std::string room = room_of(level, lens.centre);
    return "Steal " + (lens.title.empty() ? "the lens" : within_sentence(lens.title)) +
           (room.empty() ? "" : " from the " + room) + ", unseen";
}

std::string exit_words(const world::Level& level) {
    const std::string room =
        level.exits.empty() ? "" : room_of(level, (level.exits.front().min + level.exits.front().max) * 0.5f);
    return room.empty() ? "It is yours. Now out of here" : "It is yours. Now out, through the " + room;
}

}  // namespace

std::string words_for(Lesson lesson, const world::Level& level, const KeyWords& keys) {
    const std::string lean = keys.one(Action::LeanLeft) + " or " + keys.one(Action::LeanRight);
    switch (lesson) {
        case Lesson::Chase:
            return "Run!  " + keys.one(Action::Run) +
                   ".  Out of his sight he loses you; a shut door costs him time";
        case Lesson::Search:
            return "He is searching where he last noticed you: be somewhere else, low and in the dark";
        case Lesson::Doubt:
            return "He noticed something. The arc points to him and says through what: get out of it, and "
                   "wait";
        case Lesson::Exit:
            return exit_words(level);
        case Lesson::Goal:
            return goal_words(level);
        case Lesson::HandMirror:
            return "Hold " + keys.one(Action::HandMirror) + ": the mirror shows what is behind you; with " +
                   lean + ", what is round that corner";
        case Lesson::Light:
            return "The bright diamond below: this is how well he sees you. " + keys.one(Action::Use) +
                   " at a switch puts the lamp out";
        case Lesson::Crouch:
            return keys.any(Action::Crouch) + ": crouch. Hardly heard, and hidden behind anything knee-high";
        case Lesson::Lean:
            return lean + ": lean round the corner, without being there";
        case Lesson::Stone:
            return "Hold " + keys.one(Action::Throw) +
                   " to aim a stone, let go to throw: he goes to see what that was";
    }
    return "";
}

}  // namespace gh::app

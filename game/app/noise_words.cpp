#include "app/noise_words.h"

namespace gh::app {

namespace {

std::string bark_words(world::Bark bark) {
    switch (bark) {
        case world::Bark::None:
            return "";
        case world::Bark::Huh:
            return "guard: hm?";
        case world::Bark::WhoIsThere:
            return "guard: who is there?";
        case world::Bark::Alarm:
            return "guard: stop!";
        case world::Bark::GaveUp:
            return "guard sighs and gives up";
        case world::Bark::Caught:
            return "guard: got you";
    }
    return "";
}

}  // namespace

std::string caption_of(const world::Noise& noise) {
    const std::string surface(world::surface_name(static_cast<world::Surface>(noise.surface)));
    switch (noise.kind) {
        case world::NoiseKind::Footstep:
        case world::NoiseKind::Land:
        case world::NoiseKind::Throw:
        case world::NoiseKind::PickUp:
            return "";  // the player's own
        case world::NoiseKind::StoneHit:
            return "stone clatters on " + surface;
        case world::NoiseKind::DoorOpen:
            return "door opens";
        case world::NoiseKind::DoorClose:
            return "door closes";
        case world::NoiseKind::Switch:
            return "switch clicks";
        case world::NoiseKind::MirrorTurn:
            return "mirror turns";
        case world::NoiseKind::LensTaken:
            return "lens taken";
        case world::NoiseKind::GuardStep:
            return "footsteps on " + surface;
        case world::NoiseKind::Bark:
            return bark_words(noise.bark);
    }
    return "";
}

std::string subject_of(const world::Noise& noise) {
    switch (noise.kind) {
        case world::NoiseKind::StoneHit:
            return "stone";
        case world::NoiseKind::GuardStep:
            return "steps";
        case world::NoiseKind::Bark:
            return "voice";
        default:
            return "";
    }
}

}  // namespace gh::app

#include "sense/walls.h"

#include "sense/faces.h"
#include "world/layers.h"

#include <algorithm>
#include <span>

namespace gh::sense {
namespace {

constexpr std::size_t kAlone = kMaxFaces;

struct WallFace {
    const world::Material* material = nullptr;
    std::uint32_t part = world::kNoIndex;
    std::size_t partner = kAlone;  // the wall's other face
    bool enters = false;
};

// Bodies are too small to stop a sound, and an ear sits inside its own head.
bool takes_sound(const world::Part& part) {
    return part.mover != world::Mover::Guard && part.mover != world::Mover::Stone;
}

std::size_t find_faces(const world::Level& level, const rc::Scene& scene, const glm::vec3& from,
                       const glm::vec3& to, std::span<WallFace> out) {
    std::array<Face, kMaxFaces> faces;
    const Faces met = faces_between(level, scene, from, to, world::Sound, faces);
    std::size_t kept = 0;
    for (const Face& face : std::span(faces).first(met.count)) {
        if (!takes_sound(level.parts[face.part])) continue;
        out[kept] = {.material = face.material, .part = face.part, .partner = kAlone, .enters = face.enters};
        ++kept;
    }
    return kept;
}

// Pairs every face that leaves with the nearest one before it that entered and is still alone, as brackets pair:
// the same pairs come out when the way is walked backwards.
template <class MayPair>
void pair_faces(std::span<WallFace> faces, const MayPair& may_pair) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (faces[i].enters || faces[i].partner != kAlone) continue;
        for (std::size_t j = i; j-- > 0;) {
            if (!faces[j].enters || faces[j].partner != kAlone || !may_pair(faces[j], faces[i])) continue;
            faces[i].partner = j;
            faces[j].partner = i;
            break;
        }
    }
}

const BandDb& loss_of(const WallFace& face) {
    return world::acoustics(face.material->surface).transmission_loss_db;
}

bool lies_within_own_part(std::span<const WallFace> faces, std::size_t i) {
    for (std::size_t j = 0; j < i; ++j) {
        if (faces[j].part == faces[i].part && faces[j].enters && faces[j].partner != kAlone &&
            faces[j].partner > i) {
            return true;
        }
    }
    return false;
}

void note_part(std::uint32_t part, Walls& walls) {
    const auto end = walls.parts.begin() + static_cast<std::ptrdiff_t>(walls.part_count);
    if (std::find(walls.parts.begin(), end, part) != end || walls.part_count == kMaxBlockers) return;
    walls.parts[walls.part_count] = part;
    ++walls.part_count;
}

}  // namespace

Walls walls_between(const world::Level& level, const rc::Scene& scene, const glm::vec3& from,
                    const glm::vec3& to) {
    std::array<WallFace, kMaxFaces> storage;
    const std::size_t count = find_faces(level, scene, from, to, storage);
    const std::span<WallFace> faces = std::span(storage).first(count);
    pair_faces(faces, [](const WallFace& a, const WallFace& b) { return a.part == b.part; });
    pair_faces(faces, [&](const WallFace& a, const WallFace& b) {
        return level.parts[a.part].is_shell && level.parts[b.part].is_shell;
    });
    Walls walls;
    for (std::size_t i = 0; i < count; ++i) {
        note_part(faces[i].part, walls);
        const bool is_far_face = faces[i].partner != kAlone && faces[i].partner < i;
        if (is_far_face || lies_within_own_part(faces, i)) continue;
        const BandDb& near = loss_of(faces[i]);
        const BandDb& far = faces[i].partner == kAlone ? near : loss_of(faces[faces[i].partner]);
        for (std::size_t band = 0; band < world::kBands; ++band)
            walls.loss_db[band] += std::max(near[band], far[band]);
    }
    std::sort(walls.parts.begin(), walls.parts.begin() + static_cast<std::ptrdiff_t>(walls.part_count));
    return walls;
}

}  // namespace gh::sense

// embree_side.h - Embree 3 asked the same rays, for comparison. Nothing of it outside embree_*.cpp.
//
// Threads   a side is built with `threads` threads and may then be asked by any number.
#pragma once

#include "bench_rays.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace bench {

enum class EmbreeMode { Fast, Robust };
enum class EmbreeQuality { Low, Medium, High };  // Morton codes; binned SAH; spatial splits
enum class EmbreeCall { Single, Packet16 };

struct BuildTime {
    double wall_ms = 0;
    double core_ms = 0;  // processor time of the whole process meanwhile
};

class EmbreeSide {
  public:
    // `config` as rtcNewDevice wants it, e.g. "isa=avx2".
    EmbreeSide(const BenchScene& scene, EmbreeMode mode, EmbreeQuality quality, unsigned threads,
               const char* config = "");
    ~EmbreeSide();
    EmbreeSide(const EmbreeSide&) = delete;
    EmbreeSide& operator=(const EmbreeSide&) = delete;

    [[nodiscard]] BuildTime build_time() const;
    [[nodiscard]] std::size_t byte_size() const;  // kept by the device, vertices and indices included

    [[nodiscard]] Answer ask(std::span<const rc::Ray> rays, bool any, EmbreeCall call) const;
    // hits[i] answers rays[i] as raycore would say it; instance is 0.
    void closest(std::span<const rc::Ray> rays, EmbreeCall call, std::span<rc::Hit> hits) const;
    void any(std::span<const rc::Ray> rays, EmbreeCall call, std::span<std::uint8_t> is_hit) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// A mesh whose vertices move every frame (RTC_BUILD_QUALITY_REFIT in a dynamic scene).
class EmbreeCloth {
  public:
    EmbreeCloth(const BenchScene& scene, unsigned threads);
    ~EmbreeCloth();
    EmbreeCloth(const EmbreeCloth&) = delete;
    EmbreeCloth& operator=(const EmbreeCloth&) = delete;

    // Moves and refits; what it took, the copying of the vertices left out.
    BuildTime move(std::span<const glm::vec3> positions);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Many instances of one mesh, all of which move every frame.
class EmbreeCrowd {
  public:
    EmbreeCrowd(const BenchScene& mesh, std::span<const glm::mat4x3> places, EmbreeQuality quality,
                unsigned threads);
    ~EmbreeCrowd();
    EmbreeCrowd(const EmbreeCrowd&) = delete;
    EmbreeCrowd& operator=(const EmbreeCrowd&) = delete;

    // Sets every transform and commits.
    BuildTime move(std::span<const glm::mat4x3> places);
    [[nodiscard]] Answer ask(std::span<const rc::Ray> rays, bool any) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Meshes placed as instances, as the game commits them; nothing moves.
class EmbreePlaced {
  public:
    struct Placed {
        std::size_t mesh;
        glm::mat4x3 world_from_instance;
    };

    EmbreePlaced(std::span<const BenchScene> meshes, std::span<const Placed> instances, unsigned threads);
    ~EmbreePlaced();
    EmbreePlaced(const EmbreePlaced&) = delete;
    EmbreePlaced& operator=(const EmbreePlaced&) = delete;

    [[nodiscard]] Answer ask(std::span<const rc::Ray> rays, bool any) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace bench

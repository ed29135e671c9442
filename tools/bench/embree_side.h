// embree_side.h - Embree 3 asked the same rays, for comparison. Nothing of it outside this file's pair.
#pragma once

#include "bench_rays.h"

#include <cstdint>
#include <memory>
#include <span>

namespace bench {

enum class EmbreeMode {
    Fast,
    Robust
};  // Fast: high quality (spatial splits); Robust: its robust flag as well
enum class EmbreeCall { Single, Packet16 };

struct Answer {
    std::uint64_t hits = 0;
    std::uint64_t hash = 0;  // order-dependent over (hit, primitive)

    void add(bool is_hit, std::uint32_t primitive) {
        hits += is_hit;
        hash = (hash ^ (is_hit ? primitive + 1u : 0u)) * 0x100000001B3u;
    }
};

class EmbreeSide {
  public:
    EmbreeSide(const BenchScene& scene, EmbreeMode mode, bool high_quality, unsigned threads);
    ~EmbreeSide();
    EmbreeSide(const EmbreeSide&) = delete;
    EmbreeSide& operator=(const EmbreeSide&) = delete;

    [[nodiscard]] double build_ms() const;
    [[nodiscard]] Answer ask(const RaySet& set, EmbreeCall call) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace bench

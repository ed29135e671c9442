// raycore/blas.h - a bottom-level tree over the triangles of one mesh, in the mesh's own frame.
//
// Cost      build O(n log n), parallel (oneTBB: the caller's task_arena decides how many threads); refit O(n).
// Threads   a Blas may be read by any number of threads; refit needs it alone.
// Same bits one tree per input, whatever the thread count; and answers never depend on the tree.
// Bad input see mesh.h: dropped and counted. An empty mesh gives an empty Blas, which nothing meets.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include <glm/vec3.hpp>

#include "raycore/mesh.h"

namespace rc {

struct Box {
    glm::vec3 min{0.0f};
    glm::vec3 max{0.0f};
};

enum class BuildQuality {
    Fast,     // along a space-filling curve: two thirds of the default's time; for what is rebuilt every tick
    Default,  // binned surface-area heuristic (Wald 2007)
    High,     // and spatial splits (Stich 2009) and reinsertion (Bittner 2013): up to three times the default's time, for
              // what never moves, so what refits need is not kept unless asked for. A refit fits boxes to whole
              // triangles: it answers as any other and loses what the splits had gained
};

struct BuildOptions {
    BuildQuality quality = BuildQuality::Default;
    bool can_refit = quality != BuildQuality::High;  // 5-9 bytes a triangle; without, refit_blas refuses
};

class Blas {
  public:
    struct Data;  // private to raycore

    explicit Blas(std::unique_ptr<Data> data);
    Blas(const Blas&);  // a deep copy: what an owner of deforming geometry refits while others read the first
    Blas(Blas&&) noexcept;
    Blas& operator=(const Blas&) = delete;
    Blas& operator=(Blas&&) noexcept;
    ~Blas();

    [[nodiscard]] const MeshReport& report() const;
    [[nodiscard]] Box bounds() const;              // of the kept triangles; min > max when there is none
    [[nodiscard]] std::size_t byte_size() const;   // everything kept alive
    [[nodiscard]] float sah_cost() const;          // expected cost of a random ray; 1 per node, 1 per triangle
    [[nodiscard]] float refit_degradation() const;  // sah_cost now / sah_cost when built; rebuild above 2
    [[nodiscard]] const Data& data() const { return *data_; }
    [[nodiscard]] Data& data() { return *data_; }

  private:
    std::unique_ptr<Data> data_;
};

[[nodiscard]] std::shared_ptr<Blas> build_blas(const MeshView& mesh, const BuildOptions& options = {});

// Moves the vertices (as many as at build, same triangles) and fits every box to them again. Triangles that
// were dropped at build stay dropped; one that becomes non-finite is not met until it is finite again. False, and a
// contract violation, when there are more or fewer vertices or the tree was built not to be refitted: nothing changes.
bool refit_blas(Blas& blas, std::span<const glm::vec3> positions);

}  // namespace rc

// comparators/closest.h - any structure with any triangle test: the nearest hit, or all of them.
//
// Intervals and ties are raycore's: [t_min, t_max] closed, equal t goes to the lower primitive.
#pragma once

#include "comparators/kd_tree.h"
#include "comparators/uniform_grid.h"

#include <vector>

namespace comparators {

// No structure at all.
class BruteForce {
  public:
    explicit BruteForce(const Soup& soup) : soup_(soup) {}
    [[nodiscard]] const Soup& soup() const { return soup_; }
    [[nodiscard]] std::size_t byte_size() const { return soup_.corners.size() * (sizeof(Corners) + 4); }
    template <class Visit>
    void walk(const rc::Ray&, Visit&& visit) const {
        for (std::uint32_t i = 0; i < soup_.corners.size(); ++i) (void)visit(i);
    }

  private:
    const Soup& soup_;
};

// A miss when there is none; instance is 0.
template <class Test, class Structure>
[[nodiscard]] rc::Hit closest(const Structure& structure, const rc::Ray& ray) {
    const Test test(ray);
    const Soup& soup = structure.soup();
    rc::Hit best;
    structure.walk(ray, [&](std::uint32_t i) {
        rc::Hit hit;
        if (test(soup.corners[i], hit) && hit.t >= ray.t_min && hit.t <= ray.t_max && std::isfinite(hit.t)) {
            hit.primitive = soup.primitive[i];
            hit.instance = 0;
            if (best.is_miss() || hit.t < best.t || (hit.t == best.t && hit.primitive < best.primitive))
                best = hit;
        }
        return static_cast<double>(best.is_miss() ? ray.t_max : best.t);
    });
    return best;
}

}  // namespace comparators

#include "bench_sah.h"

#include "raycore_side.h"
#ifdef BENCH_HAS_EMBREE
#include "embree_sah.h"
#endif

#include <array>
#include <string>

namespace bench {

void bench_sah(Report& report, const BenchScene& scene, bool with_embree) {
    report.table("cost of a random ray by SAH in " + scene.name + ": 1 a node, 1 a triangle", "quality",
                 {"raycore", "Embree's builder", "ours / theirs"});
    for (const rc::BuildQuality quality : {rc::BuildQuality::Default, rc::BuildQuality::High}) {
        const double ours = static_cast<double>(rc::build_blas(scene.view(), {quality})->sah_cost());
        report.row(name_of(quality)).number(ours, 2);
#ifdef BENCH_HAS_EMBREE
        if (with_embree) {
            const bool is_high = quality == rc::BuildQuality::High;
            const double theirs = static_cast<double>(
                embree_sah_cost(scene, is_high ? EmbreeQuality::High : EmbreeQuality::Medium));
            report.number(theirs, 2).number(ours / theirs, 3);
            continue;
        }
#else
        (void)with_embree;
#endif
        report.none().none();
    }
}

}  // namespace bench

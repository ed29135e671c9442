// targets.h - the same work on every instruction set that Highway's kernels were compiled for and this machine has.
#pragma once

#include <hwy/highway.h>

#include <cstdint>

namespace gh::test {

template <class Work>
void on_every_target(const Work& work) {
    for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
        hwy::SetSupportedTargetsForTest(left & -left);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        work();
        hwy::SetSupportedTargetsForTest(0);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
}

}  // namespace gh::test

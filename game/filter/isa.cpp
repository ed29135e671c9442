#include "filter/isa.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/isa.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

static std::int64_t compiled_for() {
    return HWY_TARGET;
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(compiled_for);

namespace {

void allow(std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace

std::vector<std::string> isa_names() {
    std::vector<std::string> names;
    for (std::int64_t targets = hwy::SupportedTargets() & HWY_TARGETS; targets != 0; targets &= targets - 1) {
        names.emplace_back(hwy::TargetName(targets & -targets));
    }
    return names;
}

bool use_isa(const std::string& name) {
    allow(0);
    if (name.empty()) return true;
    for (std::int64_t targets = hwy::SupportedTargets() & HWY_TARGETS; targets != 0; targets &= targets - 1) {
        const std::int64_t target = targets & -targets;
        if (name != hwy::TargetName(target)) continue;
        allow(target);
        return HWY_DYNAMIC_DISPATCH(compiled_for)() == target;
    }
    return false;
}

}  // namespace gh::filter
#endif

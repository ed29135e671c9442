// speed_error/walking_guard.h - what a way of making pictures shows of a guard who walks by: whether a ghost stays behind.
#pragma once

#include "contestants.h"
#include "findings.h"
#include "studio.h"

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace speed_error {

struct Walk;

// A guard walks across the view, four metres ahead of an eye that stands still, 30 pictures a second; judged at several of
// them by truths of many samples of just that moment. Of white, as a screen shows it, root of the mean square: "where he
// was %" (left in the last four pictures), "on him %", "elsewhere %". "ghost %": how much of him is left where he no longer is: along
// the difference between the truths of then and now, counted from what this very way shows where nobody ever walked, so that
// neither noise nor bias counts.
class WalkingGuard {
  public:
    // Of a level that has a guard. The view must live as long.
    WalkingGuard(const View& view, int width, int height, const gh::Jobs& jobs);
    ~WalkingGuard();

    // Nothing where he can not be seen.
    [[nodiscard]] std::vector<Finding> judge(const Contestant& contestant);

  private:
    const gh::Image& true_picture_at(std::size_t moment, const std::string& truth);

    std::unique_ptr<Walk> walk_;
    std::map<std::pair<std::string, std::size_t>, gh::Image> truths_;  // whoever asks for one again gets it
};
inline constexpr const char* kWalkingGuardTable = "a guard walks by, of what is shown";

}  // namespace speed_error

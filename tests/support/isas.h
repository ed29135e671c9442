// support/isas.h - run a test once per instruction set this machine has.
#pragma once

#include "raycore/isa.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace test {

inline std::vector<rc::Isa> supported_isas() {
    std::vector<rc::Isa> isas;
    for (const rc::Isa isa : {rc::Isa::Scalar, rc::Isa::Avx2, rc::Isa::Avx512})
        if (rc::is_isa_supported(isa)) isas.push_back(isa);
    return isas;
}

inline std::string isa_test_name(const ::testing::TestParamInfo<rc::Isa>& info) {
    return std::string(rc::isa_name(info.param));
}

// Uses `isa` while it lives.
class IsaScope {
  public:
    explicit IsaScope(rc::Isa isa) : before_(rc::active_isa()) { rc::use_isa(isa); }
    IsaScope(const IsaScope&) = delete;
    IsaScope& operator=(const IsaScope&) = delete;
    ~IsaScope() { rc::use_isa(before_); }

  private:
    rc::Isa before_;
};

}  // namespace test

#include "base/contracts.h"

#include "base/result.h"

#include <gtest/gtest.h>

namespace gh {
namespace {

#ifdef GLASSHOUSE_CONTRACTS

TEST(ContractsDeathTest, ABrokenContractStopsAtTheLineThatBrokeIt) {
    const int coins = -1;
    EXPECT_DEATH(EXPECTS(coins >= 0), "contracts_test.cpp:[0-9]+: precondition violated: coins >= 0");
    EXPECT_DEATH(ENSURES(coins == 1), "contracts_test.cpp:[0-9]+: postcondition violated: coins == 1");
}

TEST(ContractsDeathTest, TheValueOfAnErrorIsNobodysToTake) {
    const Result<int> failed = Error{"cannot read 'a': no such file"};
    EXPECT_DEATH((void)*failed, "has_value");
    const Result<int> fine = 3;
    EXPECT_DEATH((void)fine.error(), "has_value");
}

TEST(Contracts, AKeptContractSaysNothing) {
    int evaluations = 0;
    EXPECTS(++evaluations == 1);
    EXPECT_EQ(evaluations, 1);
}

#else

TEST(Contracts, AreNotEvaluatedInRelease) {
    int evaluations = 0;
    EXPECTS(++evaluations == 100);
    ENSURES(++evaluations == 100);
    EXPECT_EQ(evaluations, 0);
}

#endif

}  // namespace
}  // namespace gh

#include "base/result.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace gh {
namespace {

Result<std::string> greeting(bool is_known) {
    if (!is_known) return Error{"cannot greet 'nobody': no such person"};
    return std::string("good evening");
}

TEST(Result, HoldsEitherTheValueOrTheSentence) {
    const Result<std::string> good = greeting(true);
    ASSERT_TRUE(good);
    EXPECT_EQ(*good, "good evening");
    EXPECT_EQ(good->size(), 12u);

    const Result<std::string> bad = greeting(false);
    ASSERT_FALSE(bad);
    EXPECT_EQ(bad.error().sentence, "cannot greet 'nobody': no such person");
}

TEST(Result, OfNothingIsFineUnlessToldOtherwise) {
    const Result<void> fine;
    EXPECT_TRUE(fine);
    const Result<void> bad = Error{"the disk is full"};
    ASSERT_FALSE(bad);
    EXPECT_EQ(bad.error().sentence, "the disk is full");
}

TEST(Result, GivesUpAValueThatCanOnlyBeMoved) {
    Result<std::unique_ptr<int>> held = std::make_unique<int>(7);
    const std::unique_ptr<int> taken = *std::move(held);
    EXPECT_EQ(*taken, 7);
}

TEST(Result, LetsItsValueBeChangedInPlace) {
    Result<std::vector<int>> list = std::vector<int>{1};
    list->push_back(2);
    (*list)[0] = 5;
    EXPECT_EQ(*list, (std::vector<int>{5, 2}));
}

}  // namespace
}  // namespace gh

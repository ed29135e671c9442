#include "base/progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

namespace gh {
namespace {

std::string drawn_by(bool is_terminal, std::size_t total, const std::function<void(Progress&)>& work) {
    char* text = nullptr;
    std::size_t size = 0;
    std::FILE* out = open_memstream(&text, &size);
    {
        Progress progress("frames", total, out, is_terminal);
        work(progress);
    }
    std::fclose(out);
    const std::string drawn(text, size);
    std::free(text);
    return drawn;
}

void count_up(Progress& progress) {
    for (std::size_t i = 1; i <= 1000; ++i) progress.show(i);
}

TEST(Progress, ALogGetsALineForEveryTenth) {
    const std::string log = drawn_by(false, 1000, count_up);
    EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 11);
    EXPECT_EQ(log.find('\r'), std::string::npos);
    EXPECT_EQ(log.substr(log.size() - 14), "frames: 100 %\n");
}

TEST(Progress, ATerminalGetsOneLineRedrawnOnlyWhenItChanges) {
    const std::string line = drawn_by(true, 1000, count_up);
    EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1);
    EXPECT_EQ(std::count(line.begin(), line.end(), '\r'), 101);
    EXPECT_NE(line.find("[##############################] 100 %\n"), std::string::npos);
}

TEST(Progress, NothingToDoIsFinishedAndMoreThanAllIsAll) {
    EXPECT_EQ(drawn_by(false, 0, [](Progress&) {}), "frames: 100 %\n");
    EXPECT_EQ(drawn_by(false, 1, [](Progress& p) { p.show(5); }), "frames: 0 %\nframes: 100 %\n");
}

// What a replay has to say, a summary or where it diverged, came at the end of the bar's line.
TEST(Progress, WhatIsSaidAfterwardsHasALineOfItsOwn) {
    char* text = nullptr;
    std::size_t size = 0;
    std::FILE* out = open_memstream(&text, &size);
    {
        Progress whole("whole", 2, out, true);
        whole.show(2);
        std::fputs("done\n", out);
        Progress half("half", 2, out, true);
        half.show(1);
        half.end_line();
        std::fputs("stopped\n", out);
    }
    std::fclose(out);
    const std::string said(text, size);
    std::free(text);
    EXPECT_NE(said.find("100 %\ndone\n"), std::string::npos) << said;
    EXPECT_NE(said.find(" 50 %\nstopped\n"), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 4) << said;
}

}  // namespace
}  // namespace gh

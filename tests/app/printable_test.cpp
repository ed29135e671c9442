#include "app/printable.h"

#include <gtest/gtest.h>

namespace gh::app {
namespace {

TEST(Printable, LeavesWellFormedTextAlone) {
    for (const char* text : {"", "plain", "two\nlines",
                             "Mus\xC3\xA9"
                             "e \xE2\x80\xB9 \xF0\x9F\x94\x8D"})
        EXPECT_EQ(printable(text), text);
}

// A bit-flipped level once put half a character into the sentence that refused it.
TEST(Printable, MarksEveryByteThatIsNoText) {
    EXPECT_EQ(printable("a\xE2"
                        "b"),
              "a?b");
    EXPECT_EQ(printable("\xC0\xAF"), "??") << "overlong";
    EXPECT_EQ(printable("\xED\xA0\x80"), "???") << "a surrogate";
    EXPECT_EQ(printable("\xF4\x90\x80\x80"), "????") << "beyond U+10FFFF";
    EXPECT_EQ(printable("cut \xF0\x9F\x94"), "cut ???");
    EXPECT_EQ(printable("\x1B[31mred\x7F\t"), "?[31mred??") << "no colours, no bells";
}

}  // namespace
}  // namespace gh::app

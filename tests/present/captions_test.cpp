#include "present/captions.h"

#include <gtest/gtest.h>

namespace gh::present {
namespace {

Caption caption(const char* text, const char* subject = "") {
    Caption caption;
    caption.text = text;
    caption.subject = subject;
    return caption;
}

std::vector<std::string> texts(const Captions& captions) {
    std::vector<std::string> texts;
    for (const Caption& c : captions.list()) texts.push_back(c.text);
    return texts;
}

// A stone that bounces from oak to carpet is one thing to read, at the surface it is on now.
TEST(Captions, WhatMakesTheSoundHasOneLineTheLast) {
    Captions captions;
    captions.add(caption("stone clatters on oak", "stone"));
    captions.add(caption("door opens"));
    captions.add(caption("stone clatters on carpet", "stone"));
    EXPECT_EQ(texts(captions), (std::vector<std::string>{"door opens", "stone clatters on carpet"}));
}

TEST(Captions, TheSameWordsStartTheirTimeAnewAndOthersStand) {
    Captions captions;
    captions.add(caption("door opens"));
    captions.add(caption("switch clicks"));
    captions.grow_older(3.0f);
    captions.add(caption("door opens"));
    captions.grow_older(1.5f);
    EXPECT_EQ(texts(captions), std::vector<std::string>{"door opens"});
}

TEST(Captions, AtMostSixStandAndTheOldestGo) {
    Captions captions;
    for (const char* text : {"a", "b", "c", "d", "e", "f", "g"}) captions.add(caption(text));
    EXPECT_EQ(texts(captions), (std::vector<std::string>{"b", "c", "d", "e", "f", "g"}));
}

// Subtitles count on fifteen letters a second: ninety are read in six.
TEST(Captions, LongOnesStayUntilTheyAreRead) {
    const std::string ninety(90, 'a');
    Captions captions;
    captions.add(caption("door opens"));
    captions.add(caption(ninety.c_str()));
    captions.grow_older(4.5f);
    EXPECT_EQ(texts(captions), std::vector<std::string>{ninety});
    captions.grow_older(1.75f);
    EXPECT_TRUE(captions.list().empty());
}

}  // namespace
}  // namespace gh::present

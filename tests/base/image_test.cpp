#include "base/image.h"

#include <gtest/gtest.h>

namespace gh {
namespace {

TEST(Image, StartsBlackAndRunsRowsFromTopToBottom) {
    Image image(3, 2);
    EXPECT_EQ(image.pixels.size(), 6u);
    EXPECT_EQ(image.at(2, 1), glm::vec3(0.0f));
    image.at(1, 0) = glm::vec3(1, 2, 3);
    image.at(0, 1) = glm::vec3(4, 5, 6);
    EXPECT_EQ(image.pixels[1], glm::vec3(1, 2, 3));
    EXPECT_EQ(image.pixels[3], glm::vec3(4, 5, 6));
}

TEST(Image, OfBytesKeepsAPixelsChannelsTogether) {
    Image8 image(2, 2, 4);
    EXPECT_EQ(image.bytes.size(), 16u);
    image.at(1, 1)[3] = 255;
    EXPECT_EQ(image.bytes[15], 255);
    image.at(0, 1)[0] = 9;
    EXPECT_EQ(image.bytes[8], 9);
}

}  // namespace
}  // namespace gh

#include "base/file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace gh {
namespace {

namespace fs = std::filesystem;

class FileTest : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("glasshouse_file_test_" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path folder_;
};

std::string as_text(const std::vector<std::byte>& bytes) {
    std::string text;
    for (const std::byte b : bytes) text.push_back(static_cast<char>(b));
    return text;
}

TEST_F(FileTest, WhatIsWrittenIsReadAndNothingElseIsLeftBehind) {
    const fs::path path = folder_ / "new" / "settings.json";
    ASSERT_TRUE(write_file_atomically(path, std::string_view("first")));
    ASSERT_TRUE(write_file_atomically(path, std::string_view("second")));
    const auto bytes = read_file(path, 100);
    ASSERT_TRUE(bytes) << bytes.error().sentence;
    EXPECT_EQ(as_text(*bytes), "second");
    EXPECT_EQ(std::distance(fs::directory_iterator(path.parent_path()), fs::directory_iterator()), 1);
}

TEST_F(FileTest, AnEmptyFileIsNoBytes) {
    ASSERT_TRUE(write_file_atomically(folder_ / "empty", std::string_view()));
    const auto bytes = read_file(folder_ / "empty", 0);
    ASSERT_TRUE(bytes);
    EXPECT_TRUE(bytes->empty());
}

TEST_F(FileTest, ErrorsNameTheFileAndTheReason) {
    const auto missing = read_file(folder_ / "nowhere.glb", 100);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().sentence,
              "cannot read '" + (folder_ / "nowhere.glb").string() + "': No such file or directory");

    const auto a_folder = read_file(folder_, 100);
    ASSERT_FALSE(a_folder);
    EXPECT_NE(a_folder.error().sentence.find("directory"), std::string::npos);

    std::ofstream(folder_ / "long") << "0123456789";
    const auto too_long = read_file(folder_ / "long", 9);
    ASSERT_FALSE(too_long);
    EXPECT_NE(too_long.error().sentence.find("10 bytes are more than the 9 allowed"), std::string::npos);
    EXPECT_TRUE(read_file(folder_ / "long", 10));
}

TEST_F(FileTest, APipeIsRefusedInsteadOfWaitedFor) {
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    const auto pipe = read_file(folder_ / "pipe", 100);
    ASSERT_FALSE(pipe);
    EXPECT_NE(pipe.error().sentence.find("not a regular file"), std::string::npos);
}

TEST_F(FileTest, AWriteThatFailsLeavesTheOldFileAlone) {
    fs::create_directories(folder_ / "taken" / "inside");
    const auto written = write_file_atomically(folder_ / "taken", std::string_view("x"));
    ASSERT_FALSE(written) << "a folder of that name is in the way";
    EXPECT_TRUE(fs::is_directory(folder_ / "taken" / "inside"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);

    std::ofstream(folder_ / "file") << "x";
    EXPECT_FALSE(write_file_atomically(folder_ / "file" / "below", std::string_view("x")));
}

}  // namespace
}  // namespace gh

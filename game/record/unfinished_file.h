// record/unfinished_file.h - a file that gets its name when it is whole, and leaves nothing behind otherwise.
//
// For libraries that write files themselves. Threads: one at a time.
#pragma once

#include "base/result.h"

#include <filesystem>

namespace gh::record {

class UnfinishedFile {
  public:
    // Makes the folders on the way. The library writes to path(), beside the final name and with its extension.
    [[nodiscard]] static Result<UnfinishedFile> beside(const std::filesystem::path& final_path);

    UnfinishedFile(UnfinishedFile&& other) noexcept;
    UnfinishedFile& operator=(UnfinishedFile&&) = delete;
    ~UnfinishedFile();  // removes it unless it was finished

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] const std::filesystem::path& final_path() const { return final_path_; }

    [[nodiscard]] Result<void> finish();

  private:
    UnfinishedFile(std::filesystem::path path, std::filesystem::path final_path);

    std::filesystem::path path_;  // empty once finished or moved from
    std::filesystem::path final_path_;
};

}  // namespace gh::record

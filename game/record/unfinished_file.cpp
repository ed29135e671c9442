#include "record/unfinished_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <utility>

namespace gh::record {

UnfinishedFile::UnfinishedFile(std::filesystem::path path, std::filesystem::path final_path)
    : path_(std::move(path)), final_path_(std::move(final_path)) {}

UnfinishedFile::UnfinishedFile(UnfinishedFile&& other) noexcept
    : path_(std::exchange(other.path_, {})), final_path_(std::move(other.final_path_)) {}

UnfinishedFile::~UnfinishedFile() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove(path_, ignored);
}

Result<UnfinishedFile> UnfinishedFile::beside(const std::filesystem::path& final_path) {
    const std::filesystem::path folder = final_path.parent_path();
    std::error_code error;
    if (!folder.empty()) std::filesystem::create_directories(folder, error);
    if (error) {
        return Error{fmt::format("{}: the folder can not be made: {}", final_path.string(), error.message())};
    }
    if (std::filesystem::is_directory(final_path, error)) {
        return Error{fmt::format("{}: is a folder", final_path.string())};
    }
    const std::string name =
        fmt::format(".{}.{}{}", final_path.stem().string(), ::getpid(), final_path.extension().string());
    return UnfinishedFile(folder / name, final_path);
}

Result<void> UnfinishedFile::finish() {
    std::error_code error;
    std::filesystem::rename(path_, final_path_, error);
    if (error)
        return Error{fmt::format("{}: can not be named so: {}", final_path_.string(), error.message())};
    path_.clear();
    return {};
}

}  // namespace gh::record

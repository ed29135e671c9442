#include "base/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace gh {

namespace {

class OpenFile {
  public:
    explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
    ~OpenFile() { close(); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
    [[nodiscard]] int descriptor() const { return descriptor_; }
    bool close() {
        const bool is_fine = descriptor_ < 0 || ::close(descriptor_) == 0;
        descriptor_ = -1;
        return is_fine;
    }

  private:
    int descriptor_;
};

Error error_about(const char* verb, const std::filesystem::path& path, int code) {
    return {fmt::format("cannot {} '{}': {}", verb, path.string(), std::generic_category().message(code))};
}

bool write_all(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

}  // namespace

Result<std::vector<std::byte>> read_file(const std::filesystem::path& path, std::size_t max_bytes) {
    OpenFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));  // a pipe must not hang us
    if (!file.is_open()) return error_about("read", path, errno);

    struct stat info {};
    if (::fstat(file.descriptor(), &info) != 0) return error_about("read", path, errno);
    if (S_ISDIR(info.st_mode)) return error_about("read", path, EISDIR);
    if (!S_ISREG(info.st_mode))
        return Error{fmt::format("cannot read '{}': not a regular file", path.string())};
    const auto size = static_cast<std::size_t>(info.st_size);
    if (size > max_bytes) {
        return Error{fmt::format("cannot read '{}': its {} bytes are more than the {} allowed", path.string(),
                                 size, max_bytes)};
    }

    std::vector<std::byte> bytes(size);
    std::size_t filled = 0;
    while (filled < size) {
        const ssize_t got = ::read(file.descriptor(), bytes.data() + filled, size - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return error_about("read", path, errno);
        if (got == 0) break;  // it shrank meanwhile
        filled += static_cast<std::size_t>(got);
    }
    bytes.resize(filled);
    return bytes;
}

Result<void> write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    std::error_code code;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), code);
    if (code) return error_about("make the folder of", path, code.value());

    const std::filesystem::path temporary = path.string() + fmt::format(".{}.tmp", ::getpid());
    OpenFile file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
    if (!file.is_open()) return error_about("write", path, errno);
    const bool is_written =
        write_all(file.descriptor(), bytes) && ::fsync(file.descriptor()) == 0 && file.close();
    if (!is_written || ::rename(temporary.c_str(), path.c_str()) != 0) {
        const int reason = errno;
        ::unlink(temporary.c_str());
        return error_about("write", path, reason);
    }
    return {};
}

Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view text) {
    return write_file_atomically(path, std::as_bytes(std::span(text)));
}

}  // namespace gh

#include "input/replay.h"
#include "input/replay_format.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>

namespace gh::input {

struct ReplayWriter::Open {
    ~Open() {
        if (file != nullptr) std::fclose(file);
    }

    // After one failure everything fails with the same sentence: a file with a gap is worth nothing behind
    // it.
    [[nodiscard]] Result<void> write(std::span<const std::byte> bytes) {
        const bool is_written = !failure &&
                                std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() &&
                                std::fflush(file) == 0;
        if (!is_written && !failure) failure = error_now();
        if (failure) return *failure;
        return {};
    }

    [[nodiscard]] Error error_now() const {
        return {fmt::format("cannot record to '{}': {}", part_path.string(),
                            std::generic_category().message(errno))};
    }

    std::filesystem::path path;
    std::filesystem::path part_path;
    std::FILE* file = nullptr;
    Replay pending;  // the header, and ticks not yet written
    std::uint32_t written_ticks = 0;
    std::optional<Error> failure;
};

ReplayWriter::ReplayWriter(std::unique_ptr<Open> open) : open_(std::move(open)) {}
ReplayWriter::ReplayWriter(ReplayWriter&&) noexcept = default;

ReplayWriter& ReplayWriter::operator=(ReplayWriter&& other) noexcept {
    if (this != &other) {
        if (open_ != nullptr && open_->file != nullptr) (void)flush();
        open_ = std::move(other.open_);
    }
    return *this;
}

ReplayWriter::~ReplayWriter() {
    if (open_ != nullptr && open_->file != nullptr) (void)flush();
}

Result<ReplayWriter> ReplayWriter::create(const std::filesystem::path& path, ReplayHeader header) {
    const auto is_short = [](const std::string& text) { return text.size() <= kMaxReplayName; };
    EXPECTS(header.parts.size() <= kMaxReplayParts && is_short(header.level_name));
    EXPECTS(std::all_of(header.parts.begin(), header.parts.end(), is_short));

    auto open = std::make_unique<Open>();
    open->path = path;
    open->part_path = path.string() + ".part";
    std::error_code code;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), code);
    if (code) return Error{fmt::format("cannot make the folder of '{}': {}", path.string(), code.message())};
    open->file = std::fopen(open->part_path.c_str(), "wb");
    if (open->file == nullptr) return open->error_now();

    open->pending.header = std::move(header);
    if (const Result<void> written = open->write(format::header_bytes(open->pending.header)); !written) {
        return written.error();
    }
    return ReplayWriter(std::move(open));
}

Result<void> ReplayWriter::append(const Command& command, std::uint64_t state_hash,
                                  std::span<const std::uint64_t> parts) {
    EXPECTS(open_ != nullptr && open_->file != nullptr);
    EXPECTS(is_valid(command) && parts.size() == open_->pending.header.parts.size());
    if (ticks() >= kMaxReplayTicks) {
        return Error{
            fmt::format("cannot record to '{}': it already holds {} ticks, the most a replay may have",
                        open_->part_path.string(), ticks())};
    }
    Replay& pending = open_->pending;
    pending.commands.push_back(command);
    pending.state_hashes.push_back(state_hash);
    pending.part_hashes.insert(pending.part_hashes.end(), parts.begin(), parts.end());
    return pending.ticks() >= format::kTicksPerChunk ? flush() : Result<void>();
}

// What could not be written is dropped all the same: a full disk must not fill the memory too.
Result<void> ReplayWriter::flush() {
    EXPECTS(open_ != nullptr && open_->file != nullptr);
    Replay& pending = open_->pending;
    if (pending.ticks() == 0) return {};
    const std::vector<std::byte> chunk =
        format::chunk_bytes(pending, 0, pending.ticks(), open_->written_ticks);
    open_->written_ticks += static_cast<std::uint32_t>(pending.ticks());
    pending.commands.clear();
    pending.state_hashes.clear();
    pending.part_hashes.clear();
    return open_->write(chunk);
}

Result<void> ReplayWriter::finish() {
    if (Result<void> flushed = flush(); !flushed) return flushed;
    if (Result<void> ended = open_->write(format::ending_bytes(open_->written_ticks)); !ended) return ended;
    const bool is_synced = ::fsync(::fileno(open_->file)) == 0;
    const bool is_closed = std::fclose(open_->file) == 0;
    open_->file = nullptr;
    if (!is_synced || !is_closed || std::rename(open_->part_path.c_str(), open_->path.c_str()) != 0) {
        return open_->error_now();
    }
    return {};
}

std::size_t ReplayWriter::ticks() const {
    EXPECTS(open_ != nullptr);
    return open_->written_ticks + open_->pending.ticks();
}

}  // namespace gh::input

#include "record/wav.h"

#include "base/contracts.h"
#include "record/unfinished_file.h"

#include <fmt/format.h>
#include <sndfile.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace gh::record {

struct WavWriter::File {
    UnfinishedFile target;
    SNDFILE* sound = nullptr;
    std::size_t frames = 0;
    std::vector<float> clipped;  // scratch

    explicit File(UnfinishedFile unfinished) : target(std::move(unfinished)) {}
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() {
        if (sound != nullptr) sf_close(sound);
    }
};

WavWriter::WavWriter(std::unique_ptr<File> file) : file_(std::move(file)) {}
WavWriter::WavWriter(WavWriter&&) noexcept = default;
WavWriter& WavWriter::operator=(WavWriter&&) noexcept = default;
WavWriter::~WavWriter() = default;

Result<WavWriter> WavWriter::open(const std::filesystem::path& path, WavDepth depth) {
    Result<UnfinishedFile> target = UnfinishedFile::beside(path);
    if (!target) return target.error();
    auto file = std::make_unique<File>(std::move(*target));
    SF_INFO info{};
    info.samplerate = kSampleRate;
    info.channels = 2;
    info.format = SF_FORMAT_WAV | (depth == WavDepth::Bits16 ? SF_FORMAT_PCM_16 : SF_FORMAT_PCM_24);
    file->sound = sf_open(file->target.path().c_str(), SFM_WRITE, &info);
    if (file->sound == nullptr) {
        return Error{fmt::format("{}: can not be written: {}", path.string(), sf_strerror(nullptr))};
    }
    sf_command(file->sound, SFC_SET_CLIPPING, nullptr, SF_TRUE);
    return WavWriter(std::move(file));
}

Result<void> WavWriter::write(std::span<const float> interleaved) {
    EXPECTS(file_ != nullptr && file_->sound != nullptr);
    EXPECTS(interleaved.size() % 2 == 0);
    file_->clipped.clear();
    for (const float sample : interleaved) {
        file_->clipped.push_back(sample == sample ? std::clamp(sample, -1.0f, 1.0f) : 0.0f);
    }
    const auto frames = static_cast<sf_count_t>(interleaved.size() / 2);
    if (sf_writef_float(file_->sound, file_->clipped.data(), frames) != frames) {
        return Error{fmt::format("{}: can not be written: {}", file_->target.final_path().string(),
                                 sf_strerror(file_->sound))};
    }
    file_->frames += static_cast<std::size_t>(frames);
    return {};
}

std::size_t WavWriter::frames_written() const {
    return file_ != nullptr ? file_->frames : 0;
}

Result<void> WavWriter::close() {
    EXPECTS(file_ != nullptr && file_->sound != nullptr);
    const int error = sf_close(std::exchange(file_->sound, nullptr));
    if (error != 0) {
        return Error{fmt::format("{}: can not be written: {}", file_->target.final_path().string(),
                                 sf_error_number(error))};
    }
    return file_->target.finish();
}

}  // namespace gh::record

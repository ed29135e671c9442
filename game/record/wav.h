// record/wav.h - sound to disk, as it comes.
//
// A WavWriter writes beside the final name and renames on close(), so a file under that name is whole. Destroying one
// that was not closed removes what it wrote.
// Threads   one at a time.
#pragma once

#include "base/result.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>

namespace gh::record {

inline constexpr int kSampleRate = 48'000;

enum class WavDepth { Bits16, Bits24 };

class WavWriter {
  public:
    // Stereo at kSampleRate.
    [[nodiscard]] static Result<WavWriter> open(const std::filesystem::path& path,
                                                WavDepth depth = WavDepth::Bits16);

    WavWriter(WavWriter&&) noexcept;
    WavWriter& operator=(WavWriter&&) noexcept;
    ~WavWriter();

    // Left and right in turn, -1..1; what is louder is clipped, a NaN is silence. An even number of samples.
    [[nodiscard]] Result<void> write(std::span<const float> interleaved);

    [[nodiscard]] std::size_t frames_written() const;

    // Finishes the file and gives it its name. Nothing may be written afterwards.
    [[nodiscard]] Result<void> close();

  private:
    struct File;
    explicit WavWriter(std::unique_ptr<File> file);
    std::unique_ptr<File> file_;
};

}  // namespace gh::record

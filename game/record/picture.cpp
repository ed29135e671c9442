#include "record/picture.h"

#include "base/file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <cstdint>
#include <exception>
#include <span>
#include <string>
#include <vector>

namespace gh::record {

namespace {

// Into memory, and from there to the disk: the PNG writer does not notice when that is full, base/file does.
Result<void> write_picture(const std::filesystem::path& path, const OIIO::ImageSpec& spec,
                           const void* pixels) {
    const auto failed = [&](const std::string& reason) {
        return Error{fmt::format("{}: can not be written: {}", path.string(), reason)};
    };
    try {
        OIIO::Filesystem::IOVecOutput memory;
        const auto out = OIIO::ImageOutput::create(path.string(), &memory);
        if (out == nullptr) return failed(OIIO::geterror());
        if (!out->open(path.string(), spec)) return failed(out->geterror());
        if (!out->write_image(spec.format, pixels)) return failed(out->geterror());
        if (!out->close()) return failed(out->geterror());
        return write_file_atomically(path, std::as_bytes(std::span(memory.buffer())));
    } catch (const std::exception& exception) {
        return failed(exception.what());
    }
}

Result<void> refuse_empty(const std::filesystem::path& path, int width, int height) {
    if (width >= 1 && height >= 1) return {};
    return Error{fmt::format("{}: can not be written: the picture is empty", path.string())};
}

}  // namespace

Result<void> write_png(const std::filesystem::path& path, const Image8& picture) {
    EXPECTS(picture.channels == 3 || picture.channels == 4);
    if (Result<void> fine = refuse_empty(path, picture.width, picture.height); !fine) return fine;
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    return write_picture(path, spec, picture.bytes.data());
}

Result<void> write_exr(const std::filesystem::path& path, const Image& picture) {
    if (Result<void> fine = refuse_empty(path, picture.width, picture.height); !fine) return fine;
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
    OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::FLOAT);
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("compression", "zip");
    return write_picture(path, spec, picture.pixels.data());
}

Result<Image> read_picture(const std::filesystem::path& path) {
    const auto failed = [&](const std::string& reason) {
        return Error{fmt::format("{}: can not be read as a picture: {}", path.string(), reason)};
    };
    try {
        const auto in = OIIO::ImageInput::open(path.string());
        if (in == nullptr) return failed(OIIO::geterror());
        const OIIO::ImageSpec& spec = in->spec();
        constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;
        if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 ||
            std::int64_t{spec.width} * spec.height > kMostPixels)
            return failed("its size is not one of a picture");
        const int channels = spec.nchannels >= 3 ? 3 : 1;
        Image picture(spec.width, spec.height);
        std::vector<float> values(picture.pixels.size() * static_cast<std::size_t>(channels));
        if (!in->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, values.data()))
            return failed(in->geterror());
        for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
            const float* value = values.data() + i * static_cast<std::size_t>(channels);
            picture.pixels[i] = channels == 3 ? glm::vec3(value[0], value[1], value[2]) : glm::vec3(value[0]);
        }
        return picture;
    } catch (const std::exception& exception) {
        return failed(exception.what());
    }
}

}  // namespace gh::record

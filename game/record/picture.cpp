#include "record/picture.h"

#include "record/unfinished_file.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <exception>
#include <string>

namespace gh::record {

namespace {

Result<void> write_picture(const std::filesystem::path& path, const OIIO::ImageSpec& spec,
                           const void* pixels) {
    Result<UnfinishedFile> file = UnfinishedFile::beside(path);
    if (!file) return file.error();
    const auto failed = [&](const std::string& reason) {
        return Error{fmt::format("{}: can not be written: {}", path.string(), reason)};
    };
    try {
        const auto out = OIIO::ImageOutput::create(file->path().string());
        if (out == nullptr) return failed(OIIO::geterror());
        if (!out->open(file->path().string(), spec)) return failed(out->geterror());
        if (!out->write_image(spec.format, pixels)) return failed(out->geterror());
        if (!out->close()) return failed(out->geterror());
    } catch (const std::exception& exception) {
        return failed(exception.what());
    }
    return file->finish();
}

Result<void> refuse_empty(const std::filesystem::path& path, int width, int height) {
    if (width >= 1 && height >= 1) return {};
    return Error{fmt::format("{}: can not be written: the picture is empty", path.string())};
}

}  // namespace

Result<void> write_png(const std::filesystem::path& path, const Image8& picture) {
    EXPECTS(picture.channels == 3 || picture.channels == 4);
    if (const Result<void> fine = refuse_empty(path, picture.width, picture.height); !fine) return fine;
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    return write_picture(path, spec, picture.bytes.data());
}

Result<void> write_exr(const std::filesystem::path& path, const Image& picture) {
    if (const Result<void> fine = refuse_empty(path, picture.width, picture.height); !fine) return fine;
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
    OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::FLOAT);
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("compression", "zip");
    return write_picture(path, spec, picture.pixels.data());
}

}  // namespace gh::record

#include "load/image_decode.h"

#include "load/limits.h"
#include "load/png_check.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>
#include <string>

namespace gh::load {
namespace {

using Bytes = std::span<const unsigned char>;

template <std::size_t N>
bool begins_with(Bytes bytes, const std::array<unsigned char, N>& magic) {
    return bytes.size() >= N && std::equal(magic.begin(), magic.end(), bytes.begin());
}

// The format by its first bytes; what the file calls itself may be wrong. Empty: neither.
std::string format_of(Bytes bytes) {
    if (begins_with(bytes, std::array<unsigned char, 8>{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'}))
        return "png";
    if (begins_with(bytes, std::array<unsigned char, 3>{0xFF, 0xD8, 0xFF})) return "jpg";
    return {};
}

// The first line of what a decoder complains of: a refusal is one sentence.
Error damaged(const std::string& complaint) {
    return Error{"is damaged: " + complaint.substr(0, complaint.find('\n'))};
}

// 1: grey, 2: grey and alpha, 3: RGB, 4: RGBA.
std::vector<std::uint8_t> to_rgba(const std::vector<std::uint8_t>& from, std::size_t channels) {
    const std::size_t count = from.size() / channels;
    std::vector<std::uint8_t> rgba(count * 4);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* p = &from[i * channels];
        std::uint8_t* q = &rgba[i * 4];
        q[0] = p[0];
        q[1] = channels >= 3 ? p[1] : p[0];
        q[2] = channels >= 3 ? p[2] : p[0];
        q[3] = channels == 4 ? p[3] : channels == 2 ? p[1] : std::uint8_t{255};
    }
    return rgba;
}

Result<Pixels> read_pixels(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, std::size_t max_bytes) {
    if (spec.width < 1 || spec.height < 1 || spec.width > kMaxTextureSide || spec.height > kMaxTextureSide) {
        return Error{fmt::format("is {} x {} pixels, the most is {} a side", spec.width, spec.height,
                                 kMaxTextureSide)};
    }
    if (spec.nchannels < 1 || spec.nchannels > 4)
        return Error{fmt::format("has {} channels", spec.nchannels)};
    const std::size_t count = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    if (count * 4 > max_bytes) return Error{"is one too many: the textures together are too large"};

    const auto channels = static_cast<std::size_t>(spec.nchannels);
    std::vector<std::uint8_t> raw(count * channels);
    if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, raw.data())) {
        return damaged(input.geterror());
    }
    return Pixels{spec.width, spec.height, channels == 4 ? std::move(raw) : to_rgba(raw, channels)};
}

}  // namespace

Result<Pixels> decode_image(Bytes bytes, std::size_t max_bytes) {
    const std::string format = format_of(bytes);
    if (format.empty()) return Error{"is neither PNG nor JPEG"};
    if (format == "png") {
        if (const std::optional<std::string> damage = find_png_damage(bytes)) return damaged(*damage);
    }
    try {
        OIIO::Filesystem::IOMemReader reader(const_cast<unsigned char*>(bytes.data()), bytes.size());
        const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format);
        if (!input) return Error{"cannot be read: " + OIIO::geterror()};
        OIIO::ImageSpec config;
        config.attribute("oiio:UnassociatedAlpha", 1);  // glTF's alpha is straight; keep colours as they are
        OIIO::ImageSpec spec;
        if (!input->set_ioproxy(&reader) || !input->open("texture." + format, spec, config)) {
            return damaged(input->geterror());
        }
        return read_pixels(*input, spec, max_bytes);
    } catch (const std::exception& exception) {
        return damaged(exception.what());
    }
}

}  // namespace gh::load

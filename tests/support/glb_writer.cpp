#include "support/glb_writer.h"

#include <array>
#include <cstring>
#include <string_view>

namespace gh::test {
namespace {

void put(std::vector<std::byte>& to, const void* data, std::size_t size) {
    const auto* bytes = static_cast<const std::byte*>(data);
    to.insert(to.end(), bytes, bytes + size);
}

void put_u32(std::vector<std::byte>& to, std::uint32_t value) {
    put(to, &value, sizeof(value));
}

void put_big_endian(std::vector<std::byte>& to, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        to.push_back(static_cast<std::byte>((value >> shift) & 0xFFu));
}

std::uint32_t crc_of(const std::byte* data, std::size_t size) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (std::size_t i = 0; i < size; ++i) {
        crc ^= std::to_integer<std::uint32_t>(data[i]);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

void put_png_chunk(std::vector<std::byte>& to, std::string_view type, const std::vector<std::byte>& data) {
    put_big_endian(to, static_cast<std::uint32_t>(data.size()));
    const std::size_t begin = to.size();
    put(to, type.data(), type.size());
    put(to, data.data(), data.size());
    put_big_endian(to, crc_of(to.data() + begin, to.size() - begin));
}

// zlib's format with the bytes stored, not packed: at most 65535 of them.
std::vector<std::byte> stored_zlib(const std::vector<std::byte>& raw) {
    std::vector<std::byte> out{std::byte{0x78}, std::byte{0x01}, std::byte{1}};
    const auto size = static_cast<std::uint16_t>(raw.size());
    const auto complement = static_cast<std::uint16_t>(~size);
    put(out, &size, 2);
    put(out, &complement, 2);
    put(out, raw.data(), raw.size());
    std::uint32_t a = 1, b = 0;
    for (const std::byte byte : raw) {
        a = (a + std::to_integer<std::uint32_t>(byte)) % 65521u;
        b = (b + a) % 65521u;
    }
    put_big_endian(out, (b << 16) | a);
    return out;
}

std::vector<std::byte> png_of(int side, std::array<std::uint8_t, 3> color) {
    std::vector<std::byte> png;
    for (const unsigned byte : {0x89u, 0x50u, 0x4Eu, 0x47u, 0x0Du, 0x0Au, 0x1Au, 0x0Au}) {
        png.push_back(static_cast<std::byte>(byte));
    }
    std::vector<std::byte> header;
    put_big_endian(header, static_cast<std::uint32_t>(side));
    put_big_endian(header, static_cast<std::uint32_t>(side));
    for (const unsigned byte : {8u, 2u, 0u, 0u, 0u})
        header.push_back(static_cast<std::byte>(byte));  // 8 bits, RGB
    std::vector<std::byte> rows;
    for (int y = 0; y < side; ++y) {
        rows.push_back(std::byte{0});  // no filter
        for (int x = 0; x < side; ++x) put(rows, color.data(), color.size());
    }
    put_png_chunk(png, "IHDR", header);
    put_png_chunk(png, "IDAT", stored_zlib(rows));
    put_png_chunk(png, "IEND", {});
    return png;
}

std::string number(std::size_t value) {
    return std::to_string(value);
}

}  // namespace

int GlbWriter::add(const std::string& array, const std::string& json) {
    for (Array& known : arrays_) {
        if (known.name != array) continue;
        known.items.push_back(json);
        return static_cast<int>(known.items.size()) - 1;
    }
    arrays_.push_back({array, {json}});
    return 0;
}

int GlbWriter::add_view(const void* data, std::size_t size) {
    while (chunk_.size() % 4 != 0) chunk_.push_back(std::byte{0});
    const std::size_t offset = chunk_.size();
    put(chunk_, data, size);
    return add("bufferViews",
               R"({"buffer":0,"byteOffset":)" + number(offset) + R"(,"byteLength":)" + number(size) + "}");
}

int GlbWriter::add_accessor(int view, int component_type, std::size_t count, const std::string& type) {
    return add("accessors", R"({"bufferView":)" + std::to_string(view) + R"(,"componentType":)" +
                                std::to_string(component_type) + R"(,"count":)" + number(count) +
                                R"(,"type":")" + type + R"("})");
}

int GlbWriter::add_floats(const std::vector<float>& values, const std::string& type) {
    const std::size_t components = type == "SCALAR" ? 1
                                   : type == "MAT4" ? 16
                                                    : static_cast<std::size_t>(type[3] - '0');
    return add_accessor(add_view(values.data(), values.size() * sizeof(float)), 5126,
                        values.size() / components, type);
}

int GlbWriter::add_indices(const std::vector<std::uint16_t>& values) {
    return add_accessor(add_view(values.data(), values.size() * sizeof(std::uint16_t)), 5123, values.size(),
                        "SCALAR");
}

int GlbWriter::add_joints(const std::vector<std::uint8_t>& values) {
    return add_accessor(add_view(values.data(), values.size()), 5121, values.size() / 4, "VEC4");
}

int GlbWriter::add_image(int side, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    const std::vector<std::byte> png = png_of(side, {red, green, blue});
    const int view = add_view(png.data(), png.size());
    return add("images",
               R"({"name":"plain","mimeType":"image/png","bufferView":)" + std::to_string(view) + "}");
}

std::vector<std::byte> GlbWriter::finish(const std::string& rest) const {
    std::vector<std::byte> chunk = chunk_;
    while (chunk.size() % 4 != 0) chunk.push_back(std::byte{0});
    std::string json =
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" + number(chunk.size()) + "}]";
    for (const Array& array : arrays_) {
        json += ",\"" + array.name + "\":[";
        for (std::size_t i = 0; i < array.items.size(); ++i) json += (i > 0 ? ",\n" : "\n") + array.items[i];
        json += "]";
    }
    json += "," + rest + "}";
    while (json.size() % 4 != 0) json += ' ';

    std::vector<std::byte> file;
    put(file, "glTF", 4);
    put_u32(file, 2);
    put_u32(file, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + chunk.size()));
    put_u32(file, static_cast<std::uint32_t>(json.size()));
    put(file, "JSON", 4);
    put(file, json.data(), json.size());
    put_u32(file, static_cast<std::uint32_t>(chunk.size()));
    put(file, "BIN\0", 4);
    put(file, chunk.data(), chunk.size());
    return file;
}

}  // namespace gh::test

#include "load/png_check.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace gh::load {
namespace {

// CRC-32 as PNG and zip use it (polynomial 0xEDB88320, lowest bit first), a byte at a time.
constexpr std::array<std::uint32_t, 256> make_table() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t crc = i;
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
        table[i] = crc;
    }
    return table;
}
constexpr std::array<std::uint32_t, 256> kTable = make_table();

std::uint32_t crc_of(std::span<const unsigned char> bytes) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const unsigned char byte : bytes) crc = (crc >> 8) ^ kTable[(crc ^ byte) & 0xFFu];
    return ~crc;
}

std::uint32_t big_endian(std::span<const unsigned char> bytes) {
    return (std::uint32_t{bytes[0]} << 24) | (std::uint32_t{bytes[1]} << 16) |
           (std::uint32_t{bytes[2]} << 8) | bytes[3];
}

}  // namespace

std::optional<std::string> find_png_damage(std::span<const unsigned char> bytes) {
    constexpr std::size_t kSignature = 8, kAround = 12;  // a chunk's length, type and check sum
    std::span<const unsigned char> rest = bytes.subspan(kSignature);
    bool is_first = true;
    while (rest.size() >= kAround) {
        const std::size_t size = big_endian(rest);
        if (size > rest.size() - kAround) return "it is cut off";
        const std::span<const unsigned char> type_and_data = rest.subspan(4, 4 + size);
        const std::string_view type(reinterpret_cast<const char*>(type_and_data.data()), 4);
        if (big_endian(rest.subspan(8 + size)) != crc_of(type_and_data)) return "a check sum is wrong";
        if (is_first && (type != "IHDR" || size != 13)) return "its header is missing";
        if (is_first && (big_endian(rest.subspan(8)) == 0 || big_endian(rest.subspan(12)) == 0))
            return "it has no pixels";
        if (type == "IEND") return std::nullopt;
        is_first = false;
        rest = rest.subspan(kAround + size);
    }
    return "it is cut off";
}

}  // namespace gh::load

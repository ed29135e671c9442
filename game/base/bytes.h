// base/bytes.h - numbers to little-endian bytes and back, for our own file formats.
//
// Bad input a read beyond the end returns false, leaves its target alone, and the reader stays failed: a run
//           of reads can be checked once at its end. Nothing is ever allocated for more bytes than are there.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gh {

template <class T>
concept Number = (std::integral<T> && !std::same_as<T, bool>) || std::floating_point<T>;

class ByteWriter {
  public:
    template <Number T>
    void write(T value);
    void write_bytes(std::span<const std::byte> bytes);
    void write_string(std::string_view text);  // 32-bit length, then the bytes

    [[nodiscard]] const std::vector<std::byte>& bytes() const { return bytes_; }
    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    void clear() { bytes_.clear(); }

  private:
    std::vector<std::byte> bytes_;
};

class ByteReader {
  public:
    explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    template <Number T>
    bool read(T& value);
    // The next `count` bytes, still owned by the source.
    bool read_bytes(std::size_t count, std::span<const std::byte>& bytes);
    // Fails as well when the text is longer than `max_size`.
    bool read_string(std::string& text, std::size_t max_size);

    [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
    [[nodiscard]] std::size_t position() const { return at_; }
    [[nodiscard]] bool has_failed() const { return has_failed_; }

  private:
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
    bool has_failed_ = false;
};

namespace detail {

template <std::size_t Size>
struct UnsignedOf;
template <>
struct UnsignedOf<1> {
    using Type = std::uint8_t;
};
template <>
struct UnsignedOf<2> {
    using Type = std::uint16_t;
};
template <>
struct UnsignedOf<4> {
    using Type = std::uint32_t;
};
template <>
struct UnsignedOf<8> {
    using Type = std::uint64_t;
};

}  // namespace detail

template <Number T>
void ByteWriter::write(T value) {
    const auto bits = std::bit_cast<typename detail::UnsignedOf<sizeof(T)>::Type>(value);
    for (std::size_t i = 0; i < sizeof(T); ++i) {
        bytes_.push_back(static_cast<std::byte>((std::uint64_t{bits} >> (8 * i)) & 0xFFu));
    }
}

template <Number T>
bool ByteReader::read(T& value) {
    std::span<const std::byte> raw;
    if (!read_bytes(sizeof(T), raw)) return false;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) bits |= std::to_integer<std::uint64_t>(raw[i]) << (8 * i);
    value = std::bit_cast<T>(static_cast<typename detail::UnsignedOf<sizeof(T)>::Type>(bits));
    return true;
}

}  // namespace gh

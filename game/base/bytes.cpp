#include "base/bytes.h"

#include "base/contracts.h"

#include <limits>

namespace gh {

void ByteWriter::write_bytes(std::span<const std::byte> bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

void ByteWriter::write_string(std::string_view text) {
    EXPECTS(text.size() <= std::numeric_limits<std::uint32_t>::max());
    write(static_cast<std::uint32_t>(text.size()));
    write_bytes(std::as_bytes(std::span(text)));
}

bool ByteReader::read_bytes(std::size_t count, std::span<const std::byte>& bytes) {
    if (has_failed_ || count > left()) {
        has_failed_ = true;
        return false;
    }
    bytes = bytes_.subspan(at_, count);
    at_ += count;
    return true;
}

bool ByteReader::read_string(std::string& text, std::size_t max_size) {
    std::uint32_t size = 0;
    std::span<const std::byte> raw;
    if (!read(size)) return false;
    if (size > max_size) {
        has_failed_ = true;
        return false;
    }
    if (!read_bytes(size, raw)) return false;
    text.clear();
    for (const std::byte b : raw) text.push_back(static_cast<char>(b));
    return true;
}

}  // namespace gh

#include "load/gltf_envelope.h"

#include "base/bytes.h"
#include "load/limits.h"

#include <fmt/format.h>

namespace gh::load {
namespace {

constexpr std::uint32_t kGltfMagic = 0x46546C67u;  // "glTF"
constexpr std::uint32_t kJson = 0x4E4F534Au;
constexpr std::uint32_t kBin = 0x004E4942u;

std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Chunk {
    std::uint32_t type = 0;
    std::span<const std::byte> bytes;
};

Result<Chunk> next_chunk(ByteReader& reader) {
    std::uint32_t size = 0;
    Chunk chunk;
    reader.read(size);
    reader.read(chunk.type);
    if (reader.has_failed()) return Error{"ends within a chunk header: the file is cut off"};
    const std::size_t left = reader.left();
    if (!reader.read_bytes(size, chunk.bytes)) {
        return Error{fmt::format("a chunk of {} bytes has only {} left: the file is cut off", size, left)};
    }
    return chunk;
}

Result<GltfEnvelope> open_binary(std::span<const std::byte> bytes) {
    ByteReader reader(bytes);
    std::uint32_t magic = 0, version = 0, length = 0;
    reader.read(magic);
    reader.read(version);
    reader.read(length);
    if (reader.has_failed()) return Error{"ends within its header: the file is cut off"};
    if (version != 2) return Error{fmt::format("is glTF binary version {}, only version 2 is read", version)};
    if (length > bytes.size()) {
        return Error{
            fmt::format("says it has {} bytes but has {}: the file is cut off", length, bytes.size())};
    }
    reader = ByteReader(bytes.first(length));
    std::span<const std::byte> header;
    if (!reader.read_bytes(12, header)) return Error{"says it is shorter than its own header"};

    Result<Chunk> json = next_chunk(reader);
    if (!json) return json.error();
    if (json->type != kJson) return Error{"its first chunk is not JSON"};
    GltfEnvelope envelope{as_text(json->bytes), {}, true};
    while (reader.left() > 0) {  // chunks of unknown type may follow and are skipped
        Result<Chunk> chunk = next_chunk(reader);
        if (!chunk) return chunk.error();
        if (chunk->type == kBin && envelope.chunk.empty()) envelope.chunk = chunk->bytes;
    }
    return envelope;
}

// Walks the text once, knowing only strings, brackets and commas.
class JsonScan {
  public:
    explicit JsonScan(std::string_view text) : text_(text) {}

    Result<void> scan() {
        for (; at_ < text_.size(); ++at_) {
            if (Result<void> step = take(text_[at_]); !step) return step;
        }
        return {};
    }

    [[nodiscard]] std::size_t buffers() const { return buffers_; }

  private:
    Result<void> take(char c) {
        switch (c) {
            case '"':
                return take_string();
            case '{':
                if (++objects_ > kMaxJsonObjects) return too_many("objects", kMaxJsonObjects);
                if (depth_ == 2 && is_in_buffers_ && ++buffers_ > kMaxBuffers) {
                    return too_many("buffers", kMaxBuffers);
                }
                [[fallthrough]];
            case '[':
                if (++depth_ > kMaxJsonDepth) {
                    return Error{fmt::format("its JSON is nested more than {} deep", kMaxJsonDepth)};
                }
                break;
            case '}':
            case ']':
                --depth_;
                break;
            case ',':
                if (++values_ > kMaxJsonValues) return too_many("values", kMaxJsonValues);
                break;
            default:
                break;
        }
        return {};
    }

    // A key of the outermost object decides what the arrays below it are. An escaped key would hide its name.
    Result<void> take_string() {
        const std::size_t begin = ++at_;
        bool is_escaped = false;
        while (at_ < text_.size() && text_[at_] != '"') {
            if (text_[at_] == '\\') {
                is_escaped = true;
                ++at_;
            }
            ++at_;
        }
        if (depth_ != 1 || at_ >= text_.size()) return {};
        if (is_escaped) return Error{"a key of its outermost JSON object has an escape in it"};
        is_in_buffers_ = text_.substr(begin, at_ - begin) == "buffers";
        return {};
    }

    static Error too_many(std::string_view what, std::size_t most) {
        return Error{fmt::format("its JSON has more than {} {}", most, what)};
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool is_in_buffers_ = false;
    std::size_t objects_ = 0, values_ = 0, buffers_ = 0;
};

}  // namespace

Result<GltfEnvelope> open_envelope(std::span<const std::byte> bytes) {
    if (bytes.empty()) return Error{"is empty"};
    ByteReader reader(bytes);
    std::uint32_t magic = 0;
    if (reader.read(magic) && magic == kGltfMagic) return open_binary(bytes);
    for (const char c : as_text(bytes)) {  // a .gltf begins with its outermost object
        if (c == '{') return GltfEnvelope{as_text(bytes), {}, false};
        if (c != ' ' && c != '\t' && c != '\n' && c != '\r') break;
    }
    return Error{"is neither a .glb nor a .gltf file"};
}

Result<void> check_json_limits(const GltfEnvelope& envelope) {
    if (envelope.json.size() > kMaxJsonBytes) {
        return Error{
            fmt::format("its JSON has {} bytes, the most is {}", envelope.json.size(), kMaxJsonBytes)};
    }
    JsonScan scan(envelope.json);
    if (Result<void> within = scan.scan(); !within) return within;
    if (scan.buffers() > 1 && scan.buffers() * envelope.chunk.size() > kMaxFileBytes) {
        return Error{
            fmt::format("has {} buffers that may each be {} bytes", scan.buffers(), envelope.chunk.size())};
    }
    return {};
}

}  // namespace gh::load

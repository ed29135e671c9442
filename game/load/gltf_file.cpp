#include "load/gltf_file.h"

#include "base/file.h"
#include "load/gltf_envelope.h"
#include "load/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>
#include <string_view>

namespace gh::load {
namespace {

// What we can do without, or do. A file that requires anything else would be shown wrongly, so it is refused.
constexpr std::array<std::string_view, 12> kKnownExtensions{
    "KHR_lights_punctual",      "KHR_materials_emissive_strength",
    "KHR_materials_ior",        "KHR_materials_transmission",
    "KHR_materials_volume",     "KHR_materials_specular",
    "KHR_texture_transform",    "KHR_mesh_quantization",
    "KHR_materials_clearcoat",  "KHR_materials_sheen",
    "KHR_materials_anisotropy", "KHR_materials_unlit"};

bool is_read(const std::string& extension) {
    return std::find(kKnownExtensions.begin(), kKnownExtensions.end(), extension) != kKnownExtensions.end();
}

// Side files: below one folder, and together no larger than the limit.
struct SideFiles {
    std::filesystem::path base_dir;
    std::size_t bytes_left = kMaxExternalBytes;
    std::string refusal;  // the first that could not be read
};

bool stays_below(const std::filesystem::path& path) {
    return !path.is_absolute() &&
           std::none_of(path.begin(), path.end(), [](const auto& step) { return step == ".."; });
}

bool side_file_exists(const std::string& path, void*) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error);
}

std::string same_path(const std::string& path, void*) {
    return path;
}

bool read_side_file(std::vector<unsigned char>* out, std::string* error, const std::string& path,
                    void* user) {
    SideFiles& files = *static_cast<SideFiles*>(user);
    const auto refuse = [&](const std::string& sentence) {
        if (error != nullptr) *error = sentence;
        if (files.refusal.empty()) files.refusal = sentence;
        return false;
    };
    if (files.base_dir.empty() ||
        !stays_below(std::filesystem::path(path).lexically_relative(files.base_dir))) {
        return refuse(fmt::format("{} is not below the level's own folder", path));
    }
    Result<std::vector<std::byte>> bytes = read_file(path, files.bytes_left);
    if (!bytes) return refuse(bytes.error().sentence);
    files.bytes_left -= bytes->size();
    const auto* begin = reinterpret_cast<const unsigned char*>(bytes->data());
    out->assign(begin, begin + bytes->size());
    return true;
}

// Images in a buffer view are left alone: their bytes' range is not checked yet. Others are kept as they
// came. The parameters are the parser's choice.
// NOLINTNEXTLINE(readability-function-size)
bool keep_image(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
                int size, void*) {
    if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
    return true;
}

bool parse(const GltfEnvelope& envelope, std::span<const std::byte> bytes, SideFiles& files,
           tinygltf::Model& model, std::string& error) {
    tinygltf::TinyGLTF parser;
    std::string warning;
    parser.SetImageLoader(&keep_image, nullptr);
    parser.SetFsCallbacks({&side_file_exists, &same_path, &read_side_file, nullptr, &files});
    const std::string base = files.base_dir.string();
    if (envelope.is_binary) {
        return parser.LoadBinaryFromMemory(&model, &error, &warning,
                                           reinterpret_cast<const unsigned char*>(bytes.data()),
                                           static_cast<unsigned>(bytes.size()), base);
    }
    return parser.LoadASCIIFromString(&model, &error, &warning, envelope.json.data(),
                                      static_cast<unsigned>(envelope.json.size()), base);
}

// The parser's own words, as one line.
std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
    constexpr std::size_t kMost = 300;
    if (text.size() > kMost) text = text.substr(0, kMost) + "...";
    return text.empty() ? "it is not valid glTF" : text;
}

Result<void> check_model(const tinygltf::Model& model) {
    if (model.asset.version != "2.0" && !model.asset.version.starts_with("2.")) {
        return Error{fmt::format("is glTF version '{}', only 2.x is read", model.asset.version)};
    }
    for (const std::string& extension : model.extensionsRequired) {
        if (!is_read(extension))
            return Error{fmt::format("requires the extension {}, which is not read", extension)};
    }
    return {};
}

}  // namespace

Result<tinygltf::Model> parse_gltf(std::span<const std::byte> bytes, const std::filesystem::path& base_dir) {
    if (bytes.size() > kMaxFileBytes) {
        return Error{fmt::format("has {} bytes, the most is {}", bytes.size(), kMaxFileBytes)};
    }
    const Result<GltfEnvelope> envelope = open_envelope(bytes);
    if (!envelope) return envelope.error();
    if (const Result<void> limits = check_json_limits(*envelope); !limits) return limits.error();

    SideFiles files{base_dir, kMaxExternalBytes, {}};
    tinygltf::Model model;
    std::string error;
    bool is_parsed = false;
    try {
        is_parsed = parse(*envelope, bytes, files, model, error);
    } catch (const std::exception& exception) {  // the parser throws on some malformed values
        error = exception.what();
    }
    if (!is_parsed) return Error{one_line(files.refusal.empty() ? error : files.refusal)};
    if (const Result<void> check = check_model(model); !check) return check.error();
    return model;
}

std::vector<std::string> unread_extensions(const tinygltf::Model& model) {
    std::vector<std::string> unread;
    for (const std::string& extension : model.extensionsUsed) {
        if (!is_read(extension)) unread.push_back(extension);
    }
    return unread;
}

std::string name_or_number(const std::string& name, std::size_t number) {
    return name.empty() ? fmt::format("number {}", number) : fmt::format("'{}'", name);
}

}  // namespace gh::load

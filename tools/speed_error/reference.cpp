#include "reference.h"

#include "base/file.h"
#include "base/hash.h"
#include "base/progress.h"
#include "metrics/picture_metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

namespace speed_error {

namespace {

constexpr std::uint32_t kVersion = 2;
constexpr int kSamplesAtOnce = 16;  // a picture of more would show no progress

struct Header {
    std::uint64_t key;
    double own_error;
    std::int32_t width, height;
};

std::uint64_t key_of(const std::string& truth, const View& view, const ReferenceSettings& settings) {
    gh::Hasher hash;
    hash.add(kVersion);
    for (const char c : truth) hash.add(static_cast<std::uint8_t>(c));
    hash.add(settings.samples_per_pixel);
    hash.add(view.key);
    hash.add(settings.width);
    hash.add(settings.height);
    return hash.digest();
}

// Nothing when there is no such file or it is of something else.
bool read(const std::filesystem::path& path, Reference& result, const ReferenceSettings& settings) {
    const auto bytes = gh::read_file(path, std::size_t{1} << 30);
    const std::size_t pixels =
        static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height);
    if (!bytes || bytes->size() != sizeof(Header) + pixels * sizeof(glm::vec3)) return false;
    Header header{};
    std::memcpy(&header, bytes->data(), sizeof(header));
    if (header.key != result.key || header.width != settings.width || header.height != settings.height)
        return false;
    result.own_error = header.own_error;
    result.picture = gh::Image(settings.width, settings.height);
    std::memcpy(result.picture.pixels.data(), bytes->data() + sizeof(header), pixels * sizeof(glm::vec3));
    return true;
}

gh::Result<void> write(const std::filesystem::path& path, const Reference& reference) {
    const Header header{reference.key, reference.own_error, reference.picture.width,
                        reference.picture.height};
    std::vector<std::byte> bytes(sizeof(header) + reference.picture.pixels.size() * sizeof(glm::vec3));
    std::memcpy(bytes.data(), &header, sizeof(header));
    std::memcpy(bytes.data() + sizeof(header), reference.picture.pixels.data(),
                bytes.size() - sizeof(header));
    return gh::write_file_atomically(path, std::span<const std::byte>(bytes));
}

}  // namespace

gh::Result<Reference> reference(const std::string& truth, const View& view, const ReferenceSettings& settings,
                                const gh::Jobs& jobs) {
    Reference result;
    result.key = key_of(truth, view, settings);
    const std::filesystem::path path = settings.folder / fmt::format("{}_{}.reference", view.name, truth);
    if (read(path, result, settings)) return result;

    const int samples = std::min(kSamplesAtOnce, std::max(1, settings.samples_per_pixel / 2));
    const Run make = truth_of(truth, samples).begin();
    const int parts = std::max(1, settings.samples_per_pixel / 2 / samples);
    gh::Image half[2] = {gh::Image(settings.width, settings.height),
                         gh::Image(settings.width, settings.height)};
    gh::render::Film film(settings.width, settings.height);
    gh::Progress progress(fmt::format("reference {}, {}", view.name, truth),
                          static_cast<std::size_t>(2 * parts));
    for (int part = 0; part < 2 * parts; ++part) {
        make({.scene = view.studio.lit_view(),
              .camera = view.camera,
              .seed = 0x10000u + static_cast<std::uint32_t>(part),
              .jobs = jobs},
             film);
        gh::Image& sum = half[part % 2];
        for (std::size_t i = 0; i < sum.pixels.size(); ++i)
            sum.pixels[i] += film.radiance.pixels[i] / static_cast<float>(parts);
        progress.show(static_cast<std::size_t>(part + 1));
    }
    result.picture = half[0];
    for (std::size_t i = 0; i < result.picture.pixels.size(); ++i)
        result.picture.pixels[i] = 0.5f * (half[0].pixels[i] + half[1].pixels[i]);
    // The halves differ by twice the variance of one, which is twice that of their mean.
    result.own_error = 0.25 * metrics::rel_mse(half[0], half[1]).all;
    if (auto written = write(path, result); !written) return written.error();
    return result;
}

}  // namespace speed_error

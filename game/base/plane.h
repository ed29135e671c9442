// base/plane.h - one number a pixel, a plane a quantity: what the path tracer leaves and the filters read and write, many
// pixels at a time.
//
// Layout    rows run top to bottom and are padded to whole vectors of 16; two rows and kMargin numbers of slack lie above the
//           first and below the last. A kernel may so read any neighbour within kMargin of any pixel of a row, or in the
//           two rows above or below, and look afterwards whether it was one. What slack holds is never part of an answer.
// Cost      4 bytes a pixel. No access allocates but resize(), fit() and copying.
#pragma once

#include "base/contracts.h"
#include "base/plane_block.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace gh {

template <class T>
class PlaneOf {
    static_assert(sizeof(T) == 4);

  public:
    static constexpr std::size_t kMargin = 64;

    PlaneOf() = default;
    PlaneOf(int width, int height, T value = T{}) { resize(width, height, value); }
    PlaneOf(const PlaneOf& other) { *this = other; }
    PlaneOf(PlaneOf&&) noexcept = default;
    PlaneOf& operator=(PlaneOf&&) noexcept = default;
    PlaneOf& operator=(const PlaneOf& other) {
        if (this == &other) return *this;
        if (other.block_ == nullptr) return *this = PlaneOf();
        fit(other.width_, other.height_);
        std::copy_n(other.numbers_, count(width_, height_), numbers_);
        return *this;
    }
    ~PlaneOf() = default;

    // Every pixel becomes `value`. Both sides >= 0.
    void resize(int width, int height, T value = T{}) {
        if (!has_size(width, height)) take(make_plane_block(bytes(width, height)), 0, width, height);
        fill(value);
    }
    // Keeps its contents if it has that size already; else every pixel becomes 0.
    void fit(int width, int height) {
        if (!has_size(width, height)) resize(width, height);
    }
    [[nodiscard]] bool has_size(int width, int height) const {
        return block_ != nullptr && width_ == width && height_ == height;
    }
    // Every number, slack among them.
    void fill(T value) { std::fill_n(numbers_, count(width_, height_), value); }

    // For fit_together(): what a plane takes of a block, and to live there, `offset` bytes on, unfilled.
    [[nodiscard]] static std::size_t bytes(int width, int height) {
        EXPECTS(width >= 0 && height >= 0);
        return (count(width, height) + kMostStagger) * sizeof(T);
    }
    void take(std::shared_ptr<std::byte> block, std::size_t offset, int width, int height) {
        EXPECTS(offset % (kLine * sizeof(T)) == 0);
        width_ = width;
        height_ = height;
        stride_ = stride_of(width);
        block_ = std::move(block);
        numbers_ = static_cast<T*>(static_cast<void*>(block_.get() + offset)) + stagger();
    }

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] bool empty() const { return width_ == 0 || height_ == 0; }
    // Numbers from one row to the next.
    [[nodiscard]] std::ptrdiff_t stride() const { return static_cast<std::ptrdiff_t>(stride_); }

    // 64-byte aligned.
    [[nodiscard]] T* row(int y) { return numbers_ + offset(y); }
    [[nodiscard]] const T* row(int y) const { return numbers_ + offset(y); }
    [[nodiscard]] T& at(int x, int y) {
        EXPECTS(0 <= x && x < width_);
        return row(y)[x];
    }
    [[nodiscard]] const T& at(int x, int y) const {
        EXPECTS(0 <= x && x < width_);
        return row(y)[x];
    }

  private:
    static constexpr std::size_t kLine = 16;  // numbers
    static constexpr std::size_t kMostStagger = 64 * kLine;

    [[nodiscard]] static std::size_t stride_of(int width) {
        return (static_cast<std::size_t>(width) + kLine - 1) / kLine * kLine;
    }
    [[nodiscard]] static std::size_t count(int width, int height) {
        return stride_of(width) * static_cast<std::size_t>(height + 4) + 2 * kMargin;
    }
    [[nodiscard]] std::size_t offset(int y) const {
        EXPECTS(0 <= y && y < height_);
        return kMargin + static_cast<std::size_t>(y + 2) * stride_;
    }

    // Large blocks of memory all begin at the same place of a page; a kernel that walks a dozen planes at once would ask
    // one set of the cache for all of them (measured on make_guides: 1.5 times as long). So each plane begins a different
    // number of lines into its block: one taken from where it lives, for siblings differ in that.
    [[nodiscard]] std::size_t stagger() const {
        return reinterpret_cast<std::uintptr_t>(this) / 16 * 11 % 64 * kLine;
    }

    int width_ = 0, height_ = 0;
    std::size_t stride_ = 0;
    T* numbers_ = nullptr;              // in the block
    std::shared_ptr<std::byte> block_;  // that of its siblings maybe
};

using Plane = PlaneOf<float>;
using PlaneU32 = PlaneOf<std::uint32_t>;

// Planes that are read side by side get a block of memory in common, unless all have that size already; then every pixel
// becomes 0.
template <class... Planes>
void fit_together(int width, int height, Planes&... planes) {
    if ((planes.has_size(width, height) && ...)) return;
    const std::shared_ptr<std::byte> block = make_plane_block((planes.bytes(width, height) + ...));
    std::size_t offset = 0;
    const auto take = [&](auto& plane) {
        plane.take(block, offset, width, height);
        plane.fill({});
        offset += plane.bytes(width, height);
    };
    (take(planes), ...);
}

// A vector or a colour (x red, y green, z blue) a pixel.
struct Plane3 {
    Plane x, y, z;

    Plane3() = default;
    Plane3(int width, int height, const glm::vec3& value = glm::vec3(0.0f)) { resize(width, height, value); }

    void resize(int width, int height, const glm::vec3& value = glm::vec3(0.0f)) {
        fit(width, height);
        fill(value);
    }
    void fit(int width, int height) { fit_together(width, height, x, y, z); }
    [[nodiscard]] bool has_size(int width, int height) const {
        return x.has_size(width, height) && y.has_size(width, height) && z.has_size(width, height);
    }
    void fill(const glm::vec3& value) {
        x.fill(value.x);
        y.fill(value.y);
        z.fill(value.z);
    }
    [[nodiscard]] static std::size_t bytes(int width, int height) { return 3 * Plane::bytes(width, height); }
    void take(const std::shared_ptr<std::byte>& block, std::size_t offset, int width, int height) {
        for (Plane* plane : {&x, &y, &z}) {
            plane->take(block, offset, width, height);
            offset += Plane::bytes(width, height);
        }
    }
    [[nodiscard]] bool empty() const { return x.empty(); }
    [[nodiscard]] int width() const { return x.width(); }
    [[nodiscard]] int height() const { return x.height(); }
    [[nodiscard]] glm::vec3 get(int i, int j) const { return {x.at(i, j), y.at(i, j), z.at(i, j)}; }
    // Of a colour.
    [[nodiscard]] float luminance_at(int i, int j) const {
        return (0.2126f * x.at(i, j) + 0.7152f * y.at(i, j)) + 0.0722f * z.at(i, j);
    }
    void set(int i, int j, const glm::vec3& value) {
        x.at(i, j) = value.x;
        y.at(i, j) = value.y;
        z.at(i, j) = value.z;
    }
};

}  // namespace gh

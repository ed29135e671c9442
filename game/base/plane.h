// base/plane.h - one number a pixel, a plane a quantity: what the path tracer leaves and the filters read and write, many
// pixels at a time.
//
// Layout    rows run top to bottom and are padded to whole vectors of 16; a row and kMargin numbers of slack lie above the
//           first and below the last. A kernel may so read any neighbour within kMargin of any pixel of a row, or in the
//           row above or below, and look afterwards whether it was one. What slack holds is never part of an answer.
// Cost      4 bytes a pixel. No access allocates but resize().
#pragma once

#include "base/contracts.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gh {

template <class T>
class PlaneOf {
    static_assert(sizeof(T) == 4);

  public:
    static constexpr std::size_t kMargin = 64;

    PlaneOf() = default;
    PlaneOf(int width, int height, T value = T{}) { resize(width, height, value); }

    // Every pixel becomes `value`. Both sides >= 0.
    void resize(int width, int height, T value = T{}) {
        EXPECTS(width >= 0 && height >= 0);
        width_ = width;
        height_ = height;
        stride_ = (static_cast<std::size_t>(width) + kLine - 1) / kLine * kLine;
        stagger_ = stagger();
        const std::size_t count = stride_ * static_cast<std::size_t>(height + 2) + 2 * kMargin + stagger_;
        Line line;
        for (T& number : line.numbers) number = value;
        lines_.assign(count / kLine, line);
    }
    // Keeps its contents if it has that size already.
    void fit(int width, int height) {
        if (width_ != width || height_ != height || lines_.empty()) resize(width, height);
    }

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] bool empty() const { return width_ == 0 || height_ == 0; }
    // Numbers from one row to the next.
    [[nodiscard]] std::ptrdiff_t stride() const { return static_cast<std::ptrdiff_t>(stride_); }

    // 64-byte aligned.
    [[nodiscard]] T* row(int y) { return lines_.data()->numbers + offset(y); }
    [[nodiscard]] const T* row(int y) const { return lines_.data()->numbers + offset(y); }
    [[nodiscard]] T& at(int x, int y) {
        EXPECTS(0 <= x && x < width_);
        return row(y)[x];
    }
    [[nodiscard]] const T& at(int x, int y) const {
        EXPECTS(0 <= x && x < width_);
        return row(y)[x];
    }

  private:
    static constexpr std::size_t kLine = 16;
    struct alignas(64) Line {
        T numbers[kLine];
    };

    [[nodiscard]] std::size_t offset(int y) const {
        EXPECTS(0 <= y && y < height_);
        return stagger_ + kMargin + static_cast<std::size_t>(y + 1) * stride_;
    }

    // Large blocks of memory all begin at the same place of a page; a kernel that walks a dozen planes at once would ask
    // one set of the cache for all of them (measured on make_guides: 1.5 times as long). So each plane begins a different
    // number of lines into its block: one taken from where it lives, for siblings differ in that.
    [[nodiscard]] std::size_t stagger() const {
        return reinterpret_cast<std::uintptr_t>(this) / 16 * 11 % 64 * kLine;
    }

    int width_ = 0, height_ = 0;
    std::size_t stride_ = 0, stagger_ = 0;
    std::vector<Line> lines_;
};

using Plane = PlaneOf<float>;
using PlaneU32 = PlaneOf<std::uint32_t>;

// A vector or a colour (x red, y green, z blue) a pixel.
struct Plane3 {
    Plane x, y, z;

    Plane3() = default;
    Plane3(int width, int height, const glm::vec3& value = glm::vec3(0.0f))
        : x(width, height, value.x), y(width, height, value.y), z(width, height, value.z) {}

    void resize(int width, int height, const glm::vec3& value = glm::vec3(0.0f)) {
        x.resize(width, height, value.x);
        y.resize(width, height, value.y);
        z.resize(width, height, value.z);
    }
    void fit(int width, int height) {
        x.fit(width, height);
        y.fit(width, height);
        z.fit(width, height);
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

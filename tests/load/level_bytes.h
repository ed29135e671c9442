// Changing a level's bytes on purpose, and loading them.
#pragma once

#include "load/level_loader.h"
#include "support/tiny_level.h"
#include "world/level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace gh::test {

using Bytes = std::vector<std::byte>;

// Replaces the first `from` by `to`, which must be as long, so that no size in the file changes.
inline Bytes with(Bytes bytes, std::string_view from, std::string_view to) {
    EXPECT_EQ(from.size(), to.size());
    const auto* begin = reinterpret_cast<const char*>(bytes.data());
    const std::size_t at = std::string_view(begin, bytes.size()).find(from);
    EXPECT_NE(at, std::string_view::npos) << from << " is not in the file";
    if (at != std::string_view::npos) std::memcpy(bytes.data() + at, to.data(), to.size());
    return bytes;
}

template <class T>
std::string_view raw(const T& value) {
    return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

inline Result<world::Level> load_quickly(const Bytes& bytes) {
    return load::load_level_from_memory(bytes, "tiny.glb", {}, {.finds_ways = false});
}

// The sentence a broken file is refused with; empty when it was not refused.
inline std::string refusal(const Bytes& bytes) {
    const Result<world::Level> level = load_quickly(bytes);
    return level ? std::string() : level.error().sentence;
}

inline Bytes as_bytes(const std::string& text) {
    const auto* begin = reinterpret_cast<const std::byte*>(text.data());
    return {begin, begin + text.size()};
}

template <class T>
const T* named(const std::vector<T>& items, std::string_view name) {
    const auto found =
        std::find_if(items.begin(), items.end(), [&](const T& item) { return item.name == name; });
    return found == items.end() ? nullptr : &*found;
}

// Two points, equal to what a few roundings of metres may do.
inline void expect_near(const glm::vec3& actual, const glm::vec3& expected) {
    for (glm::length_t i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], 1e-5f) << "component " << i;
}

}  // namespace gh::test

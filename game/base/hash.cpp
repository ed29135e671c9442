#include "base/hash.h"

#include <fmt/format.h>

#include <bit>
#include <new>
#define XXH_STATIC_LINKING_ONLY  // shows the state's layout, so that a Hasher needs no heap
#include <xxhash.h>

namespace gh {

static_assert(std::endian::native == std::endian::little, "fields are hashed as they lie in memory");
static_assert(sizeof(XXH64_state_t) == 88 && alignof(XXH64_state_t) <= 8);

namespace {

XXH64_state_t* as_state(void* storage) {
    return std::launder(static_cast<XXH64_state_t*>(storage));
}

}  // namespace

Hasher::Hasher(std::uint64_t seed) {
    auto* state = new (state_.data()) XXH64_state_t{};
    XXH64_reset(state, seed);
}

void Hasher::flush() {
    XXH64_update(as_state(state_.data()), waiting_.data(), waiting_size_);
    waiting_size_ = 0;
}

void Hasher::add(const glm::vec2& value) {
    add(value.x);
    add(value.y);
}

void Hasher::add(const glm::vec3& value) {
    add(value.x);
    add(value.y);
    add(value.z);
}

void Hasher::add(const glm::vec4& value) {
    add(glm::vec3(value));
    add(value.w);
}

void Hasher::add(const glm::quat& value) {
    add(glm::vec3(value.x, value.y, value.z));
    add(value.w);
}

void Hasher::add(std::span<const std::byte> bytes) {
    flush();
    if (!bytes.empty()) XXH64_update(as_state(state_.data()), bytes.data(), bytes.size());
}

void Hasher::add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    add(std::as_bytes(std::span(text)));
}

std::uint64_t Hasher::digest() const {
    Hasher finished = *this;
    finished.flush();
    return XXH64_digest(as_state(finished.state_.data()));
}

std::uint64_t hash_bytes(std::span<const std::byte> bytes) {
    Hasher hasher;
    hasher.add(bytes);
    return hasher.digest();
}

std::string hex16(std::uint64_t value) {
    return fmt::format("{:016x}", value);
}

}  // namespace gh

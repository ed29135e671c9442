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
const XXH64_state_t* as_state(const void* storage) {
    return std::launder(static_cast<const XXH64_state_t*>(storage));
}

}  // namespace

Hasher::Hasher(std::uint64_t seed) {
    auto* state = new (state_.data()) XXH64_state_t{};
    XXH64_reset(state, seed);
}

void Hasher::add_bytes(const void* data, std::size_t size) {
    if (size == 0) return;
    XXH64_update(as_state(state_.data()), data, size);
}

void Hasher::add(bool value) {
    add(static_cast<std::uint8_t>(value ? 1 : 0));
}
void Hasher::add(std::uint8_t value) {
    add_bytes(&value, sizeof value);
}
void Hasher::add(std::uint16_t value) {
    add_bytes(&value, sizeof value);
}
void Hasher::add(std::uint32_t value) {
    add_bytes(&value, sizeof value);
}
void Hasher::add(std::uint64_t value) {
    add_bytes(&value, sizeof value);
}
void Hasher::add(float value) {
    add_bytes(&value, sizeof value);
}
void Hasher::add(double value) {
    add_bytes(&value, sizeof value);
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
    add_bytes(bytes.data(), bytes.size());
}

void Hasher::add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    add_bytes(text.data(), text.size());
}

std::uint64_t Hasher::digest() const {
    return XXH64_digest(as_state(state_.data()));
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

#include "load/gltf_extras.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace gh::load {
namespace {

// Null when there is no such property.
const tinygltf::Value* find(const tinygltf::Value& extras, const char* key) {
    if (!extras.IsObject() || !extras.Has(key)) return nullptr;
    return &extras.Get(key);
}

Error wrong_type(const char* key, const char* wanted) {
    return Error{fmt::format("property '{}' must be {}", key, wanted)};
}

std::optional<float> as_float(const tinygltf::Value& value) {
    if (!value.IsNumber()) return std::nullopt;
    const double number = value.GetNumberAsDouble();
    constexpr double kMost = 1.0e9;  // whatever it measures: nothing in a level is larger
    if (!(std::abs(number) <= kMost)) return std::nullopt;
    return static_cast<float>(number);
}

}  // namespace

Result<std::string> text_or(const tinygltf::Value& extras, const char* key, const std::string& fallback) {
    const tinygltf::Value* value = find(extras, key);
    if (value == nullptr) return fallback;
    if (!value->IsString()) return wrong_type(key, "a text");
    return value->Get<std::string>();
}

Result<float> number_or(const tinygltf::Value& extras, const char* key, float fallback) {
    const tinygltf::Value* value = find(extras, key);
    if (value == nullptr) return fallback;
    const std::optional<float> number = as_float(*value);
    if (!number) return wrong_type(key, "a number");
    return *number;
}

Result<bool> flag_or(const tinygltf::Value& extras, const char* key, bool fallback) {
    const tinygltf::Value* value = find(extras, key);
    if (value == nullptr) return fallback;
    if (value->IsBool()) return value->Get<bool>();
    if (value->IsNumber()) return value->GetNumberAsDouble() != 0.0;
    return wrong_type(key, "true or false");
}

Result<glm::vec3> vector_or(const tinygltf::Value& extras, const char* key, const glm::vec3& fallback) {
    const tinygltf::Value* value = find(extras, key);
    if (value == nullptr) return fallback;
    if (!value->IsArray() || value->ArrayLen() != 3) return wrong_type(key, "three numbers");
    glm::vec3 vector{0.0f};
    for (int i = 0; i < 3; ++i) {
        const std::optional<float> number = as_float(value->Get(i));
        if (!number) return wrong_type(key, "three numbers");
        vector[static_cast<glm::length_t>(i)] = *number;
    }
    return vector;
}

std::vector<std::string> split_names(const std::string& names) {
    std::vector<std::string> result;
    std::string_view rest = names;
    while (!rest.empty()) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        std::string_view name = rest.substr(0, comma);
        rest.remove_prefix(std::min(comma + 1, rest.size()));
        while (!name.empty() && name.front() == ' ') name.remove_prefix(1);
        while (!name.empty() && name.back() == ' ') name.remove_suffix(1);
        if (!name.empty()) result.emplace_back(name);
    }
    return result;
}

}  // namespace gh::load

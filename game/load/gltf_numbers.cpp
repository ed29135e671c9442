#include "load/gltf_numbers.h"

#include <fmt/format.h>

#include <algorithm>

namespace gh::load {

using tinygltf::Value;

const Value* member(const Value* object, const char* key) {
    return object != nullptr && object->IsObject() && object->Has(key) ? &object->Get(key) : nullptr;
}

const Value* extension(const tinygltf::ExtensionMap& extensions, const char* name) {
    const auto found = extensions.find(name);
    return found == extensions.end() ? nullptr : &found->second;
}

void NumberReader::remark(const std::string& sentence) const {
    remarks_.push_back(fmt::format("{}: {}", whose_, sentence));
}

double NumberReader::nearest(const std::string& name, double value, const Range& range) const {
    if (value >= range.low && value <= range.high) return value;
    const double inside = value > range.high ? range.high : range.low;
    remark(fmt::format("{} {} is not between {} and {} and counts as {}", name, value, range.low, range.high,
                       inside));
    return inside;
}

double NumberReader::exact_number(const Value* object, const char* key, double fallback,
                                  const Range& range) const {
    const Value* value = member(object, key);
    if (value == nullptr) return fallback;
    if (value->IsNumber()) return nearest(key, value->GetNumberAsDouble(), range);
    remark(fmt::format("{} is no number and counts as {}", key, fallback));
    return fallback;
}

float NumberReader::element(const Value* object, const char* key, int i, double fallback,
                            const Range& range) const {
    const Value* array = member(object, key);
    if (array == nullptr) return static_cast<float>(fallback);
    const std::string name = fmt::format("{}[{}]", key, i);
    const bool is_there = array->IsArray() && static_cast<std::size_t>(i) < array->ArrayLen();
    if (is_there && array->Get(i).IsNumber()) return within(name, array->Get(i).GetNumberAsDouble(), range);
    remark(fmt::format("{} is no number and counts as {}", name, fallback));
    return static_cast<float>(fallback);
}

glm::vec3 NumberReader::color(const Value* object, const char* key, double fallback,
                              const Range& range) const {
    return {element(object, key, 0, fallback, range), element(object, key, 1, fallback, range),
            element(object, key, 2, fallback, range)};
}

}  // namespace gh::load

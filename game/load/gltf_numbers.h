// load/gltf_numbers.h - numbers of glTF's materials and their extensions, each within the range that makes sense.
//
// Bad input  a number out of its range counts as the nearest in it, and what is no number as if it was not there; each
//            is told in a sentence: a viewer goes on, but nobody should have to guess why a picture looks odd.
#pragma once

#include <glm/vec3.hpp>
#include <tiny_gltf.h>

#include <string>
#include <vector>

namespace gh::load {

// A member of an object, or nothing.
[[nodiscard]] const tinygltf::Value* member(const tinygltf::Value* object, const char* key);
[[nodiscard]] const tinygltf::Value* extension(const tinygltf::ExtensionMap& extensions, const char* name);

struct Range {
    double low, high;
};
inline constexpr Range kShare{0.0, 1.0};

class NumberReader {
  public:
    // `whose` begins the sentences that go into `remarks`.
    NumberReader(std::string whose, std::vector<std::string>& remarks)
        : whose_(std::move(whose)), remarks_(remarks) {}

    [[nodiscard]] double nearest(const std::string& name, double value, const Range& range) const;
    [[nodiscard]] float within(const std::string& name, double value, const Range& range) const {
        return static_cast<float>(nearest(name, value, range));
    }
    // Of an object that may be null; `fallback` where it has no such member.
    [[nodiscard]] double exact_number(const tinygltf::Value* object, const char* key, double fallback,
                                      const Range& range) const;
    [[nodiscard]] float number(const tinygltf::Value* object, const char* key, double fallback,
                               const Range& range) const {
        return static_cast<float>(exact_number(object, key, fallback, range));
    }
    [[nodiscard]] glm::vec3 color(const tinygltf::Value* object, const char* key, double fallback,
                                  const Range& range) const;
    // Element `i` of an array.
    [[nodiscard]] float element(const tinygltf::Value* object, const char* key, int i, double fallback,
                                const Range& range) const;
    void remark(const std::string& sentence) const;

  private:
    std::string whose_;
    std::vector<std::string>& remarks_;
};

}  // namespace gh::load

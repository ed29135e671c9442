// support/glb_writer.h - writes small .glb files for tests: numbers go in, accessors come out.
//
// Knows as little of glTF as it can; what it writes passes for valid because the tests' levels are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gh::test {

class GlbWriter {
  public:
    // Each adds an accessor and gives its id. `type`: "SCALAR", "VEC2", "VEC3", "VEC4", "MAT4".
    int add_floats(const std::vector<float>& values, const std::string& type);
    int add_indices(const std::vector<std::uint16_t>& values);
    int add_joints(const std::vector<std::uint8_t>& values);  // VEC4
    // A PNG of one colour, `side` pixels square; the id of its image.
    int add_image(int side, std::uint8_t red, std::uint8_t green, std::uint8_t blue);

    // One more element of a top-level array such as "nodes"; its id.
    int add(const std::string& array, const std::string& json);

    // The file. `rest` is further members of the outermost object, e.g. "\"scene\":0".
    [[nodiscard]] std::vector<std::byte> finish(const std::string& rest) const;

  private:
    struct Array {
        std::string name;
        std::vector<std::string> items;
    };
    int add_view(const void* data, std::size_t size);
    int add_accessor(int view, int component_type, std::size_t count, const std::string& type);

    std::vector<Array> arrays_;
    std::vector<std::byte> chunk_;
};

}  // namespace gh::test

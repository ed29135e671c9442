#include "load/gltf_accessor.h"

#include "load/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <span>
#include <type_traits>

namespace gh::load {
namespace {

using Bytes = std::span<const unsigned char>;

template <class T>
T load(const unsigned char* at) {
    T value;
    std::memcpy(&value, at, sizeof(T));  // buffers are little-endian and need not be aligned for T
    return value;
}

std::size_t component_bytes(int component_type) {
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            return 0;  // int and double are no glTF component types
    }
}

float to_float(const unsigned char* at, int component_type, bool is_normalized) {
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE: {
            const auto value = static_cast<float>(load<std::int8_t>(at));
            return is_normalized ? std::max(value / 127.0f, -1.0f) : value;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: {
            const auto value = static_cast<float>(load<std::uint8_t>(at));
            return is_normalized ? value / 255.0f : value;
        }
        case TINYGLTF_COMPONENT_TYPE_SHORT: {
            const auto value = static_cast<float>(load<std::int16_t>(at));
            return is_normalized ? std::max(value / 32767.0f, -1.0f) : value;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
            const auto value = static_cast<float>(load<std::uint16_t>(at));
            return is_normalized ? value / 65535.0f : value;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return static_cast<float>(load<std::uint32_t>(at));
        default:
            return load<float>(at);
    }
}

std::optional<std::uint32_t> to_unsigned(const unsigned char* at, int component_type) {
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return load<std::uint8_t>(at);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return load<std::uint16_t>(at);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return load<std::uint32_t>(at);
        default:
            return std::nullopt;
    }
}

std::size_t components_of(int type) {
    switch (type) {
        case TINYGLTF_TYPE_SCALAR:
            return 1;
        case TINYGLTF_TYPE_VEC2:
            return 2;
        case TINYGLTF_TYPE_VEC3:
            return 3;
        case TINYGLTF_TYPE_VEC4:
            return 4;
        case TINYGLTF_TYPE_MAT4:
            return 16;
        default:
            return 0;  // 2x2 and 3x3 matrices occur nowhere in what is read
    }
}

// Elements at equal distances, all of them inside their buffer.
struct Elements {
    const unsigned char* begin = nullptr;  // null: all zero
    std::size_t stride = 0;
    std::size_t count = 0;
    [[nodiscard]] const unsigned char* at(std::size_t i) const { return begin + i * stride; }
};

Result<Elements> elements_in_view(const tinygltf::Model& model, int view_id, std::size_t offset,
                                  std::size_t count, std::size_t element_bytes) {
    const Result<Bytes> bytes = view_bytes(model, view_id);
    if (!bytes) return bytes.error();
    const std::size_t stride_given = model.bufferViews[static_cast<std::size_t>(view_id)].byteStride;
    const std::size_t stride = stride_given == 0 ? element_bytes : stride_given;
    if (stride < element_bytes) return Error{fmt::format("a stride of {} is less than an element", stride)};
    if (count == 0) return Elements{bytes->data(), stride, 0};
    const bool fits = offset <= bytes->size() && bytes->size() - offset >= element_bytes &&
                      (bytes->size() - offset - element_bytes) / stride >= count - 1;
    if (!fits) {
        return Error{fmt::format("{} elements from byte {} on do not fit into its view of {} bytes", count,
                                 offset, bytes->size())};
    }
    return Elements{bytes->data() + offset, stride, count};
}

// An accessor's elements and, where it is sparse, what replaces some of them.
struct Source {
    const tinygltf::Accessor* accessor = nullptr;
    Elements base;
    Elements replaced;  // ids
    Elements values;
};

Result<void> add_sparse(const tinygltf::Model& model, std::size_t element_bytes, Source& source) {
    const auto& sparse = source.accessor->sparse;
    const std::size_t index_bytes = component_bytes(sparse.indices.componentType);
    if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0 ||
        index_bytes == 0) {
        return Error{"its sparse part is malformed"};
    }
    const auto count = static_cast<std::size_t>(sparse.count);
    Result<Elements> ids =
        elements_in_view(model, sparse.indices.bufferView,
                         static_cast<std::size_t>(sparse.indices.byteOffset), count, index_bytes);
    if (!ids) return ids.error();
    Result<Elements> values =
        elements_in_view(model, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset),
                         count, element_bytes);
    if (!values) return values.error();
    for (std::size_t i = 0; i < count; ++i) {
        const std::optional<std::uint32_t> id = to_unsigned(ids->at(i), sparse.indices.componentType);
        if (!id || *id >= source.base.count)
            return Error{"its sparse part replaces an element that is not there"};
    }
    source.replaced = *ids;
    source.values = *values;
    return {};
}

Result<Source> open_source(const tinygltf::Model& model, int id, std::size_t components) {
    if (id < 0 || static_cast<std::size_t>(id) >= model.accessors.size()) {
        return Error{fmt::format("accessor {} does not exist", id)};
    }
    Source source{&model.accessors[static_cast<std::size_t>(id)], {}, {}, {}};
    const tinygltf::Accessor& accessor = *source.accessor;
    const auto refuse = [&](const std::string& why) {
        return Error{fmt::format("accessor {}: {}", id, why)};
    };
    const std::size_t size = component_bytes(accessor.componentType) * components;
    if (components_of(accessor.type) != components) return refuse("is not of the expected type");
    if (size == 0) return refuse(fmt::format("has unknown component type {}", accessor.componentType));
    if (accessor.bufferView >= 0) {
        Result<Elements> base =
            elements_in_view(model, accessor.bufferView, accessor.byteOffset, accessor.count, size);
        if (!base) return refuse(base.error().sentence);
        source.base = *base;
    } else {
        if (accessor.count > kMaxZeros) return refuse(fmt::format("{} zeros are too many", accessor.count));
        source.base.count = accessor.count;
    }
    if (accessor.sparse.isSparse) {
        if (const Result<void> added = add_sparse(model, size, source); !added)
            return refuse(added.error().sentence);
    }
    return source;
}

// Calls element(i, bytes) for every element that has bytes, replaced ones after those they replace.
template <class F>
void for_each_element(const Source& source, const F& element) {
    if (source.base.begin != nullptr) {
        for (std::size_t i = 0; i < source.base.count; ++i) element(i, source.base.at(i));
    }
    for (std::size_t i = 0; i < source.replaced.count; ++i) {
        const int type = source.accessor->sparse.indices.componentType;
        element(*to_unsigned(source.replaced.at(i), type), source.values.at(i));
    }
}

// Vectors of `Components` floats that lie one after the other in T.
template <class T, std::size_t Components>
Result<std::vector<T>> read_floats(const tinygltf::Model& model, int id) {
    static_assert(sizeof(T) == Components * sizeof(float));
    const Result<Source> source = open_source(model, id, Components);
    if (!source) return source.error();
    const int type = source->accessor->componentType;
    const std::size_t step = component_bytes(type);
    std::vector<T> values(source->base.count, T(0.0f));
    std::size_t not_finite = values.size();
    for_each_element(*source, [&](std::size_t i, const unsigned char* at) {
        float parts[Components];
        for (std::size_t c = 0; c < Components; ++c) {
            parts[c] = to_float(at + c * step, type, source->accessor->normalized);
            if (!std::isfinite(parts[c])) not_finite = i;
        }
        std::memcpy(&values[i], parts, sizeof(T));
    });
    if (not_finite < values.size()) {
        return Error{fmt::format("accessor {}: element {} is not a finite number", id, not_finite)};
    }
    return values;
}

}  // namespace

Result<std::vector<float>> read_scalars(const tinygltf::Model& model, int accessor) {
    return read_floats<float, 1>(model, accessor);
}
Result<std::vector<glm::vec2>> read_vec2s(const tinygltf::Model& model, int accessor) {
    return read_floats<glm::vec2, 2>(model, accessor);
}
Result<std::vector<glm::vec3>> read_vec3s(const tinygltf::Model& model, int accessor) {
    return read_floats<glm::vec3, 3>(model, accessor);
}
Result<std::vector<glm::vec4>> read_vec4s(const tinygltf::Model& model, int accessor) {
    return read_floats<glm::vec4, 4>(model, accessor);
}
Result<std::vector<glm::mat4>> read_mat4s(const tinygltf::Model& model, int accessor) {
    return read_floats<glm::mat4, 16>(model, accessor);
}

Result<std::vector<std::uint32_t>> read_indices(const tinygltf::Model& model, int accessor) {
    const Result<Source> source = open_source(model, accessor, 1);
    if (!source) return source.error();
    const int type = source->accessor->componentType;
    std::vector<std::uint32_t> values(source->base.count, 0u);
    bool is_unsigned = true;
    for_each_element(*source, [&](std::size_t i, const unsigned char* at) {
        const std::optional<std::uint32_t> value = to_unsigned(at, type);
        is_unsigned = is_unsigned && value.has_value();
        values[i] = value.value_or(0u);
    });
    if (!is_unsigned) return Error{fmt::format("accessor {}: indices must be unsigned integers", accessor)};
    return values;
}

Result<std::vector<glm::u16vec4>> read_joints(const tinygltf::Model& model, int accessor) {
    const Result<Source> source = open_source(model, accessor, 4);
    if (!source) return source.error();
    const int type = source->accessor->componentType;
    if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) {
        return Error{fmt::format("accessor {}: joints must be unsigned bytes or shorts", accessor)};
    }
    std::vector<glm::u16vec4> values(source->base.count, glm::u16vec4(0));
    for_each_element(*source, [&](std::size_t i, const unsigned char* at) {
        for (glm::length_t c = 0; c < 4; ++c) {
            const auto value = to_unsigned(at + static_cast<std::size_t>(c) * component_bytes(type), type);
            values[i][c] = static_cast<std::uint16_t>(value.value_or(0u));
        }
    });
    return values;
}

Result<Bytes> view_bytes(const tinygltf::Model& model, int view_id) {
    if (view_id < 0 || static_cast<std::size_t>(view_id) >= model.bufferViews.size()) {
        return Error{fmt::format("buffer view {} does not exist", view_id)};
    }
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(view_id)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size()) {
        return Error{
            fmt::format("buffer view {} lies in buffer {}, which does not exist", view_id, view.buffer)};
    }
    const std::vector<unsigned char>& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset) {
        return Error{fmt::format("buffer view {} of {} bytes from {} on leaves its buffer of {} bytes",
                                 view_id, view.byteLength, view.byteOffset, data.size())};
    }
    return Bytes(data).subspan(view.byteOffset, view.byteLength);
}

}  // namespace gh::load

#include "raycore/blas.h"

#include "data.h"

#include <utility>

namespace rc {

Blas::Blas(std::unique_ptr<Data> data) : data_(std::move(data)) {}
Blas::Blas(const Blas& other) : data_(std::make_unique<Data>(*other.data_)) {}
Blas::Blas(Blas&&) noexcept = default;
Blas& Blas::operator=(Blas&&) noexcept = default;
Blas::~Blas() = default;

const MeshReport& Blas::report() const {
    return data_->report;
}
Box Blas::bounds() const {
    return data_->bounds;
}
float Blas::sah_cost() const {
    return data_->cost;
}

std::size_t Blas::byte_size() const {
    const auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    return sizeof(Data) + bytes(data_->nodes) + bytes(data_->leaves) + bytes(data_->leaf_of_primitive);
}

float Blas::refit_degradation() const {
    return data_->cost_when_built > 0.0f ? data_->cost / data_->cost_when_built : 1.0f;
}

}  // namespace rc

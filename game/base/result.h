// base/result.h - a value, or one sentence saying why there is none.
//
// For the world's mistakes only: files, arguments, devices. The sentence names file, item and reason and can
// be shown to a person as it stands. A programmer's mistake is EXPECTS; a miss is std::optional.
//
//   Result<Image> image = read_png(path);
//   if (!image) return image.error();
//   show(*image);
#pragma once

#include "base/contracts.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace gh {

struct Error {
    std::string sentence;
};

// Asking for the value of an error, or for the error of a value, breaks a contract.
template <class T>
class [[nodiscard]] Result {
  public:
    // Implicit on purpose: a function returns either by its plain name.
    Result(T value) : value_or_error_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : value_or_error_(std::in_place_index<1>, std::move(error)) {}

    [[nodiscard]] bool has_value() const { return value_or_error_.index() == 0; }
    [[nodiscard]] explicit operator bool() const { return has_value(); }

    [[nodiscard]] T& operator*() & {
        EXPECTS(has_value());
        return *std::get_if<0>(&value_or_error_);
    }
    [[nodiscard]] const T& operator*() const& {
        EXPECTS(has_value());
        return *std::get_if<0>(&value_or_error_);
    }
    [[nodiscard]] T&& operator*() && {
        EXPECTS(has_value());
        return std::move(*std::get_if<0>(&value_or_error_));
    }
    [[nodiscard]] T* operator->() { return &**this; }
    [[nodiscard]] const T* operator->() const { return &**this; }

    [[nodiscard]] const Error& error() const {
        EXPECTS(!has_value());
        return *std::get_if<1>(&value_or_error_);
    }

  private:
    std::variant<T, Error> value_or_error_;
};

// Default-constructed: it went well.
template <>
class [[nodiscard]] Result<void> {
  public:
    Result() = default;
    Result(Error error) : error_(std::move(error)) {}

    [[nodiscard]] bool has_value() const { return !error_.has_value(); }
    [[nodiscard]] explicit operator bool() const { return has_value(); }

    [[nodiscard]] const Error& error() const {
        EXPECTS(error_.has_value());
        return *error_;
    }

  private:
    std::optional<Error> error_;
};

}  // namespace gh

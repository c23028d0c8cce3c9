// SPDX-License-Identifier: MIT
// The outcome of an operation on the caller's data: a value, or an error that a person can act on.
#pragma once

#include <cassert>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace lichen {

/// Categories of errors by who can fix them. The values are the command line's exit codes.
enum class ErrorKind {
  usage = 2,       ///< an invalid parameter
  badInput = 3,    ///< an unusable file or image
  environment = 4, ///< something missing on the machine: a device, a writable folder, a package
  resources = 5,   ///< memory or disk exhausted
};

/// An error as shown to the user. The message is one line that names the file, the offending value
/// and what was expected, without a trailing period or newline.
struct Error {
  ErrorKind kind = ErrorKind::badInput;
  std::string message;
};

/// An error for exhausted memory. `describe` returns its message; if that throws std::bad_alloc,
/// the message is one that needs no allocation.
template <class Describe>
[[nodiscard]] Error memoryError(const Describe& describe) noexcept {
  try {
    return {ErrorKind::resources, describe()};
  } catch (const std::bad_alloc&) {
    return {ErrorKind::resources, "out of memory"}; // short enough for the string object itself
  }
}

/// Either a value of type T or an Error. Accessing the absent one violates the contract.
template <class T>
class [[nodiscard]] Result {
public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool ok() const noexcept { return state_.index() == 0; }
  explicit operator bool() const noexcept { return ok(); }

  [[nodiscard]] T& value() & {
    assert(ok());
    return *std::get_if<0>(&state_);
  }
  [[nodiscard]] const T& value() const& {
    assert(ok());
    return *std::get_if<0>(&state_);
  }
  [[nodiscard]] T&& value() && {
    assert(ok());
    return std::move(*std::get_if<0>(&state_));
  }
  [[nodiscard]] const Error& error() const {
    assert(!ok());
    return *std::get_if<1>(&state_);
  }

private:
  std::variant<T, Error> state_;
};

/// Success without a value, or an Error.
template <>
class [[nodiscard]] Result<void> {
public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}

  [[nodiscard]] bool ok() const noexcept { return !error_.has_value(); }
  explicit operator bool() const noexcept { return ok(); }
  [[nodiscard]] const Error& error() const {
    assert(!ok());
    return *error_;
  }

private:
  std::optional<Error> error_;
};

/// Runs `operation`, which returns a Result, and converts std::bad_alloc into
/// memoryError(describe). Put a function's checks into `operation` too: their error messages also
/// need memory.
template <class Describe, class Operation>
[[nodiscard]] auto withinMemory(const Describe& describe, const Operation& operation)
    -> decltype(operation()) {
  try {
    return operation();
  } catch (const std::bad_alloc&) {
    return memoryError(describe);
  }
}

} // namespace lichen

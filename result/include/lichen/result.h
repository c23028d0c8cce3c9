// SPDX-License-Identifier: MIT
// The outcome of an operation on a caller's data: a value, or an error a person can act on.
#pragma once

#include <cassert>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace lichen {

/// What went wrong, by who can mend it. The values are the command line's exit codes.
enum class ErrorKind {
  usage = 2,       ///< a parameter outside its accepted range
  badInput = 3,    ///< a file or image that cannot be used
  environment = 4, ///< something the machine lacks: a device, a writable folder, a package
  resources = 5,   ///< memory or disk exhausted
};

/// An error as the user sees it: one line that names the file, the offending value and what would
/// be accepted. No trailing period or newline.
struct Error {
  ErrorKind kind = ErrorKind::badInput;
  std::string message;
};

/// The error of what memory did not suffice for. `describe` makes its message; where not even that
/// can be stored, it is one that needs no memory.
template <class Describe>
[[nodiscard]] Error memoryError(const Describe& describe) noexcept {
  try {
    return {ErrorKind::resources, describe()};
  } catch (const std::bad_alloc&) {
    return {ErrorKind::resources, "out of memory"}; // fits into the string object itself
  }
}

/// Either a value of type T or an Error. Asking for the one that is absent breaks the contract.
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

/// Runs `operation`, which returns a Result, with std::bad_alloc turned into memoryError(describe).
/// What a function checks belongs in there too: the message of a refusal needs memory as well.
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

#pragma once

#include <string>
#include <utility>
#include <variant>

#include "model/base/common/check.hpp"

namespace mixcmp::inline common {

enum class ErrorKind {
  mistake,          ///< a user's mistake, or a machine that does not allow the request
  missing_tool,     ///< the request needs a program that is not installed
  refuted,          ///< a claim that was checked does not hold
  missing_column,   ///< a mistake: `field` is no column of a table
  unnamed_columns,  ///< a mistake: a table's columns have no names, and not all have numbers
};

/// A user's mistake, reported once: its place, the received value and the accepted ones. Empty
/// fields (and line or column 0) are left out of the printed message.
struct Error {
  std::string file;
  int line = 0;    ///< 1-based
  int column = 0;  ///< 1-based
  std::string field;
  std::string message;
  std::string received;
  std::string accepted;
  ErrorKind kind = ErrorKind::mistake;

  /// "file:line:column: field: message: received R; accepted A", each part cut at its limit and
  /// printable.
  std::string to_string() const;
};

/// Either a valid T or the Error that explains why there is none.
template <class T>
class [[nodiscard]] Result {
public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  const T& value() const& {
    MIXCMP_CHECK(ok());
    return std::get<0>(state_);
  }
  T&& value() && {
    MIXCMP_CHECK(ok());
    return std::get<0>(std::move(state_));
  }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }

  const Error& error() const {
    MIXCMP_CHECK(!ok());
    return std::get<1>(state_);
  }

private:
  std::variant<T, Error> state_;
};

/// The value of a Result whose success carries nothing.
struct Done {};

}  // namespace mixcmp::inline common

/// Binds `name` to the value of `expression`, or returns its error from the enclosing function.
#define MIXCMP_TRY(name, expression)                     \
  auto name##_result = (expression);                     \
  if (!name##_result.ok()) return name##_result.error(); \
  [[maybe_unused]] auto name = std::move(name##_result).value()

/// Returns the error of `expression`, a Result<Done>, from the enclosing function.
#define MIXCMP_DO(expression)                                      \
  do {                                                             \
    const mixcmp::Result<mixcmp::Done> done_result = (expression); \
    if (!done_result.ok()) return done_result.error();             \
  } while (false)

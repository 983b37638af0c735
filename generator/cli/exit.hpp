#pragma once

#include <fmt/core.h>

#include <utility>

#include "model/common/result.hpp"

namespace mixcmp::cli {

/// Thrown by a verb to end the program; main turns it into the exit code.
struct Exit {
  int code;
};

/// The value, or the error on stderr and the end.
template <class T>
T value_or_exit(model::Result<T> result) {
  if (!result.ok()) {
    fmt::print(stderr, "mixcmp: {}\n", result.error().to_string());
    throw Exit{1};
  }
  return std::move(result).value();
}

}  // namespace mixcmp::cli

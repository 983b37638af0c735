#pragma once

#include <string>
#include <utility>

#include "model/base/common/result.hpp"

namespace mixcmp::inline expression {

/// Carries an error out of a recursive descent. It is caught at the descent's start.
struct Failure {
  Error error;
};

[[noreturn]] inline void fail(std::size_t column, std::string message, std::string received = {},
                              std::string accepted = {}) {
  throw Failure{{.column = static_cast<int>(column),
                 .message = std::move(message),
                 .received = std::move(received),
                 .accepted = std::move(accepted)}};
}

}  // namespace mixcmp::inline expression

#pragma once

#include <optional>
#include <string>

#include "model/comparison/expression/graph.hpp"
#include "model/comparison/expression/syntax.hpp"

namespace mixcmp::inline expression {

/// A function that texts may call.
struct Callable {
  enum class Arguments {
    one,
    two_or_more,        ///< or an index
    value_and_limits,   ///< a value, its least and its greatest
    value_and_divisor,  ///< a value and a constant above 0
    y_and_x,            ///< coordinates
    file_and_value,     ///< a file, a value, and a degree if that is not 1
  };

  std::string name;
  std::optional<Operation> operation;  ///< none: it has a rule of its own
  Arguments arguments;
  std::optional<Function> function = {};  ///< for Operation::function

  bool reduces() const { return arguments == Arguments::two_or_more; }
};

/// The function of a name; null if there is none.
const Callable* find_callable(const std::string& name);

/// The function that a call or a reduction names. An unknown name is a failure.
const Callable& callable_of(const Syntax& syntax);

/// Fails if a call has more or fewer arguments than its function takes.
void check_arguments(const Syntax& syntax, const Callable& function);

}  // namespace mixcmp::inline expression

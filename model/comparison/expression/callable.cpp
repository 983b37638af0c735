#include "model/comparison/expression/callable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "model/base/common/nearest.hpp"
#include "model/comparison/expression/failure.hpp"

namespace mixcmp::inline expression {
namespace {

std::vector<Callable> make_callables() {
  std::vector<Callable> callables = {
      {"sqrt", Operation::square_root, Callable::Arguments::one},
      {"abs", Operation::absolute, Callable::Arguments::one},
      {"min", Operation::minimum, Callable::Arguments::two_or_more},
      {"max", Operation::maximum, Callable::Arguments::two_or_more},
      {"sum", Operation::add, Callable::Arguments::two_or_more},
      {"product", Operation::multiply, Callable::Arguments::two_or_more},
      {"within", std::nullopt, Callable::Arguments::value_and_limits},
      {"sign", Operation::function, Callable::Arguments::one, Function::sign},
      {"atan2", std::nullopt, Callable::Arguments::y_and_x},
      {"mod", std::nullopt, Callable::Arguments::value_and_divisor},
      {"table", std::nullopt, Callable::Arguments::file_and_value},
  };
  for (const Function::Kind function : all_functions) {
    callables.push_back(
        {to_string(function), Operation::function, Callable::Arguments::one, function});
  }
  return callables;
}

const std::vector<Callable>& callables() {
  static const std::vector<Callable> all = make_callables();
  return all;
}

}  // namespace

const Callable* find_callable(const std::string& name) {
  const auto found = std::find_if(callables().begin(), callables().end(),
                                  [&](const Callable& known) { return known.name == name; });
  return found == callables().end() ? nullptr : &*found;
}

const Callable& callable_of(const Syntax& syntax) {
  if (const Callable* function = find_callable(syntax.text)) return *function;
  std::vector<std::string> names;
  for (const Callable& known : callables()) names.emplace_back(known.name);
  fail(syntax.column, "unknown function", syntax.text, list_with_nearest(syntax.text, names));
}

void check_arguments(const Syntax& syntax, const Callable& function) {
  const std::size_t count = syntax.parts.size();
  const auto refuse = [&](const std::string& needed, const std::string& accepted) {
    fail(syntax.column, fmt::format("{} takes {}", syntax.text, needed),
         fmt::format("{} argument{}", count, count == 1 ? "" : "s"), accepted);
  };
  switch (function.arguments) {
    case Callable::Arguments::one:
      if (count != 1) refuse("1 argument", "1 argument");
      return;
    case Callable::Arguments::value_and_divisor:
      if (count != 2) refuse("2 arguments", "a value and a divisor");
      return;
    case Callable::Arguments::y_and_x:
      if (count != 2) refuse("2 arguments", "y and x");
      return;
    case Callable::Arguments::file_and_value:
      if (count == 2 || count == 3) return;
      refuse("2 or 3 arguments", "a file in quotes, a value, and a degree if that is not 1");
      return;
    case Callable::Arguments::two_or_more:
      if (count >= 2) return;
      refuse("2 arguments or more", "2 arguments or more, or an index (k in 0..3) and a term");
      return;
    case Callable::Arguments::value_and_limits:
      if (count != 3) refuse("3 arguments", "a value, its least and its greatest");
      return;
  }
}

}  // namespace mixcmp::inline expression

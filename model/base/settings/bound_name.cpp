#include "model/base/settings/bound_name.hpp"

#include <fmt/core.h>

#include <vector>

#include "model/base/common/nearest.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/settings/limits.hpp"

namespace mixcmp::settings {
namespace {

std::vector<Bound> all_bounds() {
  std::vector<Bound> bounds = {
      {.kind = BoundKind::constant}, {.kind = BoundKind::profiled}, {.kind = BoundKind::relative}};
  constexpr Limits digits = limits::bound_digits;
  for (int count = digits.least; count <= digits.most; ++count) {
    bounds.push_back({.kind = BoundKind::running, .digits = count});
  }
  for (const bool is_block : {false, true}) {
    for (int count = 0; count < limits::fixed_bits.most; ++count) {
      for (const Bound& bound : bounds_of({.is_block = is_block, .guard_digits = count})) {
        bounds.push_back(bound);
      }
    }
  }
  return bounds;
}

}  // namespace

Result<Bound> parse_bound(std::string_view name) {
  std::vector<std::string> names;
  for (const Bound& bound : all_bounds()) {
    names.push_back(to_string(bound));
    if (names.back() == name) return bound;
  }
  const std::string likely = nearest(name, names);
  return Error{.message = "not a bound",
               .received = in_quotes(name),
               .accepted = (likely.empty() ? "" : likely + " (the nearest); ") + bound_names()};
}

std::string bound_names() {
  constexpr Limits digits = limits::bound_digits;
  return fmt::format(
      "relative, running_{} to running_{}, constant, profiled, fixed_norm, fixed_constant, "
      "fixed_running, block_norm, block_constant, block_running, each of the last six also with G "
      "guard digits as fixed_norm_gG; fixed_grid",
      digits.least, digits.most);
}

}  // namespace mixcmp::settings

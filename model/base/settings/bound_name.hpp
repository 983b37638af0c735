#pragma once

#include <string>
#include <string_view>

#include "model/base/common/result.hpp"
#include "model/base/number/bound.hpp"

namespace mixcmp::settings {

/// The bound of this name; accepts the texts that to_string makes of a Bound.
///
///     parse_bound("fixed_norm_g3")  // a norm in fixed point with three guard digits
Result<Bound> parse_bound(std::string_view name);

/// All names, for help texts and messages.
std::string bound_names();

}  // namespace mixcmp::settings

#pragma once

#include "model/scene/scene.hpp"
#include "model/scene/settings.hpp"

namespace mixcmp::model {

/// The ranges that [inputs] declares, one per name of `inputs`. In a pattern, '*' stands for any
/// characters; an exact key beats patterns; a key that matches nothing, and two patterns that match
/// the same input, are errors.
Result<std::vector<std::optional<Range>>> read_input_ranges(const Settings& settings,
                                                            const std::vector<std::string>& inputs);

/// Whether `name` matches `pattern`.
bool matches(std::string_view pattern, std::string_view name);

}  // namespace mixcmp::model

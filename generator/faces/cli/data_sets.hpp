#pragma once

#include <string>
#include <vector>

#include "generator/faces/cli/options.hpp"

/// Several data sets of one scene, by the values of a key of [data].
namespace mixcmp::cli {

/// The settings that an option such as "data.radius_max=5,10,25" names, one for each data set.
Result<std::vector<std::string>> data_sets(const std::string& option, const std::string& text);

/// The scene's options with one data set; an empty `set` is the scene's own. Errors in its setting
/// name `option`.
SceneOptions with_data_set(SceneOptions options, const std::string& option, const std::string& set);

/// Refuses, by the name of the option, data sets that would each have lanes of their own: a plan
/// for several of them has one kind of lane, whose ranges are those of the scene's data.
void check_ranges(const std::string& option, const scene::Scene& scene);

}  // namespace mixcmp::cli

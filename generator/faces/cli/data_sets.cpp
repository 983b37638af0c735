#include "generator/faces/cli/data_sets.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "generator/faces/cli/exit.hpp"
#include "model/base/common/quote.hpp"

namespace mixcmp::cli {

Result<std::vector<std::string>> data_sets(const std::string& option, const std::string& text) {
  const std::size_t equals = text.find('=');
  std::vector<std::string> sets;
  if (equals != std::string::npos && equals > 0) {
    std::istringstream values(text.substr(equals + 1));
    for (std::string value; std::getline(values, value, ',');) {
      if (!value.empty()) sets.push_back(text.substr(0, equals + 1) + value);
    }
  }
  if (!sets.empty() && text.starts_with("data.")) return sets;
  return Error{.file = {},
               .field = option,
               .message = "names no data sets",
               .received = in_quotes(text),
               .accepted = "a key of [data] with values, such as data.radius_max=5,10,25"};
}

SceneOptions with_data_set(SceneOptions options, const std::string& option,
                           const std::string& set) {
  if (set.empty()) return options;
  options.settings.push_back(set);
  options.shortcuts[set.substr(0, set.find('='))] = option;
  return options;
}

void check_ranges(const std::string& option, const scene::Scene& scene) {
  const auto measured = std::find(scene.data_ranges.begin(), scene.data_ranges.end(), true);
  if (measured == scene.data_ranges.end()) return;
  const auto input = static_cast<std::size_t>(measured - scene.data_ranges.begin());
  fail({.field = option,
        .message = "the range of an input would be another one in each data set",
        .received = fmt::format("range = \"data\" for {}", scene.graph.inputs()[input]),
        .accepted = "[low, high], a range that all data sets keep"});
}

}  // namespace mixcmp::cli

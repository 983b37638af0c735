#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "model/scene/summary.hpp"

namespace mixcmp::report {

/// Some lines of a summary under a title, each a name and a text.
struct SummaryLines {
  std::string title;
  std::vector<std::pair<std::string, std::string>> lines;
};
std::vector<SummaryLines> lines_of(const scene::Summary& summary);

/// The same lines as text.
std::string to_text(const scene::Summary& summary);
nlohmann::json to_json(const scene::Summary& summary);

}  // namespace mixcmp::report

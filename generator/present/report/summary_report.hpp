#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "generator/present/table/table.hpp"
#include "model/scene/summary.hpp"

namespace mixcmp::report {

/// Some lines of a summary under a title.
struct SummaryLines {
  std::string title;
  table::Lines lines = {};
};
std::vector<SummaryLines> lines_of(const scene::Summary& summary);

/// The same lines as text.
std::string to_text(const scene::Summary& summary);
nlohmann::json to_json(const scene::Summary& summary);

}  // namespace mixcmp::report

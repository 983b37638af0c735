#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "model/scene/summary.hpp"

namespace mixcmp::report {

std::string to_text(const scene::Summary& summary);
nlohmann::json to_json(const scene::Summary& summary);

}  // namespace mixcmp::report

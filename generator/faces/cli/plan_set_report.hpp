#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "generator/tasks/plan_set.hpp"

namespace mixcmp::cli {

/// A line about each plan: "L = 11, 336 x 1: 144 x q11 fixed_norm embedded, ...".
std::vector<std::string> plan_lines(const tasks::PlanSetResult& result);

/// The result as people read it. `sets` and `blocks`: names of the data sets, and of the stream's.
std::string to_text(const tasks::PlanSetResult& result, const std::vector<std::string>& sets,
                    const std::vector<std::string>& blocks);
nlohmann::ordered_json to_json(const tasks::PlanSetResult& result,
                               const std::vector<std::string>& sets,
                               const std::vector<std::string>& blocks);

}  // namespace mixcmp::cli

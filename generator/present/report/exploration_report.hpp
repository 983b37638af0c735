#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "generator/present/report/paper_tables.hpp"
#include "model/plan/optimise/exploration.hpp"

namespace mixcmp::report {

nlohmann::ordered_json to_json(const optimise::Exploration& exploration);
nlohmann::ordered_json to_json(const std::vector<SoftwareThroughput>& software);

/// CSV with the columns data_set, clocks, scenario, precision, lanes, references, clock_mhz,
/// recomputation_rate, throughput_per_s, gain.
std::string scenarios_csv(const optimise::Exploration& exploration);

}  // namespace mixcmp::report

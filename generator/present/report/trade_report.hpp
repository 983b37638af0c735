#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "model/plan/profile/trade.hpp"

namespace mixcmp::report {

std::string to_text(const profile::Trade& trade);
/// The advice for a user who accepts this many wrong verdicts per million comparisons.
std::string advice(const profile::Trade& trade, double accepted_per_million);
nlohmann::ordered_json to_json(const profile::Trade& trade);
/// CSV with the columns inputs, system, precision, wrong_per_million, rate, lane_luts,
/// reference_luts, area, comparisons_per_kiloluts.
std::string trade_csv(const std::vector<profile::Trade>& trades);
/// Wrong verdicts over comparisons from an area, as a gnuplot script that writes an SVG.
std::string trade_script(const std::vector<profile::Trade>& trades, const std::string& scene);

}  // namespace mixcmp::report

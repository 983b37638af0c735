#include "generator/present/report/function_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "model/comparison/expression/text.hpp"
#include "model/judge/proof/function_enclosure.hpp"

namespace mixcmp::report {
namespace {

constexpr int digits = 4;

std::string shown(const Range& error) {
  return fmt::format("{} to {}", rounded_text(error.low, digits), rounded_text(error.high, digits));
}

nlohmann::json ends(const Range& error) {
  return {error.low.get_d(), error.high.get_d()};
}

}  // namespace

std::vector<std::pair<std::string, std::string>> function_lines(const fixed::FixedLane& lane) {
  std::vector<std::pair<std::string, std::string>> lines;
  for (const proof::StatedFunction& each : proof::stated_functions(lane)) {
    lines.emplace_back(each.text, fmt::format("errs by {} (by itself {}), {} pieces of degree {}",
                                              shown(each.error), shown(each.own_error),
                                              each.pieces.get_str(), each.degree));
  }
  return lines;
}

nlohmann::json functions_json(const fixed::FixedLane& lane) {
  nlohmann::json functions = nlohmann::json::array();
  for (const proof::StatedFunction& each : proof::stated_functions(lane)) {
    functions.push_back({{"function", each.text},
                         {"error", ends(each.error)},
                         {"own_error", ends(each.own_error)},
                         {"pieces", each.pieces.get_ui()},
                         {"degree", each.degree}});
  }
  return functions;
}

}  // namespace mixcmp::report

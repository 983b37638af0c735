#include "verilator_tb/engine_judge.hpp"

#include <fmt/core.h>

#include "verilator_tb/judgement.hpp"

namespace mixcmp::verilator_tb {

EngineJudge::EngineJudge(const emit::Signature& signature, const design::Design& design,
                         const data::Comparisons& comparisons, const VerifyOptions& options)
    : signature_(signature),
      design_(design),
      comparisons_(comparisons),
      options_(options),
      lanes_(static_cast<std::size_t>(signature.lanes)),
      operands_(comparisons.input_count()),
      report_(empty_report(signature, design, options)) {
  for (std::size_t k = 0; k < design.lanes.size(); ++k) {
    group_of_lane_.insert(group_of_lane_.end(), static_cast<std::size_t>(design.lanes[k].count), k);
  }
  report_.requested = comparisons.size();
}

std::vector<CounterTotal> EngineJudge::check_lanes(
    const std::vector<harness::wire::CounterValues>& counted) {
  std::vector<CounterTotal> totals = {{"comparisons"}, {"recomputations"}};
  for (std::size_t lane = 0; lane < lanes_.size(); ++lane) {
    for (std::size_t k = 0; k < totals.size(); ++k) {
      check_counter(fmt::format("{} of lane {}", totals[k].name, lane), counted[lane].counted[k],
                    lanes_[lane].observed[k], totals[k]);
    }
  }
  return totals;
}

void EngineJudge::check_answers(const std::vector<std::uint64_t>& counted,
                                std::vector<CounterTotal>& totals) {
  if (counted.empty()) return;
  totals.push_back({"answers"});
  for (std::size_t reference = 0; reference < counted.size(); ++reference) {
    std::uint64_t observed = 0;  // lane k is served by reference k modulo their number
    for (std::size_t lane = reference; lane < lanes_.size(); lane += counted.size()) {
      observed += lanes_[lane].observed[1];
    }
    check_counter(fmt::format("answers of reference {}", reference), counted[reference], observed,
                  totals.back());
  }
}

void EngineJudge::check_counter(const std::string& name, std::uint64_t counted,
                                std::uint64_t observed, CounterTotal& total) {
  const auto mask = static_cast<std::uint64_t>(low_mask(signature_.counter_bits));
  total.counted += counted;
  total.observed += observed;
  if (counted == (observed & mask)) return;
  add_violation("counter is wrong", 0,
                fmt::format("{}: {} instead of {}", name, counted, observed));
}

std::uint64_t EngineJudge::stalls_gained(std::uint64_t counted) {
  const auto mask = static_cast<std::uint64_t>(low_mask(signature_.counter_bits));
  const std::uint64_t gained = (counted - stalled_before_) & mask;
  stalled_before_ = counted;
  return gained;
}

void EngineJudge::add_violation(std::string fault, std::uint64_t cycle, std::string details) {
  ++report_.violation_count;
  if (report_.violations.size() >= VerifyReport::kept) return;
  report_.violations.push_back({std::move(fault), 0, cycle, std::move(details)});
}

}  // namespace mixcmp::verilator_tb

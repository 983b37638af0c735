#include "verilator_tb/judge.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

#include "model/golden/evaluate.hpp"

namespace mixcmp::tb {

namespace {

using model::golden::Verdict;

constexpr std::uint32_t recomputed_flag = 4;
constexpr std::uint32_t undecided_flag = 8;

std::string describe_tdata(std::uint32_t tdata) {
  if ((tdata & ~0xfu) != 0 || (tdata & 0xc) == 0xc) {
    return fmt::format("the impossible tdata 0x{:02x}", tdata);
  }
  if ((tdata & undecided_flag) != 0) return "undecided";
  return fmt::format("{}, {}", to_string(static_cast<Verdict>(tdata & 3)),
                     (tdata & recomputed_flag) != 0 ? "recomputed" : "decided by the lane");
}

std::string to_text(wire::Fault fault) {
  switch (fault) {
    case wire::Fault::valid_dropped: return "tvalid fell before tready rose";
    case wire::Fault::payload_changed: return "payload changed while waiting for tready";
    case wire::Fault::unknown_tag: return "result with a tag that is not inside";
    case wire::Fault::duplicate_tag: return "result left twice";
    case wire::Fault::stale_after_reset: return "result from before a reset left after it";
    case wire::Fault::valid_in_reset: return "tvalid high in reset";
    case wire::Fault::order_broken: return "result overtook an earlier one";
    case wire::Fault::lost: return "comparison lost";
    case wire::Fault::hung: return "lane stands still";
    case wire::Fault::unknown_refetch: return "refetch of a tag that is not inside";
    case wire::Fault::unknown_value: return "unknown value (x) on a handshake or a result";
  }
  MIXCMP_CHECK(false);
  return {};
}

/// Of the undecided, the verdict bits say nothing.
std::uint32_t meaningful(std::uint32_t tdata) {
  return (tdata & undecided_flag) != 0 ? tdata & ~3u : tdata;
}

bool are_finite(model::FloatFormat format, const std::vector<model::Bits>& operands) {
  return std::all_of(operands.begin(), operands.end(), [&](model::Bits operand) {
    return format.biased_exponent(operand) < format.max_biased_exponent();
  });
}

}  // namespace

Judge::Judge(const gen::Signature& signature, const model::Design& design,
             const model::Comparisons& comparisons, const Selection& selection,
             const VerifyOptions& options)
    : signature_(signature),
      design_(design),
      comparisons_(comparisons),
      selection_(selection),
      options_(options) {
  report_.system = signature.top;
  report_.lanes = design.lane_count();
  report_.references = design.reference_count();
  report_.certified = design.certified();
  report_.requested = selection.size();
  if (options.truth) report_.truth.emplace();
  const std::vector<std::string> names = lane_group_names(design);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const model::LaneGroup& group = design.lanes[k];
    report_.groups.push_back(
        {.name = names[k], .lanes = group.count, .certified = group.lane.certified()});
    group_of_lane_.insert(group_of_lane_.end(), static_cast<std::size_t>(group.count), k);
  }
}

void Judge::announce(std::uint64_t count) {
  window_.resize(window_.size() + count);
}

std::uint32_t Judge::expected_tdata(std::uint32_t lane,
                                    std::span<const model::Bits> operands) const {
  const model::Lane& golden = design_.lanes[group_of_lane_[lane]].lane;
  const auto decision = model::golden::evaluate_lane(golden, operands);
  if (decision.decided) return static_cast<std::uint32_t>(decision.verdict);
  if (design_.references.empty()) return undecided_flag;
  return recomputed_flag |
         static_cast<std::uint32_t>(model::golden::evaluate_reference(design_.reference, operands));
}

void Judge::take(const Answer& answer) {
  for (const wire::Result& result : answer.results) take_result(result);
  for (const wire::Violation& violation : answer.violations) take_violation(violation);
  report_.cycles = answer.cycles;
  take_counters(answer.lanes);
  retire();
}

void Judge::take_result(const wire::Result& result) {
  MIXCMP_CHECK(result.position >= window_start_ &&
               result.position - window_start_ < window_.size());
  Fate& fate = window_[result.position - window_start_];
  MIXCMP_CHECK(!fate.has_left);  // the simulator reports doubles as violations
  fate.has_left = true;
  fate.lane = result.lane;
  fate.tdata = result.tdata;
  ++report_.comparisons;
  GroupReport& group = group_of(result.lane);
  ++group.comparisons;
  const bool decided = (result.tdata & (recomputed_flag | undecided_flag)) == 0;
  if (!decided && !first_undecided_) first_undecided_ = result;
  const std::uint64_t cycles = result.cycle_left - result.cycle_accepted;
  (decided ? report_.decided_latency : report_.recomputed_latency).add(cycles);
  (decided ? group.decided_latency : group.recomputed_latency).add(cycles);

  std::vector<model::Bits> operands(comparisons_.input_count());
  comparisons_.fetch(selection_.index(result.position), operands);
  const std::uint32_t expected = expected_tdata(result.lane, operands);
  if (meaningful(result.tdata) == expected) return;
  ++report_.mismatch_count;
  ++group.mismatches;
  if (report_.mismatches.size() < VerifyReport::kept) {
    report_.mismatches.push_back(describe(result, operands, expected));
  }
}

Mismatch Judge::describe(const wire::Result& result, std::span<const model::Bits> operands,
                         std::uint32_t expected) const {
  const std::uint64_t index = selection_.index(result.position);
  Mismatch mismatch{.index = index,
                    .expected = describe_tdata(expected),
                    .got = describe_tdata(result.tdata),
                    .lane = result.lane,
                    .cycle = result.cycle_left};
  mismatch.items = model::describe(comparisons_, index);
  const model::FloatFormat format = design_.reference.input_format;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    mismatch.operands.push_back({design_.inputs[k], model::to_hex(operands[k], format.width()),
                                 model::golden::to_text(format, operands[k])});
  }
  if (!options_.repeat_command.empty()) {
    mismatch.repeat = fmt::format("{} --only {}", options_.repeat_command, index);
  }
  return mismatch;
}

void Judge::take_violation(const wire::Violation& violation) {
  if (violation.fault == wire::Fault::lost) {
    window_[violation.position - window_start_].lost = true;
  }
  ++report_.violation_count;
  if (report_.violations.size() >= VerifyReport::kept) return;
  ProtocolViolation told{to_text(violation.fault), violation.lane, violation.cycle,
                         fmt::format("tag 0x{:x}", violation.tag)};
  if (violation.position != wire::no_position) {
    told.details += fmt::format(", comparison {}", selection_.index(violation.position));
  }
  report_.violations.push_back(std::move(told));
}

void Judge::take_counters(const std::vector<wire::LaneEnd>& lanes) {
  if (lanes.empty() || signature_.counter_bits == 0) return;
  constexpr const char* names[] = {"comparisons", "recomputations", "stalls"};
  const auto mask = static_cast<std::uint64_t>(model::low_mask(signature_.counter_bits));
  for (int k = 0; k < 3; ++k) {
    CounterTotal total{names[k], 0, 0};
    for (std::uint32_t lane = 0; lane < lanes.size(); ++lane) {
      const std::uint64_t counted = lanes[lane].counted[k];
      const std::uint64_t observed = lanes[lane].observed[k];
      total.counted += counted;
      total.observed += observed;
      if (counted != (observed & mask)) report_wrong_counter(names[k], lane, counted, observed);
    }
    report_.counters.push_back(total);
  }
}

void Judge::report_wrong_counter(const char* name, std::uint32_t lane, std::uint64_t counted,
                                 std::uint64_t observed) {
  ++report_.violation_count;
  if (report_.violations.size() >= VerifyReport::kept) return;
  report_.violations.push_back({"counter is wrong", lane, report_.cycles,
                                fmt::format("{}: {} instead of {}", name, counted, observed)});
}

void Judge::retire() {
  while (!window_.empty() && (window_.front().has_left || window_.front().lost)) {
    if (window_.front().has_left) count(selection_.index(window_start_), window_.front());
    window_.pop_front();
    ++window_start_;
  }
}

void Judge::count(std::uint64_t index, const Fate& fate) {
  const auto verdict = static_cast<Verdict>(fate.tdata & 3);
  const bool undecided = (fate.tdata & undecided_flag) != 0;
  const bool recomputed = (fate.tdata & recomputed_flag) != 0;
  GroupReport& group = group_of(fate.lane);
  if (recomputed) {
    ++report_.recomputations;
    ++group.recomputations;
  }
  if (undecided) {
    ++report_.undecided;
    ++group.undecided;
  } else {
    ++report_.verdicts[static_cast<std::size_t>(verdict)];
    check_truth(index, fate);
  }
  if (options_.on_result) options_.on_result({index, verdict, recomputed, undecided});
}

void Judge::check_truth(std::uint64_t index, const Fate& fate) {
  if (!options_.truth) return;
  const bool recomputed = (fate.tdata & recomputed_flag) != 0;
  if (options_.truth->scope == TruthScope::recomputed && !recomputed) return;
  std::vector<model::Bits> operands(comparisons_.input_count());
  comparisons_.fetch(index, operands);
  // Infinite and NaN operands are no real numbers: there the reference's arithmetic is what counts.
  if (recomputed && !are_finite(design_.reference.input_format, operands)) return;
  const Verdict truth =
      model::golden::true_verdict(*options_.truth->graph, design_.reference.input_format, operands);
  ++report_.truth->checked;
  if (static_cast<Verdict>(fate.tdata & 3) == truth) return;
  if (recomputed) {
    ++report_.truth->wrong_by_reference;
  } else {
    ++report_.truth->wrong_by_lane;
    ++group_of(fate.lane).wrong_by_lane;
  }
}

}  // namespace mixcmp::tb

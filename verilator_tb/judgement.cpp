#include "verilator_tb/judgement.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/base/number/decimal.hpp"
#include "model/base/number/verdict.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"

namespace mixcmp::verilator_tb {

VerifyReport empty_report(const emit::Signature& signature, const design::Design& design,
                          const VerifyOptions& options) {
  VerifyReport report;
  report.system = signature.top;
  report.lanes = design.lane_count();
  report.lanes_per_group = signature.lanes_per_group;
  report.references = design.reference_count();
  report.certified = design.certified();
  report.resets = static_cast<std::uint64_t>(std::max(options.resets, 0));
  if (options.truth) report.truth.emplace();
  const std::vector<std::string> names = lane_group_names(design);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const design::LaneGroup& group = design.lanes[k];
    report.groups.push_back(
        {.name = names[k], .lanes = group.count, .certified = design::is_certified(group.lane)});
  }
  return report;
}

namespace {

golden::LaneResult decide(const design::Lane& lane, std::span<const Bits> operands) {
  return std::visit([&](const auto& made) { return golden::evaluate_lane(made, operands); }, lane);
}

}  // namespace

Verdict reference_verdict(const design::Design& design, std::span<const Bits> operands) {
  const fixed::FixedLane* rounding = design.requested_reference();
  if (rounding != nullptr) return golden::evaluate_lane(*rounding, operands).verdict;
  return golden::evaluate_reference(design.reference, operands);
}

ResultWord expected_word(const design::Design& design, std::size_t group,
                         std::span<const Bits> operands) {
  const golden::LaneResult first = decide(design.lanes[group].lane, operands);
  if (first.decided) return ResultWord::decided(first.verdict);
  if (design.second_tier) {
    const golden::LaneResult second = decide(design.second_tier->lane, operands);
    const bool marked = design.has_second_lanes();
    if (second.decided && marked) return ResultWord::recomputed(second.verdict);
    if (second.decided) return ResultWord::decided(second.verdict);
  }
  if (design.references.empty()) return ResultWord::undecided();
  return ResultWord::recomputed(reference_verdict(design, operands));
}

bool reaches_reference(const design::Design& design, std::span<const Bits> operands) {
  return !design.second_tier || !decide(design.second_tier->lane, operands).decided;
}

bool computes_numbers(const design::Design& design, std::span<const Bits> operands) {
  if (const fixed::FixedLane* rounding = design.requested_reference()) {
    return golden::evaluate_lane(*rounding, operands).verdict != Verdict::unordered;
  }
  const FloatFormat arriving = design.reference.input_format;
  const std::vector<golden::Rounded> values = golden::evaluate(design.reference, operands);
  bool all_finite = std::all_of(operands.begin(), operands.end(),
                                [&](Bits operand) { return arriving.is_finite(operand); });
  for (std::size_t k = 0; k < values.size(); ++k) {
    all_finite = all_finite && design.reference.nodes[k].format.is_finite(values[k].bits);
  }
  return all_finite;
}

std::string describe(ResultWord word) {
  if (!word.is_possible()) return fmt::format("the impossible tdata 0x{:02x}", word.bits());
  if (word.is_undecided()) return "undecided";
  return fmt::format("{}, {}", to_string(word.verdict()),
                     word.is_recomputed() ? "recomputed" : "decided by the lane");
}

std::string to_text(harness::wire::Fault fault) {
  switch (fault) {
    case harness::wire::Fault::valid_dropped: return "tvalid fell before tready rose";
    case harness::wire::Fault::payload_changed: return "payload changed while waiting for tready";
    case harness::wire::Fault::unknown_tag: return "result with a tag that is not inside";
    case harness::wire::Fault::duplicate_tag: return "result left twice";
    case harness::wire::Fault::stale_after_reset: return "result from before a reset left after it";
    case harness::wire::Fault::valid_in_reset: return "tvalid high in reset";
    case harness::wire::Fault::order_broken: return "result overtook an earlier one";
    case harness::wire::Fault::lost: return "comparison lost";
    case harness::wire::Fault::hung: return "lane stands still";
    case harness::wire::Fault::unknown_refetch: return "refetch of a tag that is not inside";
    case harness::wire::Fault::unknown_value: return "unknown value (x) in a handshake or a beat";
    case harness::wire::Fault::after_the_end: return "report behind the closing beat";
    case harness::wire::Fault::closed_early: return "closing beat before the last item";
    case harness::wire::Fault::loaded_among_rows: return "candidate accepted while rows are inside";
    case harness::wire::Fault::counter_port: return "counter port broke AXI4-Lite";
  }
  MIXCMP_CHECK(false);
  return {};
}

Mismatch describe_comparison(const design::Design& design, const data::Comparisons& comparisons,
                             std::uint64_t index) {
  Mismatch mismatch{.index = index};
  mismatch.items = data::describe(comparisons, index);
  std::vector<Bits> operands(comparisons.input_count());
  comparisons.fetch(index, operands);
  const FloatFormat format = design.reference.input_format;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    mismatch.operands.push_back(
        {design.inputs[k], to_hex(operands[k], format.width()), to_text(format, operands[k])});
  }
  return mismatch;
}

void check_against_truth(const TruthCheck& check, const design::Design& design,
                         std::span<const Bits> operands, ResultWord word, TruthCount& truth,
                         GroupReport& group) {
  if (word.is_undecided()) {
    ++truth.undecided;
    return;
  }
  const bool recomputed = word.is_recomputed() && reaches_reference(design, operands);
  if (check.scope == TruthScope::recomputed && !recomputed) {
    ++truth.decided_by_lane;
    return;
  }
  const auto verdict = golden::true_verdict(*check.graph, design.reference.input_format, operands);
  if (!verdict) {
    ++truth.undetermined;
    return;
  }
  const bool has_order = *verdict != Verdict::unordered;
  if (recomputed && !has_order) {
    // Infinities and NaN are a reference's way to say that there is no value.
    if (word.verdict() == Verdict::unordered || !computes_numbers(design, operands)) {
      ++truth.undefined;
      return;
    }
    ++truth.ordered_without_value;
  }
  ++truth.checked;
  if (has_order && !design.references.empty()) {
    ++truth.reference_alone_checked;
    truth.reference_alone_wrong += reference_verdict(design, operands) == *verdict ? 0 : 1;
  }
  if (word.verdict() == *verdict) return;
  if (recomputed) {
    ++truth.wrong_by_reference;
  } else {
    ++truth.wrong_by_lane;
    ++group.wrong_by_lane;
  }
}

}  // namespace mixcmp::verilator_tb

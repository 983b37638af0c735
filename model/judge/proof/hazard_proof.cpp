#include "model/judge/proof/hazard_proof.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "model/base/common/check.hpp"
#include "model/judge/proof/node_prover.hpp"
#include "model/judge/proof/node_ranges.hpp"
#include "model/lane/error/hazards.hpp"
#include "model/lane/error/sign.hpp"

namespace mixcmp::proof {
namespace {

enum class Side { above, below };  ///< of zero

class HazardProof {
public:
  HazardProof(const error::Lane& lane, const Prove& prove)
      : lane_(lane),
        graph_(lane.graph),
        nodes_(lane, no_claims_, prove),
        ranges_(lane, nodes_),
        checked_(enforced_ranges(lane)) {}

  std::vector<Finding> run() &&;

private:
  const TypedNode& node(NodeId id) const { return graph_.nodes[id]; }
  const error::Hazards& hazards(NodeId id) const {
    return lane_.hazards[static_cast<std::size_t>(id)];
  }

  template <typename Predicate>
  bool all_operands(NodeId id, Predicate predicate) {
    const auto operands = node(id).operands.begin();
    return std::all_of(operands, operands + arity(node(id).operation), predicate);
  }

  void prove_unbuilt(NodeId id);
  void add_unbuilt(NodeId id, const std::string& left_out, const std::string& doubtful);
  bool is_finite(NodeId id);
  bool never_overflows(NodeId id);
  bool never_subnormal(NodeId id);
  bool is_apart_from_zero(NodeId id);
  bool is_flushed(NodeId id);
  bool adds_one_sign(NodeId id);
  bool lies(NodeId id, Side side);
  bool is_signed_by_hand(NodeId id) const;

  const error::Lane& lane_;
  const TypedGraph& graph_;
  const std::vector<NodeClaim> no_claims_;
  NodeProver nodes_;
  NodeRanges ranges_;
  std::vector<std::optional<Range>> checked_;
};

std::vector<Finding> HazardProof::run() && {
  if (lane_.hazards.empty()) return {};
  for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) {
    if (error::has_unit(node(id).operation)) prove_unbuilt(id);
  }
  return std::move(nodes_).take();
}

void HazardProof::prove_unbuilt(NodeId id) {
  const error::Hazards& built = hazards(id);
  std::string left_out, doubtful;
  const auto leave_out = [&](const char* name, bool holds) {
    left_out += (left_out.empty() ? "" : ", ") + std::string(name);
    if (!holds && doubtful.empty()) doubtful = name;
  };
  if (!built.special_operand) {
    leave_out("special operands", all_operands(id, [&](NodeId k) { return is_finite(k); }));
  }
  if (!built.overflow) leave_out("overflow", never_overflows(id));
  if (!built.underflow) {
    const bool harmless = is_choice(node(id).operation) || is_apart_from_zero(id);
    leave_out("underflow", harmless && never_subnormal(id) &&
                               all_operands(id, [&](NodeId k) { return never_subnormal(k); }));
  }
  const bool sums =
      node(id).operation == Operation::add || node(id).operation == Operation::subtract;
  if (sums && !built.cancellation && adds_one_sign(id)) leave_out("cancellation", true);
  if (!left_out.empty()) add_unbuilt(id, left_out, doubtful);
  if (!sums || built.cancellation || adds_one_sign(id)) return;
  nodes_.add({fmt::format("{} adds numbers of one sign", nodes_.text(id)),
              is_signed_by_hand(id) ? Outcome::not_expressible : Outcome::not_proven,
              "no range says so; theorem 6, by hand"});
}

void HazardProof::add_unbuilt(NodeId id, const std::string& left_out, const std::string& doubtful) {
  nodes_.add(
      {fmt::format("{} needs no hardware for: {}", nodes_.text(id), left_out),
       doubtful.empty() ? Outcome::proven : Outcome::not_proven,
       doubtful.empty() ? "by exact arithmetic, from these ranges" : doubtful + " may occur"});
}

/// Whether a node can be neither a NaN nor an infinity, even if no flag is looked at.
bool HazardProof::is_finite(NodeId id) {
  switch (node(id).operation) {
    case Operation::input: return checked_[static_cast<std::size_t>(node(id).input)].has_value();
    case Operation::constant: return !node(id).format.is_infinite(node(id).constant);
    case Operation::negate:
    case Operation::absolute: return is_finite(node(id).operands[0]);
    case Operation::square_root:
      if (ranges_.prove_range(node(id).operands[0]).low < 0) return false;
      break;
    case Operation::convert:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square:
    case Operation::divide:
    case Operation::minimum:
    case Operation::maximum:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  return never_overflows(id) && all_operands(id, [&](NodeId k) { return is_finite(k); });
}

/// Whether a node's range lies within its format. False if the node has the flag for overflow,
/// since its range may then assume a finite result. A selection never overflows.
bool HazardProof::never_overflows(NodeId id) {
  if (is_choice(node(id).operation)) return true;
  const bool divides = node(id).operation == Operation::divide;
  if (divides && least_magnitude(ranges_.prove_range(node(id).operands[1])) == 0) return false;
  return !flags_overflow(lane_, id) &&
         greatest_magnitude(ranges_.prove_range(id)) <= largest_number(node(id).format);
}

/// Whether a node is always zero, or never below the smallest normal number in magnitude.
bool HazardProof::is_apart_from_zero(NodeId id) {
  const Range& range = ranges_.prove_range(id);
  if (range.low == 0 && range.high == 0) return true;
  return least_magnitude(range) >= power_of_two(node(id).format.min_exponent());
}

bool HazardProof::never_subnormal(NodeId id) {
  const bool flushes = graph_.arithmetic.subnormals == Subnormals::flush;
  return (flushes && is_flushed(id)) || is_apart_from_zero(id);
}

/// Whether a node is the result of a unit that flushes subnormal numbers, or a sign change or a
/// selection of such results.
bool HazardProof::is_flushed(NodeId id) {
  switch (node(id).operation) {
    case Operation::input:
    case Operation::constant: return false;
    case Operation::negate:
    case Operation::absolute:
    case Operation::minimum:
    case Operation::maximum: return all_operands(id, [&](NodeId k) { return is_flushed(k); });
    case Operation::convert:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square:
    case Operation::divide:
    case Operation::square_root:
    case Operation::fused_sum: return true;
    case Operation::function:
    case Operation::look_up: break;
  }
  MIXCMP_CHECK(false);
}

bool HazardProof::adds_one_sign(NodeId id) {
  const auto [a, b] = node(id).operands;
  const bool subtracts = node(id).operation == Operation::subtract;
  return (lies(a, Side::above) && lies(b, subtracts ? Side::below : Side::above)) ||
         (lies(a, Side::below) && lies(b, subtracts ? Side::above : Side::below));
}

/// Whether a node's range lies on this side of zero; zero lies on both. A quotient's range is
/// unbounded if its divisor may be zero, so the ranges of its operands are tried as well.
bool HazardProof::lies(NodeId id, Side side) {
  const Range& range = ranges_.prove_range(id);
  if (side == Side::above ? range.low >= 0 : range.high <= 0) return true;
  if (node(id).operation != Operation::divide) return false;
  const auto [a, b] = node(id).operands;
  const Side other = side == Side::above ? Side::below : Side::above;
  return (lies(a, side) && lies(b, Side::above)) || (lies(a, other) && lies(b, Side::below));
}

/// Whether theorem 6's analysis of signs shows that a sum adds numbers of one sign. It does so for
/// quotients of zero by any number, whose range does not show their sign.
bool HazardProof::is_signed_by_hand(NodeId id) const {
  std::vector<bool> nonnegative;
  for (const auto& range : checked_) nonnegative.push_back(range && range->low >= 0);
  const std::vector<error::Sign> signs = error::analyse_signs(graph_, nonnegative);
  const auto [a, b] = node(id).operands;
  const bool subtracts = node(id).operation == Operation::subtract;
  const error::Sign sum = error::sum_sign(signs[a], subtracts ? signs[b].negated() : signs[b]);
  return sum.nonnegative || sum.nonpositive;
}

}  // namespace

std::vector<Finding> prove_hazards(const error::Lane& lane, const Prove& prove) {
  return HazardProof(lane, prove).run();
}

}  // namespace mixcmp::proof

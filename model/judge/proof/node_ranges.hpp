#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/judge/proof/node_prover.hpp"
#include "model/lane/error/lane.hpp"

namespace mixcmp::proof {

/// The range of the operands that pass the check, from the bits that the hardware compares and not
/// from the scene's range. None if a NaN or an infinity would pass as well.
std::optional<Range> enforced_range(const error::RangeCheck& check, FloatFormat format);
/// One range per input of the lane's graph; none for an input whose magnitude is not checked.
std::vector<std::optional<Range>> enforced_ranges(const error::Lane& lane);

/// An operation's exact result in Gappa's syntax; not for inputs, constants, minima and maxima.
std::string result_text(const TypedNode& node, const std::string& a, const std::string& b);

/// Whether the unit of this node raises a flag on overflow and on division by zero.
bool flags_overflow(const error::Lane& lane, NodeId id);

/// The smallest positive and the largest finite number of a format.
mpq_class smallest_number(FloatFormat format);
mpq_class largest_number(FloatFormat format);
/// The power of two at or below a positive value.
mpq_class binade(const mpq_class& value);
/// The least and the greatest magnitude of the numbers in a range.
mpq_class least_magnitude(const Range& range);
mpq_class greatest_magnitude(const Range& range);

/// Intervals of the values that a lane computes if every operand passes its check and no operation
/// is exceptional. Interval analysis proposes an interval, and Gappa proves it from those of the
/// node's operands, with one script per operation. The intervals of inputs are those that their
/// checks enforce.
class NodeRanges {
public:
  NodeRanges(const error::Lane& lane, NodeProver& nodes);

  /// Proves the ranges of the node and of all nodes that it depends on, each once. Returns the
  /// range even if the proof fails. The findings of the NodeProver say whether it is proven.
  const Range& prove_range(NodeId id);

private:
  Range given(NodeId id) const;
  void prove_operation(NodeId id);
  std::string script(NodeId id) const;
  std::vector<std::string> selection_scripts(NodeId id) const;
  bool is_any_finite_quotient(NodeId id) const;

  const error::Lane& lane_;
  const TypedGraph& graph_;
  NodeProver& nodes_;
  std::vector<Range> ranges_;
  std::vector<bool> done_;
};

}  // namespace mixcmp::proof

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/error/lane.hpp"
#include "model/proof/node_prover.hpp"

namespace mixcmp::model::proof {

/// Encloses every operand that passes the check, read off the bits that the hardware compares and
/// not off the scene's range. None where a NaN or an infinity would pass, too.
std::optional<Range> enforced_range(const RangeCheck& check, FloatFormat format);
/// One per input of the lane's graph; none for an input whose magnitude is not checked.
std::vector<std::optional<Range>> enforced_ranges(const Lane& lane);

/// An operation's exact result as Gappa writes it; not of inputs, constants, minima and maxima.
std::string result_text(const TypedNode& node, const std::string& a, const std::string& b);

/// Whether a unit of this node raises a flag on overflow and on a division by zero.
bool flags_overflow(const Lane& lane, NodeId id);

/// The smallest number of a format that is not zero, and its largest finite one.
mpq_class smallest_number(FloatFormat format);
mpq_class largest_number(FloatFormat format);
/// The power of two at or below a positive value.
mpq_class binade(const mpq_class& value);
/// The least and the greatest magnitude of the numbers in a range.
mpq_class least_magnitude(const Range& range);
mpq_class greatest_magnitude(const Range& range);

/// Intervals of the values that a lane computes wherever every operand passes its check and no
/// operation is exceptional. Interval analysis proposes each, Gappa proves it from those of the
/// node's operands, one script an operation; those of inputs are what their checks enforce.
class NodeRanges {
public:
  NodeRanges(const Lane& lane, NodeProver& nodes);

  /// Runs Gappa on the node's range and on those below it, once each. The range is returned in
  /// either case: the findings, which are the NodeProver's, say whether it is proven.
  const Range& prove_range(NodeId id);

private:
  Range given(NodeId id) const;
  void prove_operation(NodeId id);
  std::string script(NodeId id) const;
  std::vector<std::string> selection_scripts(NodeId id) const;
  bool is_any_finite_quotient(NodeId id) const;

  const Lane& lane_;
  const TypedGraph& graph_;
  NodeProver& nodes_;
  std::vector<Range> ranges_;
  std::vector<bool> done_;
};

}  // namespace mixcmp::model::proof

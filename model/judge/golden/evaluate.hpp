#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "model/judge/golden/arithmetic.hpp"
#include "model/lane/error/lane.hpp"

namespace mixcmp::golden {

/// Evaluates every node of `graph` on one comparison; `inputs` are in graph.input_format, one per
/// input. Constants are rounded here, from their exact values: the graph's encodings, from which
/// the Verilog's literals are made, are not read. Negate and absolute change only the sign bit,
/// also of a NaN, and are exceptional for NaN and infinite operands.
std::vector<Rounded> evaluate(const TypedGraph& graph, std::span<const Bits> inputs);

/// Evaluates every node of `bound` on the values that `evaluate` returned for the lane's graph.
std::vector<Bits> evaluate_bound(const error::BoundGraph& bound, const TypedGraph& graph,
                                 const std::vector<Rounded>& values);

/// Whether an operand passes its check; `format` is the operand's.
bool passes(const error::RangeCheck& check, FloatFormat format, Bits operand);

struct LaneResult {
  bool decided;
  Verdict verdict;  ///< valid if decided; unordered only from a reference
};

/// The decision of a lane from those of its parts: theorem 11 of docs/error_bounds.md.
LaneResult combine_parts(Combination combination, std::span<const LaneResult> parts);

/// The decision of a lane in hardware, bit for bit.
LaneResult evaluate_lane(const error::Lane& lane, std::span<const Bits> inputs);

/// The verdict of a reference datapath: the order of f and g as computed in its format.
Verdict evaluate_reference(const TypedGraph& reference, std::span<const Bits> inputs);

/// The verdict of one part that decides the whole comparison, whatever the other parts' verdicts
/// are: `greater` for Combination::all, `less` for Combination::any.
Verdict dominating_verdict(Combination combination);
/// Combines two parts' verdicts into one; associative and commutative.
Verdict combine(Combination combination, Verdict a, Verdict b);

/// The order of the real numbers f and g of these inputs, which are exact values in `format`. With
/// several parts it is their combined verdict. It is `unordered` if f or g has no value: for a NaN,
/// an infinite input, a division by zero, the root of a negative number or the logarithm of a
/// number that is not positive.
///
/// Interval arithmetic of growing precision decides. If an interval contains zero, the value's
/// separation from zero (separation.hpp) decides. So ties, and zeros hidden behind roots and
/// roundoff, are proven and never guessed. There is no verdict ("undetermined") if 2^14 bits do not
/// suffice (2^15 to 2^17 bits for 13 to 15 exponent bits). That happens for ties of sums of about
/// eight roots or more, and of rational numbers of that many bits. It happens for ties of
/// functions, such as exp(log(a)) and a, unless both sides apply the same operations to equal
/// numbers, and for values beyond MPFR's exponents, such as exp(1e20).
std::optional<Verdict> true_verdict(const Graph& graph, FloatFormat format,
                                    std::span<const Bits> inputs);

/// The verdict that true_verdict finds with intervals of at most `bits` bits, at least 128; none if
/// these do not suffice.
std::optional<Verdict> verdict_within(const Graph& graph, FloatFormat format,
                                      std::span<const Bits> inputs, long bits);

}  // namespace mixcmp::golden

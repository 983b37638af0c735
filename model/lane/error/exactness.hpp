#pragma once

#include <optional>
#include <vector>

#include "model/base/common/result.hpp"
#include "model/base/number/operand_format.hpp"
#include "model/comparison/expression/range.hpp"
#include "model/comparison/expression/typed_graph.hpp"

namespace mixcmp::error {

/// Tells for each node of a graph whether it holds its expression's real value exactly: the format
/// of the node has all digits of the value, and neither overflows nor makes it subnormal and
/// inexact.
///
/// A value's digits are known in two ways. If every value of a node is a multiple of some 2^k and
/// at most 2^m, m - k digits suffice; for an input, k and m follow from its grid and its range, or
/// from the format in which it arrives. And an input has the digits of its format; a product, the
/// sum of its factors' digits; a minimum, the larger number of the two. A fused sum, or the sign of
/// one, is exact if it cuts no digit of a term. These nodes are not exact, nor is any node that
/// depends on one: divisions other than by powers of two, roots, and constants that the format
/// rounds.
std::vector<bool> exact_nodes(const TypedGraph& graph,
                              const std::vector<std::optional<Range>>& ranges,
                              const std::vector<std::optional<mpq_class>>& grids);

/// The smallest floating-point format that holds all operands, as format_holding has it, and in
/// which no operation of the comparison rounds. An error names the operation that rounds in every
/// format, or that needs too many digits. All arguments but the graph have one entry per input;
/// those in fixed point need neither a range nor a grid.
Result<FloatFormat> exact_format(const Graph& graph, const std::vector<OperandFormat>& formats,
                                 const std::vector<std::optional<Range>>& ranges,
                                 const std::vector<std::optional<mpq_class>>& grids);

}  // namespace mixcmp::error

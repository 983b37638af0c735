#include "model/fixed/fixed_lane.hpp"

#include <fmt/core.h>

#include "model/fixed/graph_builder.hpp"
#include "model/fixed/norm_bound.hpp"
#include "model/number/dyadic.hpp"

namespace mixcmp::fixed {
namespace {

/// The thresholds behind which the difference, less its error, has a certain sign. Proof:
/// docs/fixed_point.md, theorem 3.
ConstantThresholds constant_thresholds(const FixedNode& difference) {
  const mpq_class unit = difference.format.unit();
  const Range& error = difference.error;
  return {.greater_from = floor_of(error.high / unit) + 1,
          .less_to = ceiling_of(error.low / unit) - 1,
          .exact = error.low == 0 && error.high == 0};
}

/// The part decided by a norm, if f and g have the form.
std::optional<FixedPart> norm_part(FixedGraphBuilder& builder, NodeId f, NodeId g) {
  for (const bool swapped : {false, true}) {
    const NodeId sum = swapped ? g : f, square = swapped ? f : g;
    const auto sides = norm_sides(builder.nodes(), sum, square);
    if (!sides) continue;
    const NodeId difference = builder.difference(sum, square);
    if (builder.nodes()[difference].dropped_bits > 0) continue;
    return FixedPart{
        .difference = difference,
        .swapped = swapped,
        .decision = norm_thresholds(builder.nodes(), *sides, builder.nodes()[difference])};
  }
  return std::nullopt;
}

Result<FixedPart> make_part(FixedGraphBuilder& builder, const Sides& sides,
                            const FixedOptions& options) {
  MIXCMP_TRY(f, builder.node(sides.f));
  MIXCMP_TRY(g, builder.node(sides.g));
  if (options.bound != FixedBound::constant) {
    if (auto part = norm_part(builder, f, g)) return *part;
  }
  if (options.bound == FixedBound::norm) {
    return Error{.field = "reduced.error_bound",
                 .message =
                     "no norm bound: it needs a sum of squares against the square of what "
                     "is never negative",
                 .received = "norm",
                 .accepted = "constant"};
  }
  const NodeId difference = builder.difference(f, g);
  return FixedPart{.difference = difference,
                   .decision = constant_thresholds(builder.nodes()[difference])};
}

}  // namespace

Result<FixedLane> fixed_lane(const Graph& graph, FloatFormat input_format,
                             const FixedOptions& options) {
  FixedGraphBuilder builder(graph, input_format, options);
  FixedLane lane{.nodes = {},
                 .input_names = graph.inputs(),
                 .input_format = input_format,
                 .parts = {},
                 .combination = graph.combination()};
  for (const Sides& sides : graph.parts()) {
    MIXCMP_TRY(part, make_part(builder, sides, options));
    lane.parts.push_back(std::move(part));
  }
  lane.nodes = std::move(builder.nodes());
  return lane;
}

}  // namespace mixcmp::fixed

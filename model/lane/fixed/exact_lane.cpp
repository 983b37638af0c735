#include "model/lane/fixed/exact_lane.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "model/base/number/double.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/comparison/expression/text.hpp"

namespace mixcmp::fixed {
namespace {

constexpr std::size_t most_characters = 60;

Error not_exact(std::string message, std::string received, std::string accepted) {
  return {.field = "reduced.format",
          .message = std::move(message),
          .received = std::move(received),
          .accepted = std::move(accepted)};
}

std::string text_of(const Graph& graph) {
  return to_text(graph, graph.parts().front().f, most_characters);
}

Error too_wide(const Graph& graph, int most_bits) {
  return not_exact(fmt::format("it takes more than {} bits", most_bits), text_of(graph),
                   "operands with fewer bits");
}

/// Whether no node has an error, so that a reference in a format with enough digits rounds nothing.
bool has_no_error(const FixedLane& lane) {
  return std::all_of(lane.nodes.begin(), lane.nodes.end(), [](const FixedNode& node) {
    return node.error.low == 0 && node.error.high == 0;
  });
}

/// Whether a constant needs no more than some binary digits: its value is a multiple of a power of
/// two.
bool is_dyadic(const FixedNode& constant) {
  const mpq_class exact = constant.value.low - constant.error.low;
  return mixcmp::is_power_of_two(mpq_class(exact.get_den()));
}

/// Why the lane, which has the most bits that are allowed, has an error or leaves something
/// undecided.
Error reason(const FixedLane& lane, const Graph& graph) {
  for (const FixedNode& node : lane.nodes) {
    if (node.operation == Operation::constant && !is_dyadic(node)) {
      return not_exact("a constant is no multiple of a power of two",
                       fmt::format("one near {}", rounded_text(node.value.low, 6)),
                       "constants such as 0.25");
    }
    if (node.operation == Operation::square_root) {
      return not_exact("square roots are rounded", "sqrt in f or g", "the squares of both sides");
    }
  }
  const bool has_limits = std::any_of(lane.nodes.begin(), lane.nodes.end(), is_checked);
  if (has_limits && has_no_error(lane)) {
    return not_exact("limits leave comparisons undecided", text_of(graph),
                     "f and g without limits");
  }
  return too_wide(graph, lane.format.bits);
}

/// The most bits of any operand's magnitude that arrives in fixed point.
int widest(const std::vector<OperandFormat>& operand_formats) {
  int bits = 1;
  for (const OperandFormat& format : operand_formats) {
    if (format.fixed() != nullptr) bits = std::max(bits, format.fixed()->magnitude_bits());
  }
  return bits;
}

/// Why no lane with this bound is exact for an input in floating point.
Error not_exact_in_floating_point(const Graph& graph, const FixedOptions& options,
                                  std::size_t input) {
  const std::string& name = graph.inputs()[input];
  if (options.bound && options.bound != BoundKind::grid) {
    return {
        .field = "reduced.error_bound",
        .message = "only the bound grid makes a lane exact for an input in floating point, " + name,
        .received = std::string(to_string(*options.bound)),
        .accepted = "auto, grid"};
  }
  return not_exact("an input has neither a format in fixed point nor a grid",
                   fmt::format("{} in {}", name, options.operand_formats[input].name()),
                   "inputs with a format such as uint10, or with a range and a grid");
}

/// The lane with the fewest bits for which `property` holds. With the bound `grid`, fixed_lane
/// fails where bits are too few, so these errors are skipped.
Result<FixedLane> lane_with(bool (*property)(const FixedLane&), const Graph& graph,
                            FloatFormat input_format, FixedOptions options, int most_bits) {
  for (std::size_t input = 0; input < options.operand_formats.size(); ++input) {
    const bool is_fixed = options.operand_formats[input].fixed() != nullptr;
    if (is_fixed || options.relied_grid(input) != nullptr) continue;
    return not_exact_in_floating_point(graph, options, input);
  }
  const auto lane_of = [&](int bits) {
    options.format = {.bits = bits};
    return fixed_lane(graph, input_format, options);
  };
  for (int bits = std::max(2, widest(options.operand_formats)); bits <= most_bits; ++bits) {
    Result<FixedLane> lane = lane_of(bits);
    if (lane.ok() && property(*lane)) return lane;
    if (!lane.ok() && options.bound != BoundKind::grid) return lane;
  }
  if (options.bound == BoundKind::grid) options.bound = BoundKind::constant;
  MIXCMP_TRY(widest_lane, lane_of(most_bits));
  return reason(widest_lane, graph);
}

}  // namespace

Result<int> exact_bits(const Graph& graph, FloatFormat input_format, FixedOptions options,
                       int most_bits) {
  const auto property = options.bound == BoundKind::grid ? rounds_nothing : is_exact;
  MIXCMP_TRY(lane, lane_with(property, graph, input_format, std::move(options), most_bits));
  return lane.format.bits;
}

}  // namespace mixcmp::fixed

#include "model/judge/emulator/code.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

#include "model/base/common/check.hpp"
#include "model/base/number/double.hpp"
#include "model/judge/emulator/criterion_code.hpp"
#include "model/judge/emulator/safe_operands.hpp"

namespace mixcmp::emulator {
namespace {

/// Formats with at most this many exponent bits lie within double's normal numbers, including
/// subnormal numbers of 53 digits.
constexpr int widest_free_exponent_bits = 9;

bool is_wide(FloatFormat format) {
  return format.exponent_bits() > widest_free_exponent_bits;
}

/// The results that double computes as the format would. Between 2^-500 and 2^500 no value that a
/// single operation needs underflows or overflows in double. `trusted_operands` adds the subnormal
/// operands if lanes read those unchanged.
TrustedRange trusted(FloatFormat format) {
  const auto [least, limit] = trusted_exponents(format);
  return {.columns = {}, .least = std::ldexp(1, least), .limit = std::ldexp(1, limit)};
}

/// The bits of a double below the format's last digit.
std::uint64_t surplus_digits(FloatFormat format) {
  return (std::uint64_t{1} << (double_digits - format.precision())) - 1;
}

TrustedRange trusted_operands(FloatFormat format, Subnormals subnormals) {
  TrustedRange range = trusted(format);
  if (subnormals == Subnormals::gradual && !is_wide(format)) range.least = 0;
  range.any_double = is_wide(format);
  range.zero_bits = surplus_digits(format);
  return range;
}

bool is_trusted(const TrustedRange& range, double value) {
  const double magnitude = std::fabs(value);
  return magnitude == 0 || (range.least <= magnitude && magnitude < range.limit);
}

bool rounds(Operation operation) {
  switch (operation) {
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square:
    case Operation::divide:
    case Operation::square_root:
    case Operation::convert:
    case Operation::fused_sum: return true;
    case Operation::function:
    case Operation::look_up: break;
    case Operation::input:
    case Operation::constant:
    case Operation::negate:
    case Operation::absolute:
    case Operation::minimum:
    case Operation::maximum: return false;
  }
  MIXCMP_CHECK(false);
}

Kernel kernel_of(Operation operation) {
  switch (operation) {
    case Operation::add: return Kernel::add;
    case Operation::subtract: return Kernel::subtract;
    case Operation::multiply: return Kernel::multiply;
    case Operation::square: return Kernel::square;
    case Operation::divide: return Kernel::divide;
    case Operation::square_root: return Kernel::square_root;
    case Operation::convert: return Kernel::convert;
    case Operation::negate: return Kernel::negate;
    case Operation::absolute: return Kernel::absolute;
    case Operation::minimum: return Kernel::minimum;
    case Operation::maximum: return Kernel::maximum;
    case Operation::input:
    case Operation::constant:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(false);
}

/// With up to 25 digits in and out, double rounding through 53 digits is harmless (Figueroa).
/// Watching for results half way is worth while if they are rare. They are not rare if few digits
/// are dropped, as in sums of numbers with hardly more digits than the result.
Finish nearest_finish(Operation operation, int operand_digits, int digits) {
  constexpr int twice_rounded_digits = 25, rare_digits = 8;
  if (digits == double_digits) return Finish::hardware;
  if (operation == Operation::multiply || operation == Operation::square) return Finish::fused;
  if (operand_digits <= digits && digits <= twice_rounded_digits) return Finish::nearest;
  const bool is_quotient = operation == Operation::divide || operation == Operation::square_root;
  const int result_digits = is_quotient ? double_digits : operand_digits;
  if (result_digits - digits >= rare_digits) return Finish::watched;
  return operation == Operation::convert ? Finish::nearest : Finish::corrected;
}

Finish finish_of(const TypedNode& node, Rounding rounding) {
  const int operand_digits = node.operand_format.precision(), digits = node.format.precision();
  if (!rounds(node.operation)) return Finish::hardware;
  if (node.operation == Operation::convert && operand_digits <= digits) return Finish::hardware;
  switch (rounding) {
    case Rounding::nearest_even: return nearest_finish(node.operation, operand_digits, digits);
    case Rounding::toward_zero: return Finish::truncated;
  }
  MIXCMP_CHECK(false);
}

void add_instruction(Code& code, const TypedNode& node, int column, Rounding rounding) {
  const int second = arity(node.operation) == 2 ? node.operands[1] : node.operands[0];
  code.values.push_back({.kernel = kernel_of(node.operation),
                         .finish = finish_of(node, rounding),
                         .result = column,
                         .a = node.operands[0],
                         .b = second,
                         .dropped_digits = double_digits - node.format.precision()});
}

/// Adds a column to the range with these limits. There is only one such range, so columns with the
/// same limits are tested together.
void add_range(Code& code, const TrustedRange& range, int column) {
  const auto same = [&](const TrustedRange& other) {
    return other.least == range.least && other.limit == range.limit &&
           other.any_double == range.any_double && other.zero_bits == range.zero_bits;
  };
  auto found = std::find_if(code.ranges.begin(), code.ranges.end(), same);
  if (found == code.ranges.end()) found = code.ranges.insert(found, range);
  if (std::find(found->columns.begin(), found->columns.end(), column) == found->columns.end()) {
    found->columns.push_back(column);
  }
}

/// False for a constant for which double cannot be trusted.
bool add_node(Code& code, const TypedGraph& graph, int column) {
  const TypedNode& node = graph.nodes[column];
  const TrustedRange operands = trusted_operands(node.format, graph.arithmetic.subnormals);
  if (node.operation == Operation::input) {
    code.layout.inputs.emplace_back(column, node.input);
    add_range(code, operands, column);
    return true;
  }
  if (node.operation == Operation::constant) {
    const double value = to_double(node.format, node.constant);
    code.layout.constants.emplace_back(column, value);
    return is_trusted(operands, value);
  }
  add_instruction(code, node, column, graph.arithmetic.rounding);
  if (rounds(node.operation)) add_range(code, trusted(node.format), column);
  return true;
}

/// A fused sum has intermediate digits that double does not hold.
bool fits_double(const TypedGraph& graph) {
  const auto fits = [](const TypedNode& node) {
    return node.operation != Operation::fused_sum && fits_double(node.format) &&
           fits_double(node.operand_format);
  };
  return fits_double(graph.input_format) &&
         std::all_of(graph.nodes.begin(), graph.nodes.end(), fits);
}

/// Whether every input reaches an operation that is exceptional if the input is flushed, infinite
/// or NaN. Negation and absolute value do not count: they flush nothing.
bool inputs_are_judged(const TypedGraph& graph) {
  const int count = static_cast<int>(graph.nodes.size());
  std::vector<bool> judged(graph.nodes.size(), false);
  for (int id = count - 1; id >= 0; --id) {
    const TypedNode& node = graph.nodes[id];
    const bool judges = rounds(node.operation) || arity(node.operation) == 2;
    for (int k = 0; k < arity(node.operation); ++k) {
      if (judges || judged[id]) judged[node.operands[k]] = true;
    }
  }
  for (int id = 0; id < count; ++id) {
    if (graph.nodes[id].operation == Operation::input && !judged[id]) return false;
  }
  return true;
}

bool doubtful_is_exceptional(const TypedGraph& graph) {
  const bool wide = std::any_of(graph.nodes.begin(), graph.nodes.end(),
                                [](const TypedNode& node) { return is_wide(node.format); });
  return graph.arithmetic.subnormals == Subnormals::flush && !wide && inputs_are_judged(graph);
}

std::uint64_t power_bits(int exponent) {
  return std::bit_cast<std::uint64_t>(std::ldexp(1, exponent));
}

/// Adds the widest window of exponents that operands may have. Their number is a power of two; the
/// window contains 1 if it can.
void add_window(Code& code, const TypedGraph& graph) {
  if (code.layout.inputs.empty()) return;  // no operand would limit the search
  const std::optional<SafeOperands> safe = safe_operands(graph);
  if (!safe || safe->high == safe->low) return;
  const int count = static_cast<int>(std::bit_floor(static_cast<unsigned>(safe->high - safe->low)));
  const int low = std::max(safe->low, std::min(-count / 2, safe->high - count));
  const std::uint64_t all_exponents = std::uint64_t{0x7ff} << (double_digits - 1);
  const std::uint64_t inside = power_bits(low + count) - power_bits(low) - 1;
  OperandWindow window = {
      .columns = {},
      .least = power_bits(low),
      .outside = (all_exponents & ~inside) | surplus_digits(graph.input_format)};
  for (const auto& [column, operand] : code.layout.inputs) window.columns.push_back(column);
  code.window = std::move(window);
}

}  // namespace

std::optional<Code> make_code(const TypedGraph& graph, const error::Lane* lane) {
  if (!fits_double(graph)) return std::nullopt;
  Code code{
      .layout = {.columns = static_cast<int>(graph.nodes.size())}, .f = graph.f(), .g = graph.g()};
  for (int id = 0; id < code.layout.columns; ++id) {
    if (!add_node(code, graph, id)) return std::nullopt;
  }
  add_window(code, graph);
  code.criterion = {.kind = CriterionKind::order, .first = graph.f(), .second = graph.g()};
  if (lane == nullptr) return code;
  code.doubtful_is_undecided = lane->certified() && doubtful_is_exceptional(graph);
  for (const NodeId id : values_as_encodings(*lane)) {
    add_range(code, trusted(graph.nodes[id].format), id);
  }
  if (!add_criterion(code, *lane)) return std::nullopt;
  return code;
}

}  // namespace mixcmp::emulator

#include "model/emulator/fixed_code.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "model/common/check.hpp"
#include "model/number/double.hpp"
#include "model/number/verdict.hpp"

namespace mixcmp::emulator {
namespace {

using fixed::FixedLane;
using fixed::FixedNode;
using fixed::FixedPart;

/// Far from the exponents where doubles end, even for reciprocals and squares.
constexpr int largest_exponent = 400;

double power(int exponent) {
  return std::ldexp(1, exponent);
}

/// The digits of a double with which an operation is exact. A root is rounded to nearest before it
/// is rounded down to its unit: with these digits never to the next unit (docs/emulator.md).
int needed_digits(const std::vector<FixedNode>& nodes, const FixedNode& node) {
  if (node.operation == Operation::square_root) {
    return std::max(2 * node.format.width + 1, nodes[node.operands[0]].format.width + 3);
  }
  return node.format.width + node.dropped_bits;
}

bool fits_double(const std::vector<FixedNode>& nodes, const FixedNode& node) {
  const int digits = needed_digits(nodes, node);
  return digits <= double_digits &&
         std::abs(node.format.unit_exponent) + digits <= largest_exponent;
}

/// A slope below 1 would have to round; `norm_thresholds` gives none.
bool fits_double(const FixedPart& part) {
  const auto* norm = std::get_if<fixed::NormThresholds>(&part.criterion);
  return norm == nullptr || (norm->shift_above >= 0 && norm->shift_below >= 0);
}

FixedKernel fixed_kernel_of(Operation operation) {
  switch (operation) {
    case Operation::negate: return FixedKernel::negate;
    case Operation::absolute: return FixedKernel::absolute;
    case Operation::add: return FixedKernel::add;
    case Operation::subtract: return FixedKernel::subtract;
    case Operation::multiply:
    case Operation::square: return FixedKernel::multiply;
    case Operation::minimum: return FixedKernel::minimum;
    case Operation::maximum: return FixedKernel::maximum;
    case Operation::square_root: return FixedKernel::square_root;
    case Operation::input:
    case Operation::constant:
    case Operation::convert:
    case Operation::divide: break;
  }
  MIXCMP_CHECK(false);
}

FixedConversion conversion_of(const FixedFormat& format) {
  const int magnitude_bits = format.width - (format.is_signed ? 1 : 0);
  return {.unit = power(format.unit_exponent),
          .limit = power(format.unit_exponent + magnitude_bits),
          .is_signed = format.is_signed};
}

/// The instruction that computes a node; of one operand a, b and c are the same.
FixedInstruction instruction_of(const FixedNode& node, NodeId result) {
  const NodeId first = node.operands[0], last = node.operands[arity(node.operation) - 1];
  return {.kernel = fixed_kernel_of(node.operation),
          .result = result,
          .a = first,
          .b = last,
          .c = first};
}

/// Compiles a lane. A node that has one reader and drops no bits is computed together with that
/// reader where a kernel does both: the difference with its square, the product or square with a
/// sum.
class FixedCodeMaker {
public:
  explicit FixedCodeMaker(const FixedLane& lane)
      : lane_(lane), reads_(lane.nodes.size(), 0), is_fused_(lane.nodes.size(), false) {
    code_.layout.columns = static_cast<int>(lane.nodes.size());
    if (lane.format.is_block)
      code_.least_block_exponent = fixed::least_block_exponent(lane.input_format);
    count_reads();
    choose_fused();
  }

  FixedCode make() {
    for (NodeId id = 0; id < static_cast<NodeId>(lane_.nodes.size()); ++id) add_node(id);
    for (const FixedPart& part : lane_.parts) add_criterion(part);
    return std::move(code_);
  }

private:
  const FixedNode& node(NodeId id) const { return lane_.nodes[id]; }

  void count_reads() {
    for (const FixedNode& node : lane_.nodes) {
      for (int k = 0; k < arity(node.operation); ++k) ++reads_[node.operands[k]];
    }
    for (const FixedPart& part : lane_.parts) {
      ++reads_[part.difference];
      if (const auto* norm = std::get_if<fixed::NormThresholds>(&part.criterion)) {
        ++reads_[norm->radius];
      }
    }
  }

  bool is_whole_and_read_once(NodeId id) const {
    return reads_[id] == 1 && node(id).dropped_bits == 0;
  }

  bool is_lone_product(NodeId id) const {
    const Operation operation = node(id).operation;
    return (operation == Operation::multiply || operation == Operation::square) &&
           is_whole_and_read_once(id);
  }

  /// A difference that computes a product itself has no kernel that squares it, too.
  bool squares_a_lone_difference(const FixedNode& node) const {
    if (node.operation != Operation::square) return false;
    const FixedNode& squared = this->node(node.operands[0]);
    return squared.operation == Operation::subtract && is_whole_and_read_once(node.operands[0]) &&
           !product_of(squared);
  }

  /// The place of the product that a sum computes itself: of a difference the second; or none.
  std::optional<int> product_of(const FixedNode& sum) const {
    if (sum.operation != Operation::add && sum.operation != Operation::subtract) return {};
    if (is_lone_product(sum.operands[1])) return 1;
    const bool first = sum.operation == Operation::add && is_lone_product(sum.operands[0]);
    return first ? std::optional(0) : std::nullopt;
  }

  void choose_fused() {
    for (const FixedNode& node : lane_.nodes) {
      if (squares_a_lone_difference(node)) is_fused_[node.operands[0]] = true;
      if (const auto place = product_of(node)) is_fused_[node.operands[*place]] = true;
    }
  }

  void add_node(NodeId id) {
    const FixedNode& added = node(id);
    if (added.operation == Operation::input) {
      code_.inputs.push_back({id, added.input, conversion_of(added.format)});
      code_.layout.inputs.emplace_back(id, added.input);
    } else if (added.operation == Operation::constant) {
      const double value = added.constant.get_d() * power(added.format.unit_exponent);
      code_.layout.constants.emplace_back(id, value);
    } else if (!is_fused_[id]) {
      add_instruction(id);
    }
  }

  void add_instruction(NodeId id) {
    const FixedNode& added = node(id);
    if (added.operation == Operation::convert) return add_conversion(id);
    const auto product = product_of(added);
    FixedInstruction instruction = product ? sum_with_product(added, *product)
                                   : squares_a_lone_difference(added) ? square_of_difference(added)
                                                                      : instruction_of(added, id);
    instruction.result = id;
    const bool truncates = added.dropped_bits > 0 || added.operation == Operation::square_root;
    if (truncates) instruction.result = code_.layout.columns++;
    code_.instructions.push_back(instruction);
    if (truncates) add_truncation(id, instruction.result);
  }

  void add_conversion(NodeId id) {
    const FixedNode& added = node(id);
    if (!fixed::is_limit(added)) return add_truncation(id, added.operands[0]);
    FixedInstruction& limit = add_unary(FixedKernel::limit, id, added.operands[0]);
    limit.low = added.value.low.get_d();
    limit.high = added.value.high.get_d();
  }

  void add_truncation(NodeId id, int operand) {
    add_unary(FixedKernel::truncate, id, operand).unit = power(node(id).format.unit_exponent);
  }

  FixedInstruction square_of_difference(const FixedNode& square) const {
    FixedInstruction instruction = instruction_of(node(square.operands[0]), -1);
    instruction.kernel = FixedKernel::square_of_difference;
    return instruction;
  }

  FixedInstruction sum_with_product(const FixedNode& sum, int place) const {
    const FixedNode& product = node(sum.operands[place]);
    const bool squared = squares_a_lone_difference(product), adds = sum.operation == Operation::add;
    FixedInstruction instruction =
        squared ? square_of_difference(product) : instruction_of(product, -1);
    instruction.c = sum.operands[1 - place];
    instruction.kernel = squared ? (adds ? FixedKernel::add_square_of_difference
                                         : FixedKernel::subtract_square_of_difference)
                         : adds  ? FixedKernel::add_product
                                 : FixedKernel::subtract_product;
    return instruction;
  }

  void add_criterion(const FixedPart& part) {
    FixedCriterion criterion{.difference = part.difference, .radius = part.difference};
    const double unit = power(node(part.difference).format.unit_exponent);
    std::visit([&](const auto& thresholds) { set(criterion, thresholds, unit); }, part.criterion);
    if (part.swapped) std::swap(criterion.greater, criterion.less);
    code_.criteria.push_back(criterion);
  }

  void set(FixedCriterion& criterion, const fixed::ConstantThresholds& thresholds, double unit) {
    const mpz_class below = -thresholds.less_to - 1;
    criterion.offset_above = thresholds.greater_from.get_d() * unit;
    criterion.offset_below = below.get_d() * unit;
    if (thresholds.exact) criterion.otherwise = static_cast<std::uint8_t>(Decision::equal);
  }

  void set(FixedCriterion& criterion, const fixed::NormThresholds& thresholds, double unit) {
    const double radius_unit = power(thresholds.unit_exponent(lane_.nodes));
    criterion.radius = thresholds.radius_is_squared ? add_root(thresholds) : thresholds.radius;
    criterion.slope_above = power(thresholds.shift_above) * unit / radius_unit;
    criterion.offset_above = thresholds.offset_above.get_d() * unit;
    criterion.slope_below = power(thresholds.shift_below) * unit / radius_unit;
  }

  int add_root(const fixed::NormThresholds& thresholds) {
    const int column = code_.layout.columns++;
    FixedInstruction& root = add_unary(FixedKernel::power_above_root, column, thresholds.radius);
    root.unit = power(thresholds.unit_exponent(lane_.nodes));
    root.square_unit = power(node(thresholds.radius).format.unit_exponent);
    return column;
  }

  FixedInstruction& add_unary(FixedKernel kernel, int result, int operand) {
    return code_.instructions.emplace_back(FixedInstruction{
        .kernel = kernel, .result = result, .a = operand, .b = operand, .c = operand});
  }

  const FixedLane& lane_;
  std::vector<int> reads_;  ///< [node]: by nodes and decisions
  std::vector<bool> is_fused_;
  FixedCode code_;
};

}  // namespace

std::optional<FixedCode> make_fixed_code(const FixedLane& lane) {
  const bool fits =
      std::all_of(lane.nodes.begin(), lane.nodes.end(),
                  [&](const FixedNode& node) { return fits_double(lane.nodes, node); }) &&
      std::all_of(lane.parts.begin(), lane.parts.end(),
                  [](const FixedPart& part) { return fits_double(part); });
  return fits ? std::optional(FixedCodeMaker(lane).make()) : std::nullopt;
}

}  // namespace mixcmp::emulator

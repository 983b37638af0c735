#include "model/emulator/fixed_emulator.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "model/common/check.hpp"
#include "model/emulator/combine_parts.hpp"
#include "model/golden/fixed_evaluate.hpp"
#include "model/number/double.hpp"

namespace mixcmp::emulator {
namespace {

/// Converted operands of this many comparisons stay in the first-level cache.
constexpr std::size_t convert_at_once = 256;

/// Converts any number of operands; whole vectors where they lie, the rest by way of a copy.
void convert_all(const FixedConversion& conversion, std::span<const double> operands,
                 double* converted) {
  const std::size_t whole = operands.size() / block_granularity * block_granularity;
  const std::size_t rest = operands.size() - whole;
  emulator::convert(conversion, operands.data(), whole, converted);
  if (rest == 0) return;
  std::array<double, block_granularity> last{};
  std::copy_n(operands.data() + whole, rest, last.data());
  emulator::convert(conversion, last.data(), last.size(), last.data());
  std::copy_n(last.data(), rest, converted + whole);
}

/// The decisions on one block, whose last vectors may be filled up.
void decide_block(const FixedCode& code, Combination combination, const Block& block,
                  std::span<Decision> decisions) {
  static_assert(sizeof(Decision) == sizeof(std::uint8_t));
  std::array<Decision, max_block_size> of_part;
  for (std::size_t part = 0; part < code.criteria.size(); ++part) {
    const bool in_place = part == 0 && decisions.size() == block.size;
    Decision* const target = in_place ? decisions.data() : of_part.data();
    decide(code.criteria[part], block, reinterpret_cast<std::uint8_t*>(target));
    if (in_place) continue;
    if (part == 0) {
      std::copy_n(of_part.begin(), decisions.size(), decisions.begin());
    } else {
      combine_parts(combination, decisions, std::span(of_part).first(decisions.size()));
    }
  }
}

}  // namespace

FixedEmulator::FixedEmulator(fixed::FixedLane lane)
    : lane_(std::move(lane)),
      code_(make_fixed_code(lane_)),
      fallbacks_(std::make_unique<std::atomic<std::uint64_t>>(0)) {}

Decision FixedEmulator::golden_decision(OperandColumns operands, std::size_t index) const {
  fallbacks_->fetch_add(1, std::memory_order_relaxed);
  std::vector<Bits> inputs;
  for (const double* column : operands) {
    inputs.push_back(from_double(lane_.input_format, column[index]));
  }
  const golden::LaneResult result = golden::evaluate_lane(lane_, inputs);
  return result.decided ? decision_of(result.verdict) : Decision::undecided;
}

void FixedEmulator::decide(OperandColumns operands, std::size_t count,
                           std::span<Decision> decisions) const {
  MIXCMP_CHECK(operands.size() == lane_.input_names.size() && decisions.size() >= count);
  if (!code_) {
    for (std::size_t k = 0; k < count; ++k) decisions[k] = golden_decision(operands, k);
    return;
  }
  std::vector<double> memory(code_->inputs.size() * convert_at_once);
  std::vector<const double*> converted(operands.begin(), operands.end());
  std::vector<double*> columns;
  for (const FixedCode::Input& input : code_->inputs) {
    columns.push_back(memory.data() + columns.size() * convert_at_once);
    converted[input.operand] = columns.back();
  }
  const auto convert = code_->least_block_exponent ? &FixedEmulator::convert_in_common_unit
                                                   : &FixedEmulator::convert_each;
  for (std::size_t first = 0; first < count; first += convert_at_once) {
    const std::size_t size = std::min(convert_at_once, count - first);
    (this->*convert)(operands, first, size, columns);
    decide_columns(converted, size, decisions.subspan(first, size));
  }
}

/// Converts the operands of `size` comparisons from number `first` on, each by itself.
void FixedEmulator::convert_each(OperandColumns operands, std::size_t first, std::size_t size,
                                 std::span<double* const> columns) const {
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const FixedCode::Input& input = code_->inputs[k];
    convert_all(input.conversion, {operands[input.operand] + first, size}, columns[k]);
  }
}

/// Likewise, the operands of each comparison in the unit that the largest of them sets.
void FixedEmulator::convert_in_common_unit(OperandColumns operands, std::size_t first,
                                           std::size_t size,
                                           std::span<double* const> columns) const {
  const std::size_t filled = (size + block_granularity - 1) / block_granularity * block_granularity;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const double* const operand = operands[code_->inputs[k].operand] + first;
    std::fill(std::copy_n(operand, size, columns[k]), columns[k] + filled, 0.0);
  }
  divide_by_common_power(columns, filled, *code_->least_block_exponent);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    emulator::convert(code_->inputs[k].conversion, columns[k], filled, columns[k]);
  }
}

void FixedEmulator::convert(int input, std::span<const double> operands,
                            std::span<double> converted) const {
  MIXCMP_CHECK(can_convert_beforehand() && converted.size() >= operands.size());
  const auto reads = [&](const FixedCode::Input& each) { return each.operand == input; };
  const auto found = std::find_if(code_->inputs.begin(), code_->inputs.end(), reads);
  if (found == code_->inputs.end()) {
    std::copy(operands.begin(), operands.end(), converted.begin());
  } else {
    convert_all(found->conversion, operands, converted.data());
  }
}

void FixedEmulator::decide_converted(OperandColumns converted, std::size_t count,
                                     std::span<Decision> decisions) const {
  MIXCMP_CHECK(can_convert_beforehand() && decisions.size() >= count);
  decide_columns(converted, count, decisions);
}

void FixedEmulator::decide_columns(OperandColumns converted, std::size_t count,
                                   std::span<Decision> decisions) const {
  ColumnBlocks blocks(code_->layout, converted, count);
  while (blocks.next()) {
    execute(code_->instructions, blocks.block());
    decide_block(*code_, lane_.combination, blocks.block(),
                 decisions.subspan(blocks.first(), blocks.size()));
  }
}

}  // namespace mixcmp::emulator

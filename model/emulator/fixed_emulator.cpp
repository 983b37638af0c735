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

/// Converts any number of operands: whole vectors in place, the rest through a copy.
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

/// In block floating point, first divides the operands by a power of two, in their new columns.
void convert_block(const FixedCode& code, const Block& block) {
  const bool in_common_unit = code.least_block_exponent.has_value();
  if (in_common_unit) divide_by_common_power(code.inputs, block, *code.least_block_exponent);
  for (const FixedInput& input : code.inputs) {
    const int from = in_common_unit ? input.converted : input.arriving;
    convert(input.conversion, block.columns[from], block.size, block.results[input.converted]);
  }
}

/// The decisions on one block. Its operands are converted, and its last vectors may be padded.
void decide_block(const FixedCode& code, Combination combination, const Block& block,
                  std::span<Decision> decisions) {
  static_assert(sizeof(Decision) == sizeof(std::uint8_t));
  execute(code.instructions, block);
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
  ColumnBlocks blocks(code_->arriving, operands, count);
  while (blocks.next()) {
    convert_block(*code_, blocks.block());
    decide_block(*code_, lane_.combination, blocks.block(),
                 decisions.subspan(blocks.first(), blocks.size()));
  }
}

void FixedEmulator::convert(int input, std::span<const double> operands,
                            std::span<double> converted) const {
  MIXCMP_CHECK(can_convert_beforehand() && converted.size() >= operands.size());
  const auto reads = [&](const FixedInput& each) { return each.operand == input; };
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
  ColumnBlocks blocks(code_->converted, converted, count);
  while (blocks.next()) {
    decide_block(*code_, lane_.combination, blocks.block(),
                 decisions.subspan(blocks.first(), blocks.size()));
  }
}

}  // namespace mixcmp::emulator

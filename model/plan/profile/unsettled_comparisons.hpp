#pragma once

#include <cstdint>
#include <vector>

#include "model/comparison/data/operand_source.hpp"
#include "model/judge/emulator/emulator.hpp"

namespace mixcmp::profile {

/// Comparisons on which some scheme is not settled, with the data for counting. A scheme is settled
/// on a comparison once it is known to decide it rightly at every further precision.
class UnsettledComparisons {
public:
  UnsettledComparisons(std::size_t inputs, std::size_t capacity);

  std::size_t size() const { return operands_.size(); }
  std::size_t capacity() const { return operands_.capacity(); }
  const data::OperandBlock& operands() const { return operands_; }
  data::OperandBlock& operands() { return operands_; }

  /// The order of the real numbers f and g; `undecided` if it is undetermined.
  std::vector<Decision> truth;
  std::vector<Decision> reference;  ///< verdicts of the reference datapath
  /// Bit k is set while scheme k is not settled.
  std::vector<std::uint32_t> schemes;

  /// Bit k is set if an operand fails a range check that scheme k makes at some precision.
  std::vector<std::uint32_t> failing;

  void append(const UnsettledComparisons& from, std::size_t row, std::uint32_t schemes_left);

private:
  data::OperandBlock operands_;
};

}  // namespace mixcmp::profile

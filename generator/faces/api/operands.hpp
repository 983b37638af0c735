#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/base/common/result.hpp"
#include "model/base/number/float_format.hpp"
#include "model/base/number/operand_format.hpp"

/// Operands of comparisons as the user gives them: rows of doubles.
namespace mixcmp::api {

/// A number of a format, as its encoding and as a double.
struct Operand {
  Bits bits;
  double value;
};

/// The number of the format that is nearest to `value`, ties to even; none if `value` is finite and
/// beyond the largest number, or an infinity that the format lacks.
std::optional<Operand> nearest_operand(FloatFormat format, double value);

/// Rows of operands, all of them numbers of one format.
class OperandRows {
public:
  /// It is an error if the numbers fill no whole row, if one is out of the format's range, or if
  /// one is no number of its input in fixed point. `formats`: one per input.
  static Result<OperandRows> make(std::span<const double> numbers,
                                  const std::vector<std::string>& inputs, FloatFormat format,
                                  std::span<const OperandFormat> formats);

  std::size_t rows() const { return values_.size() / inputs_; }
  double value(std::size_t row, std::size_t input) const { return values_[row * inputs_ + input]; }
  /// Writes the encodings of one row.
  void fetch(std::size_t row, std::span<Bits> operands) const;

private:
  OperandRows(std::size_t inputs, FloatFormat format) : inputs_(inputs), format_(format) {}

  std::size_t inputs_;
  FloatFormat format_;
  std::vector<double> values_;
};

}  // namespace mixcmp::api

#pragma once

namespace mixcmp::datapath {

/// The steps of rtl_templates/fp/fp_square_steps.v and the lengths of their carry chains.
class SerialSquare {
public:
  static constexpr int step_bits = 6;  ///< bits of the operand in a step

  explicit SerialSquare(int precision) : precision_(precision) {}

  /// The steps of a square, which is also the number of cycles from one square to the next.
  int cycles() const { return (precision_ + step_bits - 1) / step_bits; }
  /// Tells whether the templates take an operand of this precision and round to that of the result.
  bool fits(int result_precision) const {
    constexpr int fewest_bits = 13, fewest_places_beyond = 3;
    return precision_ >= fewest_bits && result_precision <= precision_ + fewest_places_beyond;
  }

  int row_bits() const { return precision_ + 5; }
  int sum_bits() const { return precision_ + 9; }

private:
  int precision_;
};

}  // namespace mixcmp::datapath

#pragma once

#include <algorithm>

#include "model/base/common/check.hpp"

namespace mixcmp::datapath {

/// Lengths of the carry chains in rtl_templates/fp/fp_logic_product.v, whose rows and levels this
/// class repeats.
class LogicProduct {
public:
  static constexpr int levels = 7;
  /// The widest factors whose sums leave the last level unused. The stage of the digits replaces
  /// that level.
  static constexpr int most_bits_behind_digits = 63;
  /// The widest squares that leave the last level unused. At the cut of that level, the other bits
  /// wait for the late ones.
  static constexpr int most_bits_of_a_split_square = 65;

  enum class Kind { product, square };

  enum class Form {
    plain,
    behind_digits,  ///< DIGIT_STAGE
    split,          ///< SPLIT, of squares
  };

  LogicProduct(int precision, Kind kind, Form form = Form::plain)
      : precision_(precision), kind_(kind), form_(form) {
    MIXCMP_CHECK(form != Form::behind_digits || precision <= most_bits_behind_digits);
    MIXCMP_CHECK(form != Form::split ||
                 (kind == Kind::square && precision <= most_bits_of_a_split_square));
  }

  Form form() const { return form_; }

  /// Bits of the carry chain that finds the digits; 0 if gates decode them.
  int digits_chain_bits() const { return kind_ == Kind::square ? 0 : 2 * rows(); }

  /// Bits of carry chains; 0 if nothing is added.
  struct Chains {
    int early = 0;
    int late = 0;  ///< for the bits that are a cycle late
  };
  /// The longest chains of a level.
  Chains longest_chains(int level) const {
    Chains longest;
    for (int first = 0; first + rows_below(level) < rows(); first += pitch(level)) {
      const int last = std::min(first + rows_after(level), rows()) - 1;
      const Chains chains = chains_of(sum_bits(first + rows_below(level), last),
                                      first_late_bit() - 2 * (first + rows_below(level)));
      longest.early = std::max(longest.early, chains.early);
      longest.late = std::max(longest.late, chains.late);
    }
    return longest;
  }

  /// The low bits of a sum that are final at once, since its upper addend begins above them.
  static int shift_bits(int level) { return 2 * rows_below(level); }

private:
  static int pitch(int level) { return level < 3 ? 4 : 1 << level; }
  static int rows_below(int level) { return level < 3 ? level + 1 : pitch(level) / 2; }
  static int rows_after(int level) { return level < 3 ? level + 2 : pitch(level); }

  int rows() const { return kind_ == Kind::square ? precision_ / 2 : precision_ / 2 + 1; }
  int sum_bits(int first, int last) const {
    return kind_ == Kind::square ? 4 * last - 2 * first + precision_ % 2 + 4
                                 : 2 * (last - first) + precision_ + 6;
  }
  int first_late_bit() const { return 3 * sum_bits(0, rows() - 1) / 4; }
  /// The chains of a sum of `bits`. Bits from `late` up may be late. The early chain has one bit
  /// more, its carry.
  Chains chains_of(int bits, int late) const {
    if (form_ != Form::split || late >= bits) return {bits, 0};
    return {late + 1, bits - late};
  }

  int precision_;
  Kind kind_;
  Form form_;
};

}  // namespace mixcmp::datapath

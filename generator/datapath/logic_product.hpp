#pragma once

#include <algorithm>

namespace mixcmp::datapath {

/// Lengths of the carry chains in rtl_templates/fp/fp_logic_product.v, whose rows and levels this
/// class repeats.
class LogicProduct {
public:
  static constexpr int levels = 7;
  /// The widest factors whose sums leave a level unused, which the stage of the digits replaces.
  static constexpr int most_bits_behind_digits = 63;

  enum class Kind { product, square };

  LogicProduct(int precision, Kind kind) : precision_(precision), kind_(kind) {}

  /// Bits of the carry chain that finds the digits; 0 where they are decoded by gates.
  int digits_chain_bits() const { return kind_ == Kind::square ? 0 : 2 * rows(); }

  /// Bits of the longest carry chain of a level; 0 where nothing is added.
  int longest_chain_bits(int level) const {
    int longest = 0;
    for (int first = 0; first + rows_below(level) < rows(); first += pitch(level)) {
      const int last = std::min(first + rows_after(level), rows()) - 1;
      longest = std::max(longest, sum_bits(first + rows_below(level), last));
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

  int precision_;
  Kind kind_;
};

}  // namespace mixcmp::datapath

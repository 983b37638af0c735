#pragma once

#include <bit>
#include <cstddef>

#include "generator/hardware/datapath/squared_sum.hpp"
#include "generator/hardware/datapath/units.hpp"
#include "model/comparison/expression/typed_graph.hpp"

namespace mixcmp::datapath {

/// The sizes in rtl_templates/fp/fp_fused_sum.v and fp_cut_sum.v. This class repeats them.
class FusedSum {
public:
  /// The levels of the tree that finds the largest exponent, and of the tree that adds.
  static constexpr int levels = 6;

  FusedSum(FloatFormat format, std::size_t terms)
      : format_(format), terms_(static_cast<int>(terms)) {}

  /// Tells whether a level of a tree over this many branches has anything to do.
  static bool is_used(int level, int branches) { return (1 << level) < branches; }

  /// The places that a sum of all terms may need in front of those of the largest term.
  int growth_bits() const { return length_of(terms_ - 1); }
  int window_bits() const { return format_.precision() + guard_bits() + 2; }
  int sum_bits() const { return window_bits() + growth_bits(); }
  int exponent_bits() const {
    return length_of(4 * format_.bias() + 2 + 2 * (format_.precision() + (window_bits() + 1) / 2));
  }
  /// The low bits of the distance by which a product moves into the window. They are left to the
  /// second step.
  static constexpr int low_amount_bits = 3;
  int amount_bits() const {
    const int margin = 1 << length_of(window_bits() - 1);
    return length_of(margin + 2 * format_.precision() - 1);
  }
  /// Tells whether a term that is the square of a subnormal number is cut off in any case.
  bool squares_vanish() const { return format_.bias() > format_.precision() + guard_bits(); }

private:
  static int length_of(int value) { return std::bit_width(static_cast<unsigned>(value)); }
  int guard_bits() const { return fused_guard_digits(static_cast<std::size_t>(terms_)); }

  FloatFormat format_;
  int terms_;
};

/// The unit of a fused sum that is rounded. `squared`: whether sums that are only squared are part
/// of it.
Unit fused_sum_unit(const TypedGraph& graph, const TypedNode& node, SquaredSums squared,
                    scene::Multipliers multipliers, const DelayTable& delays);
/// The unit that compares a fused sum with zero.
Unit fused_comparison_unit(const TypedGraph& graph, const TypedNode& node, SquaredSums squared,
                           scene::Multipliers multipliers, const DelayTable& delays);

}  // namespace mixcmp::datapath

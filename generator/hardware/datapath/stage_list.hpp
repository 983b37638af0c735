#pragma once

#include <algorithm>
#include <bit>
#include <string>
#include <utility>
#include <vector>

#include "generator/hardware/datapath/embedded_square.hpp"
#include "generator/hardware/datapath/logic_product.hpp"
#include "generator/hardware/datapath/serial_square.hpp"
#include "generator/hardware/datapath/units.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::datapath {

inline int bits_for(int value) {
  return std::bit_width(static_cast<unsigned>(value));
}

/// Depth of a tree of six-input LUTs that reduces `bits` bits to one.
inline int reduction_levels(int bits) {
  int levels = 0;
  for (int left = bits; left > 1; left = (left + 5) / 6) ++levels;
  return levels;
}

/// Depth in LUTs of a shifter whose amount has `amount_bits` bits: a LUT is a multiplexer of four.
inline int shift_levels(int amount_bits) {
  return (amount_bits + 1) / 2;
}

/// Depth in LUTs of a leading-zero counter of `bits` bits. It is a binary tree, and three of its
/// levels are two LUTs deep.
inline int count_levels(int bits) {
  return (2 * bits_for(bits) + 2) / 3;
}

/// Sets SUM_SELECTS, for templates that have it.
inline Unit with_sum_selects(Unit unit, const DelayTable& delays) {
  unit.sum_selects = delays.sum_selects;
  return unit;
}

/// Collects the stages of one unit in order, with their delays by a device's delay table.
class StageList {
public:
  /// Whether the unit's template has a cut in the middle of its wide sums.
  enum class WideSums { whole, halved };
  explicit StageList(const DelayTable& delays, WideSums wide_sums = WideSums::halved)
      : delays_(delays), wide_sums_(wide_sums) {}

  /// Tells whether a look-up table has more than four inputs.
  bool has_wide_tables() const { return delays_.has_wide_tables(); }
  /// Tells whether two bits may select an addend of a carry chain at no cost.
  bool selects_in_sums() const { return delays_.sum_selects >= 2; }
  double lut_delay_ns(int levels) const { return levels * delays_.lut_ns; }
  double carry(int bits) const { return delays_.carry_start_ns + bits * delays_.carry_ns_per_bit; }
  void add(std::string name, double delay_ns) { stages_.push_back({std::move(name), delay_ns}); }

  /// A stage that ends in a register whatever the period is.
  void add_registered(std::string name, double delay_ns) {
    stages_.push_back({.name = std::move(name), .delay_ns = delay_ns, .registered = true});
  }

  /// A stage that begins `overlap_ns` before the end of the stage before it.
  void add_overlapping(std::string name, double delay_ns, double overlap_ns) {
    stages_.push_back({.name = std::move(name), .delay_ns = delay_ns, .overlap_ns = overlap_ns});
  }

  /// A sum whose operands are there `operands_ns` after the start; two stages if it is halved.
  /// `overlap_ns` is as in add_overlapping.
  void add_wide_sum(const std::string& name, double operands_ns, int bits, double overlap_ns = 0);

  /// Adds stages that are cut at the same places as each of `lists`, which work side by side.
  void add_side_by_side(const std::vector<StageList>& lists);

  /// Adds the delay of other logic in front of the first stage's own.
  void begin_with(double delay_ns) { stages_.front().delay_ns += delay_ns; }

  int count() const { return static_cast<int>(stages_.size()); }

  /// How fp_aligned_operands finds the larger operand.
  enum class Order { by_magnitude, by_exponent };
  void add_aligned_operands(FloatFormat operands, int aligned, Subnormals subnormals, Order order);
  void add_operand(FloatFormat operands, Subnormals subnormals);
  /// The delay from a product's factors to the multipliers' input registers.
  double factors_ns(scene::Multipliers multipliers) const {
    return multipliers == scene::Multipliers::embedded ? delays_.multiplier_input_ns : 0;
  }
  void add_logic_product(LogicProduct product);
  void add_product(int precision, LogicProduct::Kind kind, scene::Multipliers multipliers,
                   LogicProduct::Form form);
  void add_product_behind_factors(int precision, LogicProduct::Kind kind,
                                  scene::Multipliers multipliers,
                                  LogicProduct::Form form = LogicProduct::Form::plain);
  void add_serial_square(SerialSquare square);
  void add_round(FloatFormat result, bool denormalises, int dropped_bits, double select_ns = 0);
  void add_select_round(FloatFormat result, Subnormals subnormals, double sticky_ns);
  void add_last_selection(FloatFormat result);

  Unit unit(std::string module) && {
    return {.module = std::move(module), .stages = std::move(stages_)};
  }

private:
  void add_upper_half(std::string name, int bits);
  void add_embedded_product(int precision);
  void add_embedded_square(int precision);
  void add_levels(LogicProduct product, int levels);
  void add_round_and_pack(FloatFormat result);
  /// The delay of the decision to round up, at the end of the stage before "round".
  double deciding_ns() const { return lut_delay_ns(1); }

  const DelayTable& delays_;
  WideSums wide_sums_;
  std::vector<Stage> stages_;
};

inline void StageList::add_wide_sum(const std::string& name, double operands_ns, int bits,
                                    double overlap_ns) {
  const int lower_bits = wide_sums_ == WideSums::halved ? bits / 2 : bits;
  add_overlapping(name, operands_ns + carry(lower_bits), overlap_ns);
  if (wide_sums_ == WideSums::whole) return;
  add_upper_half(name + ", upper half", bits - lower_bits);
}

/// The upper half of the sum that the stage before begins. Without a register between them the
/// halves are one carry chain, which starts once.
inline void StageList::add_upper_half(std::string name, int bits) {
  stages_.push_back({.name = std::move(name),
                     .delay_ns = carry(bits),
                     .overlap_ns = delays_.carry_start_ns,
                     .is_upper_half = true});
}

inline void StageList::add_side_by_side(const std::vector<StageList>& lists) {
  const int first = count();
  for (std::size_t k = 0; k < lists.front().stages_.size(); ++k) {
    Stage joint = {.name = lists.front().stages_[k].name, .delay_ns = 0, .forks = k == 0};
    for (const StageList& list : lists) {
      const Stage& stage = list.stages_[k];
      joint.delay_ns = std::max(joint.delay_ns, stage.delay_ns);
      joint.chains.push_back({.delay_ns = stage.delay_ns, .overlap_ns = stage.overlap_ns});
      if (stage.cut_needs >= 0) joint.cut_needs = first + stage.cut_needs;
      joint.registered = joint.registered || stage.registered;
      joint.is_upper_half = joint.is_upper_half || stage.is_upper_half;
    }
    stages_.push_back(std::move(joint));
  }
}

/// The stages of fp_aligned_operands, whose smaller operand has `aligned` places.
inline void StageList::add_aligned_operands(FloatFormat operands, int aligned,
                                            Subnormals subnormals, Order order) {
  const bool gradual = subnormals == Subnormals::gradual;
  // Whether a number is subnormal is known before the borrow of the exponents' difference.
  const double exponents = lut_delay_ns(gradual ? reduction_levels(operands.exponent_bits()) : 0) +
                           carry(operands.exponent_bits());
  const bool by_magnitude = order == Order::by_magnitude;
  add("compare", by_magnitude ? std::max(carry(operands.width() - 1), exponents) : exponents);
  add("swap", lut_delay_ns(1));
  add("align by fours", lut_delay_ns(1 + shift_levels(bits_for(aligned) - 2) + 1));
  // With tables of five inputs or more, the sticky bit takes no table behind the shift's.
  add("align", lut_delay_ns(shift_levels(2) + (has_wide_tables() ? 0 : 1)));
}

/// The stages of fp_operand; they are only wires if subnormals are flushed.
inline void StageList::add_operand(FloatFormat operands, Subnormals subnormals) {
  const bool normalises = subnormals == Subnormals::gradual;
  const int precision = operands.precision();
  const int unpack = reduction_levels(operands.exponent_bits());
  add("count", normalises ? lut_delay_ns(unpack + count_levels(precision)) : 0);
  add("normalise", normalises ? lut_delay_ns(shift_levels(bits_for(precision))) : 0);
}

/// The stages of fp_embedded_product behind its factors. A cut between two rows delays the operands
/// of the rows above it. Without a register behind the multipliers, those rows would then multiply
/// and add in one cycle, so a cut between rows needs the cut behind "multiply". Rows above the
/// fourth and columns after the third have no cut of their own; their delays are part of the two
/// last stages.
inline void StageList::add_embedded_product(int precision) {
  constexpr int cut_rows = 4;
  const auto [a_bits, b_bits] = delays_.multiplier_size;
  const int columns = (precision + a_bits - 1) / a_bits;
  const int rows = (precision + b_bits - 1) / b_bits;
  const double sum = carry(std::min(a_bits, precision) + precision);
  const int multiply = static_cast<int>(stages_.size());
  add("multiply", delays_.multiplier_ns);
  for (int row = 0; row < cut_rows; ++row) {
    const double adding = row < rows ? delays_.multiplier_add_ns : 0;
    add("row " + std::to_string(row), row == 0 ? delays_.multiplier_output_ns : adding);
    if (row + 1 < rows) stages_.back().cut_needs = multiply;
  }
  add("first sum",
      std::max(0, rows - cut_rows) * delays_.multiplier_add_ns + (columns > 1 ? sum : 0));
  add("other sums", std::max(0, columns - 2) * sum);
}

/// The stages of fp_embedded_square behind its factors, for a square that fp_product gives to it.
/// The squares of the parts are multiplied behind the cuts of the first three links. A later link's
/// product is multiplied behind the cuts of the links before it. Without a register behind the
/// multipliers they would then multiply and add in one cycle, so a cut of a link needs the cut
/// behind "multiply".
inline void StageList::add_embedded_square(int precision) {
  constexpr int cut_links = EmbeddedSquare::cut_links;
  const EmbeddedSquare square(precision, delays_.multiplier_size);
  if (!square.is_smaller()) return add_embedded_product(precision);
  const int links = square.links();
  const int multiply = static_cast<int>(stages_.size());
  add("multiply", delays_.multiplier_ns);
  for (int link = 0; link < cut_links; ++link) {
    const bool last = link + 1 == cut_links;
    const bool adds = link < links || (last && square.has_excess());
    const double adding = adds ? delays_.multiplier_add_ns : 0;
    add("link " + std::to_string(link), link == 0 ? delays_.multiplier_output_ns : adding);
    if (!last || links > cut_links) stages_.back().cut_needs = multiply;
  }
  add("lower half",
      std::max(0, links - cut_links) * delays_.multiplier_add_ns + carry(square.lower_half_bits()));
  add_upper_half("upper half", square.upper_half_bits());
}

/// The stages of fp_logic_product.
inline void StageList::add_logic_product(LogicProduct product) {
  const int digits_bits = product.digits_chain_bits();
  switch (product.form()) {
    case LogicProduct::Form::plain: return add_levels(product, LogicProduct::levels);
    case LogicProduct::Form::behind_digits:
      add("digits", digits_bits > 0 ? carry(digits_bits) : lut_delay_ns(1));
      return add_levels(product, LogicProduct::levels - 1);
    case LogicProduct::Form::split:
      // At the last cut, the other bits wait for the late ones, which have no register there.
      // Without a register at the cut before it, the chain of the late bits would go on into the
      // next stage.
      add_levels(product, LogicProduct::levels - 1);
      stages_.back().registered = true;
      return add_registered("level 6", 0);
  }
  MIXCMP_CHECK(false);
}

/// The first levels of sums. The first row is one level of gates in front of the first carry chain.
/// Without a register between them, a chain starts as soon as the chain before it has reached the
/// place of its lowest bit.
inline void StageList::add_levels(LogicProduct product, int levels) {
  LogicProduct::Chains before;
  int shift_before = 0;
  for (int level = 0; level < levels; ++level) {
    const LogicProduct::Chains bits = product.longest_chains(level);
    const int shift = LogicProduct::shift_bits(level);
    const double first_row = level == 0 ? lut_delay_ns(1) : 0;
    const int longest = std::max(bits.early, bits.late);
    // The bits by which a chain outlasts the one before. All late chains begin at the same bit.
    const int early_rest =
        bits.early - std::clamp(before.early - (shift - shift_before), 0, bits.early);
    const int late_rest = bits.late - std::min(before.late, bits.late);
    const int overlap = longest - std::max(early_rest, late_rest);
    stages_.push_back({.name = "level " + std::to_string(level),
                       .delay_ns = first_row + (longest > 0 ? carry(longest) : 0),
                       .overlap_ns = overlap * delays_.carry_ns_per_bit});
    before = bits;
    shift_before = shift;
  }
}

/// The stages of fp_product.
inline void StageList::add_product(int precision, LogicProduct::Kind kind,
                                   scene::Multipliers multipliers, LogicProduct::Form form) {
  add("factors", factors_ns(multipliers));
  add_product_behind_factors(precision, kind, multipliers, form);
}

inline void StageList::add_product_behind_factors(int precision, LogicProduct::Kind kind,
                                                  scene::Multipliers multipliers,
                                                  LogicProduct::Form form) {
  switch (multipliers) {
    case scene::Multipliers::embedded:
      return kind == LogicProduct::Kind::square ? add_embedded_square(precision)
                                                : add_embedded_product(precision);
    case scene::Multipliers::logic: return add_logic_product({precision, kind, form});
    case scene::Multipliers::memory: break;  // only lanes in fixed point read memories
  }
  MIXCMP_CHECK(false);
}

/// The stages of fp_square_steps: those in front of the sum, then one for each step.
inline void StageList::add_serial_square(SerialSquare square) {
  add_registered("digits", lut_delay_ns(3) + carry(SerialSquare::step_bits + 1));
  add_registered("two rows", lut_delay_ns(1) + carry(square.row_bits()));
  add_registered("three rows", carry(square.row_bits()));
  for (int step = 0; step < square.cycles(); ++step) {
    add_registered("step " + std::to_string(step), lut_delay_ns(1) + carry(square.sum_bits()));
  }
}

/// The stages of fp_round. The last `dropped_bits` bits of a fraction that arrives too wide are
/// ORed into the sticky bit. The selection of the places that are kept takes `select_ns`.
inline void StageList::add_round(FloatFormat result, bool denormalises, int dropped_bits,
                                 double select_ns) {
  const int amount_bits = bits_for(result.precision() + 2);
  const double distance = carry(result.exponent_bits() + 2) + lut_delay_ns(1);
  const double sticky = lut_delay_ns(reduction_levels(std::max(dropped_bits, 1)));
  const double moved =
      denormalises ? std::max(distance, sticky) + lut_delay_ns(shift_levels(amount_bits)) : sticky;
  add("denormalise", moved + select_ns + deciding_ns());
  add_round_and_pack(result);
}

/// The stages of fp_select_round. Whether digits are lost below those that are kept is known
/// `sticky_ns` after the start.
inline void StageList::add_select_round(FloatFormat result, Subnormals subnormals,
                                        double sticky_ns) {
  const bool moves = subnormals == Subnormals::gradual;
  const int amount_bits = bits_for(result.precision() + 3);
  const double moving = moves ? lut_delay_ns(shift_levels(amount_bits - 2) + 1) : 0;
  add("denormalise", std::max(sticky_ns, moving));
  add("select", lut_delay_ns(moves ? 2 : 1) + deciding_ns());
  add_round_and_pack(result);
}

/// The stages of fp_squared_sum from "select" on: the last step of the shift, then the selection by
/// the place of the leading one.
inline void StageList::add_last_selection(FloatFormat result) {
  add("select square", lut_delay_ns(2) + deciding_ns());
  add_round_and_pack(result);
}

inline void StageList::add_round_and_pack(FloatFormat result) {
  add_wide_sum("round", 0, result.width() + 2);
  add("pack", lut_delay_ns(1 + reduction_levels(result.exponent_bits()) + 1));
}

/// Builds the unit of a product in the form that suits the device: tables of five inputs or more
/// decode a digit and add its row at once, smaller tables take a stage for the digits. If a square
/// can be split, the split form is its faster form. `make` builds the unit in a given
/// LogicProduct::Form.
template <typename Make>
Unit unit_of_product(LogicProduct::Kind kind, int precision, scene::Multipliers multipliers,
                     const DelayTable& delays, Make make) {
  using Form = LogicProduct::Form;
  if (multipliers != scene::Multipliers::logic) return make(Form::plain);
  if (!delays.has_wide_tables() && precision <= LogicProduct::most_bits_behind_digits) {
    return make(Form::behind_digits);
  }
  Unit unit = make(Form::plain);
  if (kind == LogicProduct::Kind::square &&
      precision <= LogicProduct::most_bits_of_a_split_square) {
    unit.faster_form.push_back(make(Form::split));
  }
  return unit;
}

}  // namespace mixcmp::datapath

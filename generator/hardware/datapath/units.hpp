#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/hardware/datapath/logic_product.hpp"
#include "model/comparison/expression/typed_graph.hpp"
#include "model/cost/devices/device.hpp"
#include "model/lane/error/lane.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::datapath {

using devices::DelayTable;

/// One of several chains of logic that work side by side in a stage; times as in Stage.
struct ChainDelay {
  double delay_ns;
  double overlap_ns = 0;
};

/// The logic between two cut points of a unit.
struct Stage {
  std::string name;  ///< as in the comment of the template
  double delay_ns;
  /// The part of delay_ns that passes while the stage before is still at work, if no register is
  /// between the two: one carry chain runs along another. It is at most the delay of the stage
  /// before.
  double overlap_ns = 0;
  /// Index of an earlier stage that must end in a cut if this one does; -1: no such stage.
  int cut_needs = -1;
  /// The stage ends in a register whatever the period is, like a stage that reads a block memory.
  bool registered = false;
  /// The upper half of the sum that the stage before begins. A register between the two halves its
  /// carry chain.
  bool is_upper_half = false;
  /// Chains of logic that work side by side; delay_ns is that of the longest. Empty: one chain, of
  /// delay_ns and overlap_ns.
  std::vector<ChainDelay> chains = {};
  /// These chains begin together, when all of the stage before has ended.
  bool forks = false;
};

/// The templates' default of SUM_SELECTS.
constexpr int default_sum_selects = 2;

/// A template and its stages; bit k of its CUTS parameter registers the end of stage k.
struct Unit {
  std::string module;
  std::vector<Stage> stages;
  scene::Multipliers multipliers = scene::Multipliers::embedded;  ///< logic: print EMBEDDED = 0
  devices::MultiplierSize multiplier;  ///< embedded multipliers only: FACTOR_A, FACTOR_B
  LogicProduct::Form product_form = LogicProduct::Form::plain;
  int sum_selects = default_sum_selects;  ///< SUM_SELECTS; the default for units without it
  /// Cycles for which an operation keeps the unit; above 1 it has an input `start`, which is 1 when
  /// its operand is there.
  int initiation_interval = 1;
  /// A unit for the same operation with shorter stages and more registers. It serves clock periods
  /// below the delay of this unit's stages. At most one; a vector, since Unit is incomplete here.
  std::vector<Unit> faster_form = {};
};

/// A multiplication of the node `operand` by 2^exponent or, if `negated`, by -2^exponent.
struct Scaling {
  NodeId operand;
  int exponent;
  bool negated;
};
/// Recognises a multiplication by a constant power of two of either sign, else nullopt. The
/// constant must be one that multipliers do not flush. The node then takes no multiplier. Its unit
/// is a conversion that adds to the exponent, behind a change of the operand's sign if `negated`.
std::optional<Scaling> scaling_of(const TypedGraph& graph, const TypedNode& node);

/// Tells whether a unit computes the node. There is none for wires, nor for the sign of a sum,
/// which the comparison of the sum with zero finds.
bool has_unit(const TypedNode& node);

/// The unit that computes `node` of `graph`, for which has_unit(node) holds.
Unit unit_for(const TypedGraph& graph, const TypedNode& node, const error::Hazards& hazards,
              scene::Multipliers multipliers, const DelayTable& delays);
/// The unit that computes `node` if nothing is known of its operands except the hazards that are
/// ruled out. A multiplication by a power of two then takes a multiplier. Not for fused sums.
Unit unit_for(const TypedNode& node, Subnormals subnormals, const error::Hazards& hazards,
              scene::Multipliers multipliers, const DelayTable& delays);
/// The unit of logic that takes several cycles for a square, if there is one. There is none for
/// operands of few bits, nor for devices with look-up tables of five inputs or more, where rows
/// cost nothing beside the sums that they are added to.
std::optional<Unit> serial_square_unit(const TypedNode& square, Subnormals subnormals,
                                       const DelayTable& delays);
/// Estimates of the four-input look-up tables of fp_square in logic, and of fp_serial_square. Both
/// agree with Yosys 0.23 for the iCE40 within one part in ten, for 13 to 53 bits.
double logic_square_tables(FloatFormat operands);
double serial_square_tables(FloatFormat operands);
/// fp_convert of an operand (OperandFormat::scaled_float) into a format that holds all its numbers,
/// subnormal ones included; in front of it the absolute value of a signed number in fixed point.
/// Its rounding is left out by synthesis, so it takes no time.
Unit widening_unit(const OperandFormat& from, FloatFormat to, const DelayTable& delays);
Unit compare_unit(FloatFormat format, const DelayTable& delays);
Unit ulp_distance_unit(FloatFormat format, const DelayTable& delays);
Unit interval_decision_unit(FloatFormat format, const DelayTable& delays);
/// The unit that combines the verdicts of several parts.
Unit combination_unit(std::size_t parts, const DelayTable& delays);

/// The unit of a node of a lane's error bound. The node must not be a constant, which is a literal.
/// `value` is the format of the number whose magnitude, binade or reciprocal the unit computes.
Unit bound_unit(error::BoundOperation operation, FloatFormat value, BoundFormat bound,
                const DelayTable& delays);
Unit bound_at_most_unit(BoundFormat bound, const DelayTable& delays);
Unit bound_decision_unit(FloatFormat lane, BoundFormat bound, const DelayTable& delays);
/// The unit of a range check. A check of only the sign has none, since it is a wire.
Unit range_check_unit(const error::RangeCheck& check, const DelayTable& delays);

}  // namespace mixcmp::datapath

#pragma once

#include <string>
#include <vector>

#include "model/error/lane.hpp"
#include "model/expression/typed_graph.hpp"

namespace mixcmp::gen {

/// Rough delays of one device family, in nanoseconds, routing included. They only steer where
/// registers go; an estimate made from them is never called a clock.
struct DelayTable {
  double lut_ns = 0.7;             ///< one LUT and the wire to it
  double carry_start_ns = 0.8;     ///< onto and off a carry chain
  double carry_ns_per_bit = 0.02;  ///< along it
  double multiplier_ns = 3.0;      ///< one embedded multiplier, unregistered
  double multiplier_add_ns = 1.0;  ///< per level of adding partial products
  double register_ns = 0.6;        ///< clock-to-output plus set-up
};

/// The logic between two cut points of a unit.
struct Stage {
  std::string name;  ///< as in the comment of the template
  double delay_ns;
};

/// A template and its stages; bit k of its CUTS parameter registers the end of stage k.
struct Unit {
  std::string module;
  std::vector<Stage> stages;
};

/// The unit that computes `node` (not for input, constant, negate, absolute: those are wires).
Unit unit_for(const model::TypedNode& node, model::Subnormals subnormals, const DelayTable& delays);
Unit compare_unit(model::FloatFormat format, const DelayTable& delays);
Unit ulp_distance_unit(model::FloatFormat format, const DelayTable& delays);
Unit interval_decision_unit(model::FloatFormat format, const DelayTable& delays);

/// The unit of a node of a lane's error bound (not for a constant: that is a literal).
Unit bound_unit(model::BoundOperation operation, model::FloatFormat lane, model::BoundFormat bound,
                const DelayTable& delays);
Unit bound_at_most_unit(model::BoundFormat bound, const DelayTable& delays);
Unit bound_decision_unit(model::FloatFormat lane, model::BoundFormat bound,
                         const DelayTable& delays);
/// Not for a sign alone: that is a wire.
Unit range_check_unit(const model::RangeCheck& check, const DelayTable& delays);

}  // namespace mixcmp::gen

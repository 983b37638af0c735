#pragma once

#include <optional>
#include <string>

#include "model/cost/measured/measurement.hpp"
#include "model/design/design.hpp"
#include "model/plan/optimise/feasibility.hpp"

namespace mixcmp::optimise {

/// The resources of a device that a design takes, as known before synthesis. Measured amounts are a
/// lower bound.
struct Footprint {
  Amounts amounts{};      ///< of bounded_resources
  bool measured = false;  ///< false: `amounts` is a rough estimate of LUTs only
};

/// Adds up the areas in `table` (may be null) if it has a row for every kind of lane and reference.
/// Scoreboards and crossbar are included if the table has them. Otherwise estimates the LUTs of the
/// datapaths by the rough cost model.
Footprint footprint_of(const design::Design& design, const measured::Characterisation* table,
                       const devices::Device& device);

/// A message that says why the design cannot fit the device; none if it may fit. Measured amounts
/// must not exceed the device; a rough estimate may exceed it by half. `source` names the table.
std::optional<std::string> excess_of(const Footprint& footprint, const design::Design& design,
                                     const devices::Device& device, const std::string& source);

}  // namespace mixcmp::optimise

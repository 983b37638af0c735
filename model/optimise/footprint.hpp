#pragma once

#include <optional>
#include <string>

#include "model/characterise/measurement.hpp"
#include "model/design/design.hpp"
#include "model/optimise/feasibility.hpp"

namespace mixcmp::model {

/// A lower bound on what a design takes of a device, as known before it is synthesised.
struct Footprint {
  Amounts amounts{};      ///< of bounded_resources
  bool measured = false;  ///< of every kind of datapath; else a rough estimate of LUTs alone
};

/// Adds up the rows of `table` (may be null) where it has each kind of lane and reference, with
/// their streams and crossbar as far as the table has them. Otherwise the rough cost model counts,
/// and datapaths alone.
Footprint footprint_of(const Design& design, const Characterisation* table, const Device& device);

/// Why the design plainly does not fit the device: more of something than there is, or by the rough
/// cost model half as many LUTs again. None where it may fit. `source` names the table.
std::optional<std::string> excess_of(const Footprint& footprint, const Design& design,
                                     const Device& device, const std::string& source);

}  // namespace mixcmp::model

#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "model/cost/devices/device.hpp"
#include "model/lane/error/lane.hpp"
#include "model/lane/fixed/reference_datapath.hpp"

namespace mixcmp::estimated {

/// Whether an estimate includes products.
enum class Products {
  in_luts,
  left_out,           ///< embedded multipliers compute them
  squares_in_memory,  ///< memories contain the squares of fixed-point lanes
};

/// A rough area of datapaths, in LUTs of six inputs and no DSPs: one term per operation, fitted to
/// Yosys' results for our units (docs/theory.md has the measurements). Its purpose is to compare
/// precisions of one expression. Registers, scoreboards and the crossbar are not included.
double lane_luts(const error::Lane& lane, Products products = Products::in_luts);
double lane_luts(const fixed::FixedLane& lane, Products products = Products::in_luts);
double reference_luts(const fixed::ReferenceDatapath& reference,
                      Products products = Products::in_luts);

/// The number of embedded multipliers of this size that cover every product of a datapath.
int embedded_multipliers(const error::Lane& lane, const devices::MultiplierSize& size);
int embedded_multipliers(const fixed::FixedLane& lane, const devices::MultiplierSize& size);
int embedded_multipliers(const fixed::ReferenceDatapath& reference,
                         const devices::MultiplierSize& size);

/// The number of blocks that hold the squares of a lane that reads them from memories, if a block
/// can hold any part of a memory.
int memory_blocks(const fixed::FixedLane& lane, const devices::MemoryBlock& block);

/// Areas measured by the user; each replaces the estimate for its scheme and precision.
class MeasuredAreas {
public:
  /// Reads a CSV file with a header and the columns scheme, precision, luts: "relative,17,2210".
  /// The scheme "reference" stands for the reference datapath; its precision is ignored.
  static Result<MeasuredAreas> read(const std::filesystem::path& path);

  std::optional<double> of(const std::string& scheme, int precision) const;
  std::optional<double> reference() const;

private:
  std::map<std::pair<std::string, int>, double> luts_;
};

}  // namespace mixcmp::estimated

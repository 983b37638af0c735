#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/comparison/expression/graph.hpp"
#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::test {

/// A comparison of inputs with ranges, small enough for every lane in fixed point to be tried on
/// every operand of a small format.
struct BoundedComparison {
  const char* name;
  const char* f;
  const char* g;
  Range range;                           ///< of every input but c
  std::optional<Range> of_c{};           ///< none: `range`
  std::optional<bool> has_norm = false;  ///< none: at some widths

  Graph graph() const;
  std::vector<std::optional<Range>> ranges() const;  ///< one per input
};

void PrintTo(const BoundedComparison& comparison, std::ostream* stream);

/// All operations, signs and shapes that bounds of lanes in fixed point distinguish.
std::vector<BoundedComparison> bounded_comparisons();

struct NamedFixedLane {
  std::string name;
  fixed::FixedLane lane;
};
/// The comparison's lanes at these widths, by every bound that exists; where `has_norm` says
/// otherwise, a test fails.
std::vector<NamedFixedLane> fixed_lanes(const BoundedComparison& comparison, FloatFormat format,
                                        const std::vector<int>& widths);
/// The lanes in block floating point; none where f and g are not homogeneous of one degree.
std::vector<NamedFixedLane> block_lanes(const BoundedComparison& comparison, FloatFormat format,
                                        const std::vector<int>& widths);

/// The lanes with guard digits; none where a format of them is refused, as where f and g are not
/// homogeneous of one degree in the numbers that are cut in common.
std::vector<NamedFixedLane> guarded_lanes(const BoundedComparison& comparison, FloatFormat format,
                                          const std::vector<FixedPoint>& lane_formats);

/// The lanes that rely on grids of 1 or of 1/4; none where something is rounded.
std::vector<NamedFixedLane> grid_lanes(const BoundedComparison& comparison, FloatFormat format,
                                       const std::vector<int>& widths);

}  // namespace mixcmp::test

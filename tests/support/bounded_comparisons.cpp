#include "tests/support/bounded_comparisons.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "model/lane/fixed/scale_degree.hpp"
#include "tests/support/graphs.hpp"

namespace mixcmp::test {

Graph BoundedComparison::graph() const {
  return graph_of(f, g);
}

std::vector<std::optional<Range>> BoundedComparison::ranges() const {
  const Graph parsed = graph();
  std::vector<std::optional<Range>> ranges;
  for (const std::string& input : parsed.inputs()) {
    ranges.push_back(input == "c" && of_c ? *of_c : range);
  }
  return ranges;
}

void PrintTo(const BoundedComparison& comparison, std::ostream* stream) {
  *stream << comparison.f << " against " << comparison.g;
}

namespace {

std::vector<BoundedComparison> comparisons_with_limits_and_cuts() {
  return {BoundedComparison{"limited_difference", "within(a - b, -1, 1)", "c", {-3, 3}},
          BoundedComparison{"limited_from_below", "within(a^2, 0.5, 4)", "b", {-3, 3}},
          BoundedComparison{"limited_input", "within(a, 1, 2) * b", "c", {0, 3}},
          BoundedComparison{
              "limited_element", "within(a - b, -1, 1)^2 + b^2", "c^2", {0, 3}, Range{0, 6}, true},
          BoundedComparison{"limited_radius", "a^2", "within(b - c, 0, 2)^2", {0, 3}, {}, true},
          BoundedComparison{"limits_that_always_hold", "within(a, -8, 8) - b", "c", {0, 3}},
          BoundedComparison{
              "factor_of_hardly_a_sign", "min(max(a - b, -0x1p-6), 0x1p-6) * c", "b", {-3, 3}},
          BoundedComparison{"limited_factor", "within(a - b, -0x1p-6, 0x1p-6) * c", "b", {-3, 3}},
          BoundedComparison{"factors_of_few_bits", "(a * b)^2 * a", "(a - b) * (a * b)", {-3, 3}}};
}

std::vector<BoundedComparison> comparisons_with_norms() {
  return {
      BoundedComparison{"squares", "a^2", "b^2", {0, 3}, {}, true},
      BoundedComparison{"signed_squares", "a^2", "b^2", {-3, 3}, {}, true},
      BoundedComparison{"distance", "(a - b)^2", "c^2", {0, 3}, {}, true},
      BoundedComparison{"swapped_distance", "c^2", "(a - b)^2", {0, 3}, {}, true},
      BoundedComparison{"signed_distance", "(a - b)^2", "c^2", {-3, 3}, Range{0, 5}, true},
      BoundedComparison{"two_terms", "a^2 + b^2", "c^2", {-2, 2}, Range{0, 3}, true},
      BoundedComparison{"two_radii", "a^2", "(b + c)^2", {0, 3}, Range{0, 6}, true},
      BoundedComparison{"hypotenuse", "a^2 + b^2", "c^2", {0, 6}, {}, true},
      BoundedComparison{"absolute_radius", "a^2", "abs(b - c)^2", {0, 3}, {}, true},
      BoundedComparison{
          "radius_of_either_sign", "a^2", "(1.3 - b)^2", {0, mpq_class(19, 10)}, {}, true},
      BoundedComparison{"two_norms", "(a - b)^2", "(a - c)^2 + b^2", {0, 3}, {}, true},
      BoundedComparison{"nearer_of_two", "(a - b)^2 + b^2", "(a - c)^2 + c^2", {-3, 3}, {}, true},
      BoundedComparison{"radius_of_two_signs", "a^2", "(b - c)^2", {0, 3}, {}, true},
      BoundedComparison{
          "radius_much_finer", "a^2 + b^2", "c^2", {0, 3}, Range{0, mpq_class(1, 16)}, true},
      BoundedComparison{
          "radius_much_coarser", "(a - b)^2", "c^2", {0, mpq_class(1, 8)}, Range{0, 6}, true},
      BoundedComparison{
          "radius_far_below", "(a - b)^2", "c^2", {0, 200}, Range{0, mpq_class(1, 4)}, true},
      BoundedComparison{
          "radius_far_below_two", "c^2", "(a - b)^2 + b^2", {-60, 60}, Range{0, 1}, true},
      BoundedComparison{"norm_far_below_another",
                        "(a - 1.5 * b)^2",
                        "c^2 + (c - 0.1)^2",
                        {-60, 60},
                        Range{0, 1},
                        std::nullopt},
      BoundedComparison{"multiple_beyond_reach", "(3 * a)^2", "b^2 / 64", {0, 3}, {}, std::nullopt},
      BoundedComparison{
          "three_terms_beyond_reach", "(a + b - 1.5)^2", "c^2", {0, 6}, Range{0, 1}, true},
      BoundedComparison{"always_beyond_reach", "(a + 30)^2 + b^2", "c^2", {0, 3}, {}, true},
      BoundedComparison{"differences_of_two_ranges",
                        "(a - c)^2",
                        "b^2 + (b - 0.5)^2",
                        {0, 1},
                        Range{-100, 100},
                        true}};
}

}  // namespace

std::vector<BoundedComparison> bounded_comparisons() {
  std::vector<BoundedComparison> all = {
      BoundedComparison{"inputs", "a", "b", {0, 4}},
      BoundedComparison{"signed_inputs", "a", "b", {-3, 4}},
      BoundedComparison{"constant", "a", "0.3", {0, 1}},
      BoundedComparison{"negative", "-a", "-2.5", {0, 3}},
      BoundedComparison{"scaled", "0.3 * a", "b", {0, 3}},
      BoundedComparison{"against_a_constant", "a^2 + b^2", "2", {-2, 2}},
      BoundedComparison{"rectangle", "a * b", "c", {0, 3}, Range{0, 9}},
      BoundedComparison{"signed_product", "a * b", "c", {-3, 3}},
      BoundedComparison{"absolute", "abs(a - b)", "c", {0, 3}},
      BoundedComparison{"absolute_of_signed", "abs(a)", "abs(b)", {-6, 3}},
      BoundedComparison{"taxi", "abs(a - 1) + abs(b - 1)", "c", {0, 3}},
      BoundedComparison{"minimum", "min(a, b)", "c", {-3, 3}},
      BoundedComparison{"maximum", "max(a^2, b)", "abs(c)", {-3, 3}},
      BoundedComparison{"cancelling_squares", "a^2 - b^2", "c", {0, 3}},
      BoundedComparison{"cube", "a^3", "b", {-2, 2}},
      BoundedComparison{"eighth", "a^8", "b", {0, 2}},
      BoundedComparison{"polynomial", "a^3 - 3 * a * b", "b", {-3, 3}},
      BoundedComparison{"scales", "a - c / 1024", "b", {0, 3}, Range{0, 3000}},
      BoundedComparison{"tiny_range", "a", "b", {0, mpq_class(1, 16)}},
      BoundedComparison{"itself", "a - a", "b - b", {0, 3}},
      BoundedComparison{"weighted_squares", "(a - b)^2 + 9/4 * b^2", "c^2 * 4", {-3, 3}, {}, true},
      BoundedComparison{"clamped_at_zero", "max(a - b, 0)", "c / 3", {-3, 3}},
      BoundedComparison{"product_of_two_degrees", "a * b * c", "sqrt(a * b) * b^2", {0, 3}},
      BoundedComparison{"clamped", "min(max(a - b, 0), 1)", "c", {0, 3}},
      BoundedComparison{"square_less_a_product", "(c - a * b)^2", "b", {0, 3}},
      BoundedComparison{"square_less_a_square", "(c - (a - b)^2)^2 + a", "b", {0, 3}},
      BoundedComparison{"root", "sqrt(a)", "b", {0, 4}},
      BoundedComparison{"root_of_a_fine_minimum", "sqrt(min(a, b / 1024))", "b / 16", {0, 4}},
      BoundedComparison{"root_above_zero", "sqrt(a + 1)", "b", {0, 4}},
      BoundedComparison{"root_of_a_product", "sqrt(a * b)", "c", {0, 3}},
      BoundedComparison{"distance_as_a_root", "sqrt(a^2 + b^2)", "c", {-2, 2}, Range{0, 3}},
      BoundedComparison{"roots", "sqrt(a^2 + b^2) - sqrt(abs(c))", "sqrt(max(b, c^2))", {-2, 2}},
      BoundedComparison{"norms", "a^2 + b^2", "(c + 0.7)^2", {-2, 2}, Range{0, 3}, true}};
  for (auto& further : {comparisons_with_norms(), comparisons_with_limits_and_cuts()}) {
    all.insert(all.end(), further.begin(), further.end());
  }
  return all;
}

namespace {

std::vector<NamedFixedLane> lanes_of(const BoundedComparison& comparison, FloatFormat format,
                                     const std::vector<FixedPoint>& lane_formats) {
  std::vector<NamedFixedLane> lanes;
  for (const FixedPoint& lane_format : lane_formats) {
    for (const auto& [bound, name] : {std::pair(BoundKind::constant, "constant"),
                                      {BoundKind::norm, "norm"},
                                      {BoundKind::running, "running"}}) {
      const auto lane =
          fixed::fixed_lane(comparison.graph(), format,
                            {.format = lane_format, .bound = bound, .ranges = comparison.ranges()});
      const bool exists = bound == BoundKind::constant ||
                          (bound == BoundKind::norm && comparison.has_norm.value_or(lane.ok())) ||
                          (bound == BoundKind::running && lane.ok());
      EXPECT_EQ(lane.ok(), exists) << lane_format.name() << ", " << name;
      if (lane.ok()) lanes.push_back({fmt::format("{}, {}", lane_format.name(), name), *lane});
    }
  }
  return lanes;
}

}  // namespace

std::vector<NamedFixedLane> fixed_lanes(const BoundedComparison& comparison, FloatFormat format,
                                        const std::vector<int>& widths) {
  std::vector<FixedPoint> formats;
  for (const int bits : widths) formats.push_back({.bits = bits});
  return lanes_of(comparison, format, formats);
}

std::vector<NamedFixedLane> block_lanes(const BoundedComparison& comparison, FloatFormat format,
                                        const std::vector<int>& widths) {
  if (!fixed::scale_degrees(comparison.graph()).ok()) return {};
  std::vector<FixedPoint> formats;
  for (const int bits : widths) formats.push_back({.bits = bits, .is_block = true});
  return lanes_of(comparison, format, formats);
}

std::vector<NamedFixedLane> guarded_lanes(const BoundedComparison& comparison, FloatFormat format,
                                          const std::vector<FixedPoint>& lane_formats) {
  std::vector<FixedPoint> formats;
  for (const FixedPoint& lane_format : lane_formats) {
    const fixed::FixedOptions options = {.format = lane_format, .ranges = comparison.ranges()};
    const auto lane = fixed::fixed_lane(comparison.graph(), format, options);
    if (lane.ok()) formats.push_back(lane_format);
  }
  return lanes_of(comparison, format, formats);
}

std::vector<NamedFixedLane> grid_lanes(const BoundedComparison& comparison, FloatFormat format,
                                       const std::vector<int>& widths) {
  std::vector<NamedFixedLane> lanes;
  const Graph graph = comparison.graph();
  for (const mpq_class& grid : {mpq_class(1), mpq_class(1, 4)}) {
    const std::vector<std::optional<mpq_class>> grids(graph.inputs().size(), grid);
    for (const int bits : widths) {
      const auto lane = fixed::fixed_lane(graph, format,
                                          {.format = {bits},
                                           .bound = BoundKind::grid,
                                           .ranges = comparison.ranges(),
                                           .grids = grids});
      if (!lane.ok()) continue;  // something is rounded
      lanes.push_back({fmt::format("q{}, multiples of {}", bits, grid.get_str()), *lane});
    }
  }
  return lanes;
}

}  // namespace mixcmp::test

#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "model/judge/proof/gappa.hpp"
#include "model/judge/proof/lane_proof.hpp"
#include "model/judge/proof/provers.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/sphere.hpp"

namespace mixcmp::test {

/// A prover for one test, with a time limit that no test reaches.
inline proof::QuickProver patient_prover() {
  return proof::QuickProver(60);
}

struct LaneOptions {
  const char* format = "s17e8";
  Rounding rounding = Rounding::nearest_even;
  LaneInputs inputs = LaneInputs::exact;
  BoundKind kind = BoundKind::relative;
  int bound_digits = 4;
  std::vector<std::optional<Range>> ranges = {};
  const char* reference = "s53e8";
};

inline TypedGraph typed_graph(const Graph& graph, const LaneOptions& options) {
  const Arithmetic arithmetic = {format(options.format), options.rounding, Subnormals::flush};
  return lane_graph(graph, format(options.reference), arithmetic, options.inputs);
}

inline Result<error::Lane> lane_of(const Graph& graph, const LaneOptions& options) {
  return error::certified_lane(
      typed_graph(graph, options),
      {.kind = options.kind, .bound_digits = options.bound_digits, .ranges = options.ranges});
}

/// Every input in [0, 100].
inline std::vector<std::optional<Range>> nonnegative_ranges(const Graph& graph) {
  return std::vector<std::optional<Range>>(graph.inputs().size(), Range{.low = 0, .high = 100});
}

class WithGappa : public testing::Test {
protected:
  void SetUp() override {
    if (!proof::gappa_version()) GTEST_SKIP() << "gappa is not installed";
  }
};

}  // namespace mixcmp::test

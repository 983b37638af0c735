#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "model/error/certified_lane.hpp"
#include "model/proof/gappa.hpp"
#include "model/proof/lane_proof.hpp"
#include "model/proof/provers.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/sphere.hpp"

namespace mixcmp::test {

/// A prover for one test, which is not to run into its limit.
inline model::proof::QuickProver patient_prover() {
  return model::proof::QuickProver(60);
}

struct LaneOptions {
  const char* format = "s17e8";
  model::Rounding rounding = model::Rounding::nearest_even;
  model::LaneInputs inputs = model::LaneInputs::exact;
  model::ErrorBoundKind kind = model::ErrorBoundKind::relative;
  int bound_digits = 4;
  std::vector<std::optional<model::Range>> ranges = {};
  const char* reference = "s53e8";
};

inline model::TypedGraph typed_graph(const model::Graph& graph, const LaneOptions& options) {
  const model::Arithmetic arithmetic = {format(options.format), options.rounding,
                                        model::Subnormals::flush};
  return model::lane_graph(graph, format(options.reference), arithmetic, options.inputs);
}

inline model::Result<model::Lane> lane_of(const model::Graph& graph, const LaneOptions& options) {
  return model::certified_lane(
      typed_graph(graph, options),
      {.kind = options.kind, .bound_digits = options.bound_digits, .ranges = options.ranges});
}

/// Every input in [0, 100].
inline std::vector<std::optional<model::Range>> nonnegative_ranges(const model::Graph& graph) {
  return std::vector<std::optional<model::Range>>(graph.inputs().size(),
                                                  model::Range{.low = 0, .high = 100});
}

class WithGappa : public testing::Test {
protected:
  void SetUp() override {
    if (!model::proof::gappa_version()) GTEST_SKIP() << "gappa is not installed";
  }
};

}  // namespace mixcmp::test

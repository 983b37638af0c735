#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/present/table/table.hpp"
#include "model/plan/optimise/exploration.hpp"
#include "model/plan/optimise/published.hpp"

namespace mixcmp::report {

/// The throughput of software in comparisons per second, for the normalised speed-ups of Table IV.
struct SoftwareThroughput {
  std::string title;  ///< "AMD EPYC ..., 2 cores, double"
  double one_core_per_s = 0;
  double all_cores_per_s = 0;
};

/// Tables III and IV, the paper's column first where `published` is given.
table::Table table3(const optimise::Exploration& exploration,
                    const std::optional<optimise::PublishedFigures>& published);
table::Table table4(const optimise::Exploration& exploration,
                    const std::optional<optimise::PublishedFigures>& published,
                    const std::vector<SoftwareThroughput>& software);

}  // namespace mixcmp::report

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/optimise/exploration.hpp"
#include "model/optimise/published.hpp"

namespace mixcmp::report {

/// The throughput of software in comparisons per second, for the normalised speed-ups of Table IV.
struct SoftwareThroughput {
  std::string title;  ///< "AMD EPYC ..., 2 cores, double"
  double one_core_per_s = 0;
  double all_cores_per_s = 0;
};

/// Tables III and IV as Markdown, the paper's column first where `published` is given.
std::string table3_markdown(const optimise::Exploration& exploration,
                            const std::optional<optimise::PublishedFigures>& published);
std::string table4_markdown(const optimise::Exploration& exploration,
                            const std::optional<optimise::PublishedFigures>& published,
                            const std::vector<SoftwareThroughput>& software);

}  // namespace mixcmp::report

#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "generator/components/component_list.hpp"
#include "model/characterise/job_runner.hpp"
#include "model/characterise/measurement.hpp"

namespace mixcmp::gen {

struct CharacteriseOptions {
  ComponentQuery query;
  model::SynthesisOptions synthesis;
  std::filesystem::path store;
  unsigned workers = 1;
  /// What is finished of how many jobs, and how many seconds they have taken.
  std::function<void(int finished, int jobs, double seconds)> progress = {};
};

struct CharacteriseReport {
  model::Characterisation table;
  int components = 0;   ///< asked for
  int synthesised = 0;  ///< jobs that ended well; several components may share one
  int kept = 0;         ///< rows of the table before that were not asked for and are current
  int dropped = 0;      ///< rows of it that are neither
  std::vector<MissingLane> missing;
  std::vector<model::FailedJob> failed;
  /// Reasons why there is no clock where one was asked for, each with its components.
  std::map<std::string, std::vector<std::string>> no_clock;
  int interrupted_by = 0;  ///< a signal; 0: none
};

/// Measures what the store lacks and makes a table of it. Rows of `previous` (may be null) that are
/// not asked for stay where they are current: where today's generator, tools and device give their
/// hash. Of an area alone that is asked for, a current row with a clock stays, too: it says more.
model::Result<CharacteriseReport> characterise(const model::Scene& scene,
                                               const model::Comparisons* data,
                                               const model::Device& device,
                                               const CharacteriseOptions& options,
                                               const model::Characterisation* previous);

/// How much of a table still tells of what is generated today.
struct Currency {
  int rows = 0;
  int outdated = 0;  ///< measured on other RTL, or for another device's synthesis
};

/// Writes all RTL again and compares hashes; runs no tool, and asks each row's own tools only by
/// name. Seconds for hundreds of rows.
Currency check_currency(const model::Characterisation& table, const model::Scene& scene,
                        const model::Comparisons* data, const model::Device& device);

}  // namespace mixcmp::gen

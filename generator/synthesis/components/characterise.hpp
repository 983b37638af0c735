#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "generator/synthesis/characterise/job_runner.hpp"
#include "generator/synthesis/components/component_list.hpp"
#include "model/cost/measured/measurement.hpp"

namespace mixcmp::components {

/// "lane s12e8 exact relative embedded": a component's key in words.
std::string label(const measured::ComponentKey& key);

struct CharacteriseOptions {
  ComponentQuery query;
  characterise::SynthesisOptions synthesis;
  std::filesystem::path store;
  unsigned workers = 1;
  /// Called with the number of finished jobs, the number of all jobs, and the seconds so far.
  std::function<void(int finished, int jobs, double seconds)> progress = {};
};

struct CharacteriseReport {
  measured::Characterisation table;
  int components = 0;   ///< components asked for
  int synthesised = 0;  ///< jobs that ended well; several components may share one
  int kept = 0;         ///< rows of the previous table, not asked for, that are current
  int imported = 0;     ///< rows asked for that stay as a vendor's report gave them
  int dropped = 0;      ///< rows of the previous table, not asked for, that are outdated
  std::vector<MissingLane> missing;
  std::vector<characterise::FailedJob> failed;
  /// Reasons why there is no clock where one was asked for, each with its components.
  std::map<std::string, std::vector<std::string>> no_clock;
  int interrupted_by = 0;  ///< number of the signal that interrupted the run; 0: none
};

/// Measures the components that the store lacks, and makes a table of all that are asked for. Rows
/// of `previous` (may be null) that are not asked for stay if they are current: if today's
/// generator, tools and device give the same hash. If only areas are asked for, a current row that
/// also has a clock replaces a new one. A row from a vendor's report stays as long as today's
/// generator makes the same RTL, even if it is asked for.
Result<CharacteriseReport> characterise(const scene::Scene& scene, const data::Comparisons* data,
                                        const devices::Device& device,
                                        const CharacteriseOptions& options,
                                        const measured::Characterisation* previous);

/// One job of a campaign.
struct PlannedJob {
  std::string hash;   ///< its key in a store
  std::string label;  ///< "lane s12e8 exact relative embedded"

  friend auto operator<=>(const PlannedJob&, const PlannedJob&) = default;
};

/// The jobs whose results `characterise` needs, each once, by rising hash.
Result<std::vector<PlannedJob>> list_jobs(const scene::Scene& scene, const data::Comparisons* data,
                                          const devices::Device& device,
                                          const CharacteriseOptions& options);

/// Measures those jobs with these hashes that the store lacks. Makes no table.
Result<characterise::JobRun> run_some(const scene::Scene& scene, const data::Comparisons* data,
                                      const devices::Device& device,
                                      const CharacteriseOptions& options,
                                      const std::set<std::string>& hashes);

/// The rows of a table that describe today's RTL and synthesis of this scene's components, with the
/// tools that each row names. Generates the RTL of every row again, and runs no tool.
std::vector<const measured::Measurement*> current_rows(const measured::Characterisation& table,
                                                       const scene::Scene& scene,
                                                       const data::Comparisons* data,
                                                       const devices::Device& device);

/// The number of a table's rows, and of those that no longer describe today's RTL or synthesis.
struct RowCount {
  int all = 0;
  int outdated = 0;  ///< measured on other RTL, or for another device's synthesis
};

/// Counts by current_rows. It takes seconds for hundreds of rows.
RowCount count_rows(const measured::Characterisation& table, const scene::Scene& scene,
                    const data::Comparisons* data, const devices::Device& device);

}  // namespace mixcmp::components

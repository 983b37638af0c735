#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "generator/software/float_filter.hpp"
#include "model/base/common/process.hpp"
#include "model/comparison/data/comparisons.hpp"

namespace mixcmp::software {

struct BaselineOptions {
  std::filesystem::path work;  ///< an existing folder for source, program, data and logs
  unsigned threads = 0;        ///< for the measurement on all cores; 0: one per core
  int rounds = 5;
  double seconds = 0.5;         ///< run time of one kernel in one round
  std::uint64_t sample = 4096;  ///< about how many comparisons the golden model checks
  Progress progress = {};
};

struct VerdictCounts {
  std::uint64_t less = 0, equal = 0, greater = 0, unordered = 0;
  friend bool operator==(const VerdictCounts&, const VerdictCounts&) = default;
};

/// Comparisons per second of one kernel over all rounds, summed over its threads. Seconds are those
/// of the thread's processor time, which equals wall-clock time if nothing else runs.
struct MeasuredRate {
  unsigned threads = 1;
  double best_per_s = 0, median_per_s = 0;
  /// The share of the processors that other programs left in the best round: processor time divided
  /// by wall-clock time.
  double processor_share = 0;
};

struct BaselineKernel {
  std::optional<BoundKind> filter;  ///< nullopt: double throughout
  VerdictCounts verdicts;           ///< the verdicts of all comparisons
  std::uint64_t recomputed = 0;     ///< comparisons that a filter left to doubles
  MeasuredRate one_core, all_cores;
};

/// The verdicts of the sample, compared one by one with those of the golden model.
struct BaselineCheck {
  std::uint64_t comparisons = 0;
  std::uint64_t wrong = 0;             ///< verdicts in double unlike the golden model's binary64
  std::uint64_t decided_wrongly = 0;   ///< verdicts of filters unlike the order of the real numbers
  std::uint64_t not_true = 0;          ///< verdicts in double unlike the order of the real numbers
  std::uint64_t undetermined = 0;      ///< true order unknown: in neither of the two counts above
  std::uint64_t unlike_reference = 0;  ///< verdicts in double unlike those of the scene's reference
};

/// A scene's comparison in software, measured on this machine.
struct Baseline {
  std::string scene;
  std::string processor, compiler, compile_command;
  std::uint64_t comparisons = 0;
  unsigned threads = 1;
  double seconds = 0;
  int rounds = 0;
  std::vector<BaselineKernel> kernels;  ///< double first
  std::vector<MissingFilter> missing;
  BaselineCheck check;

  /// Tells whether the golden model agrees and every kernel counts the same verdicts.
  bool passed() const;
  const BaselineKernel& exact() const { return kernels.front(); }
  /// The kernel that is fastest on all cores. Hardware has to beat it.
  const BaselineKernel& fastest() const;
};

/// Writes, compiles (g++) and runs the comparison. Errors: a format that doubles do not hold, a
/// compiler or program that fails.
Result<Baseline> software_baseline(const scene::Scene& scene, const data::Comparisons& data,
                                   const BaselineOptions& options);

/// "double", "float filter, constant bound".
std::string kernel_name(const BaselineKernel& kernel);
std::string to_text(const Baseline& baseline);
std::string to_csv(const Baseline& baseline);
nlohmann::ordered_json to_json(const Baseline& baseline);

}  // namespace mixcmp::software

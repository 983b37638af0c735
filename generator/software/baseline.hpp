#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "generator/software/float_filter.hpp"
#include "model/common/process.hpp"
#include "model/data/comparisons.hpp"

namespace mixcmp::gen {

struct BaselineOptions {
  std::filesystem::path work;  ///< an existing folder for source, program, data and logs
  unsigned threads = 0;        ///< "all cores"; 0: as many as the machine has
  int rounds = 5;
  double seconds = 0.5;         ///< that one kernel runs in one round
  std::uint64_t sample = 4096;  ///< comparisons held against the golden model, about
  model::Progress progress = {};
};

struct VerdictCounts {
  std::uint64_t less = 0, equal = 0, greater = 0, unordered = 0;
  friend bool operator==(const VerdictCounts&, const VerdictCounts&) = default;
};

/// Comparisons per second of one kernel on some threads, over all rounds: of processor time, which
/// is that of the clock where nothing else runs, and the sum over the threads.
struct MeasuredRate {
  unsigned threads = 1;
  double best_per_s = 0, median_per_s = 0;
  /// What other programs left of the processors in the best round.
  double processor_share = 0;
};

struct BaselineKernel {
  std::optional<model::ErrorBoundKind> filter;  ///< none: double throughout
  VerdictCounts verdicts;                       ///< of all comparisons
  std::uint64_t recomputed = 0;                 ///< in double, by a filter
  MeasuredRate one_core, all_cores;
};

/// The sample held against the golden model, verdict by verdict.
struct BaselineCheck {
  std::uint64_t comparisons = 0;
  std::uint64_t wrong = 0;             ///< differ from the golden model's binary64
  std::uint64_t decided_wrongly = 0;   ///< by a filter, against the order of the real numbers
  std::uint64_t not_true = 0;          ///< of the doubles, against the order of the real numbers
  std::uint64_t undetermined = 0;      ///< truths; nobody is called untrue or wrong there
  std::uint64_t unlike_reference = 0;  ///< of the doubles, against the scene's reference
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

  /// The golden model agrees, and every kernel counts the same verdicts.
  bool passed() const;
  const BaselineKernel& exact() const { return kernels.front(); }
  /// The kernel that is fastest on all cores: what hardware has to beat.
  const BaselineKernel& fastest() const;
};

/// Writes, compiles (g++) and runs the comparison. Errors: a format that doubles do not hold, a
/// compiler or program that fails.
model::Result<Baseline> software_baseline(const model::Scene& scene, const model::Comparisons& data,
                                          const BaselineOptions& options);

/// "double", "float filter, constant bound".
std::string kernel_name(const BaselineKernel& kernel);
std::string to_text(const Baseline& baseline);
std::string to_csv(const Baseline& baseline);
nlohmann::ordered_json to_json(const Baseline& baseline);

}  // namespace mixcmp::gen

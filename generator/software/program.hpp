#pragma once

#include "generator/software/baseline.hpp"

namespace mixcmp::gen {

/// The program's output for one kernel.
struct KernelOutput {
  std::string name;  ///< "double", or the kind of a filter's bound
  VerdictCounts verdicts;
  std::uint64_t recomputed = 0;
  std::string letters;              ///< one per comparison: <, =, >, u; ?: undecided by the filter
  std::vector<MeasuredRate> rates;  ///< one per round and number of threads, in order
};

/// The compiled comparison of one scene.
class SoftwareProgram {
public:
  static model::Result<SoftwareProgram> compile(const model::Scene& scene,
                                                const model::Comparisons& data,
                                                const FloatFilters& filters,
                                                const BaselineOptions& options);

  const std::string& compiler() const { return compiler_; }
  static const model::Command& command();

  /// Runs the program on small data with the scene's columns, and returns every verdict.
  model::Result<std::vector<KernelOutput>> verdicts(const model::Comparisons& data) const;
  model::Result<std::vector<KernelOutput>> measure(const model::Comparisons& data,
                                                   unsigned threads) const;

private:
  SoftwareProgram(BaselineOptions options, std::string compiler)
      : options_(std::move(options)), compiler_(std::move(compiler)) {}

  model::Result<std::vector<KernelOutput>> run(const model::Comparisons& data,
                                               const model::Command& arguments) const;

  BaselineOptions options_;
  std::string compiler_;
};

}  // namespace mixcmp::gen

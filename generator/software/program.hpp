#pragma once

#include "generator/software/baseline.hpp"

namespace mixcmp::software {

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
  static Result<SoftwareProgram> compile(const scene::Scene& scene, const data::Comparisons& data,
                                         const FloatFilters& filters,
                                         const BaselineOptions& options);

  const std::string& compiler() const { return compiler_; }
  static const Command& command();

  /// Runs the program on small data with the scene's columns, and returns every verdict.
  Result<std::vector<KernelOutput>> verdicts(const data::Comparisons& data) const;
  Result<std::vector<KernelOutput>> measure(const data::Comparisons& data, unsigned threads) const;

private:
  SoftwareProgram(BaselineOptions options, std::string compiler)
      : options_(std::move(options)), compiler_(std::move(compiler)) {}

  Result<std::vector<KernelOutput>> run(const data::Comparisons& data,
                                        const Command& arguments) const;

  BaselineOptions options_;
  std::string compiler_;
};

}  // namespace mixcmp::software

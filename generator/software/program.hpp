#pragma once

#include "generator/software/baseline.hpp"

namespace mixcmp::gen {

/// What the program said of one kernel.
struct KernelOutput {
  std::string name;  ///< "double", or the kind of a filter's bound
  VerdictCounts verdicts;
  std::uint64_t recomputed = 0;
  std::string letters;              ///< one a comparison: <, =, >, u; ?: undecided by the filter
  std::vector<MeasuredRate> rates;  ///< one a round and number of threads, in order
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

  /// Every verdict on (small) data that has the columns of the scene's.
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

#pragma once

#include <string>

#include "model/base/common/result.hpp"

namespace mixcmp::proof {

/// The answer of Gappa (https://gappa.gitlabpages.inria.fr) to a script. It never refutes by a
/// counterexample: `not_proven` is a search that ended without a proof.
enum class GappaVerdict {
  proven,
  not_proven,
  out_of_time,
  broken,  ///< no verdict: a script that it cannot read, a crash, no memory
};

enum class Certificate {
  none,
  coq,  ///< a proof that coqc checks against Gappa's library
};

struct GappaRun {
  GappaVerdict verdict;
  std::string message;      ///< Gappa's output
  std::string certificate;  ///< empty unless proven and asked for
};

/// "1.4.1" of the gappa that PATH finds; an error if no gappa there runs, or if it proves a
/// statement that is false.
Result<std::string> gappa_version();

/// Runs the gappa that PATH finds on a script, for at most `seconds` of wall time.
GappaRun run_gappa(const std::string& script, Certificate certificate, double seconds);

}  // namespace mixcmp::proof

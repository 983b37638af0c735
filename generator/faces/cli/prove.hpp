#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "generator/faces/cli/options.hpp"
#include "model/judge/proof/lane_proof.hpp"

namespace mixcmp::cli {

/// The options of `check --prove`.
struct ProveOptions {
  bool prove = false;
  std::filesystem::path directory;  ///< empty: one per lane, NAME_LANE_proof
  std::vector<int> precisions;      ///< empty: the scene's own
  double seconds_a_script = 10;
};
void add_prove_options(const Verb& verb, ProveOptions& options);

/// The proof of one lane of the scene in one precision.
struct ProvenLane {
  std::string format;
  std::string error;  ///< why there is no such lane; empty if there is one
  proof::LaneProof proof;
  std::string gappa;                ///< version; empty: Gappa is not installed
  std::filesystem::path directory;  ///< folder of scripts, certificates and verdicts
  int reused = 0;                   ///< scripts that an earlier run has proven
};
/// Proves the scene's lanes as `options` say; an error ends the program. `inputs`: files that no
/// report may replace.
std::vector<ProvenLane> prove(const LoadedScene& loaded, const ProveOptions& options,
                              const std::vector<std::filesystem::path>& inputs);

std::string to_text(const ProvenLane& lane);
nlohmann::ordered_json to_json(const ProvenLane& lane);

/// The proof that `generate` asks for before it calls a bound certified: one lemma per operation,
/// within seconds; no file is kept.
struct QuickProof {
  proof::LaneProof proof;
  std::string gappa;
};
/// Ends the program where Gappa refuses a lemma.
QuickProof prove_quickly(const std::filesystem::path& scene, const design::Lane& lane);

}  // namespace mixcmp::cli

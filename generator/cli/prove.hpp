#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "generator/cli/options.hpp"
#include "model/proof/lane_proof.hpp"

namespace mixcmp::cli {

/// `check --prove` and what goes with it.
struct ProveOptions {
  bool prove = false;
  std::filesystem::path directory;  ///< empty: one a lane, NAME_LANE_proof
  std::vector<int> precisions;      ///< empty: the scene's own
  double seconds_a_script = 10;
};
void add_prove_options(const Verb& verb, ProveOptions& options);

/// One lane of the scene in one precision.
struct ProvenLane {
  std::string format;
  std::string error;  ///< why there is no such lane; else empty
  model::proof::LaneProof proof;
  std::string gappa;                ///< version; empty: there is none
  std::filesystem::path directory;  ///< of scripts, certificates and verdicts
  int reused = 0;                   ///< scripts that an earlier run has proven
};
/// Errors end the program. `inputs`: files that no report may replace.
std::vector<ProvenLane> prove(const LoadedScene& loaded, const ProveOptions& options,
                              const std::vector<std::filesystem::path>& inputs);

std::string to_text(const ProvenLane& lane);
nlohmann::ordered_json to_json(const ProvenLane& lane);

/// What `generate` asks before it calls a bound certified: a lemma per operation, within seconds,
/// nothing kept. Ends the program where Gappa refuses one.
struct QuickProof {
  model::proof::LaneProof proof;
  std::string gappa;
};
QuickProof prove_quickly(const std::filesystem::path& scene, const model::CombinedLane& lane);

}  // namespace mixcmp::cli

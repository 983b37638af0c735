#include "generator/cli/prove.hpp"

#include <fmt/core.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "generator/cli/exit.hpp"
#include "model/proof/gappa.hpp"
#include "model/proof/provers.hpp"
#include "model/proof/report.hpp"

namespace mixcmp::cli {
namespace {

namespace proof = model::proof;

/// All of a quick proof's scripts together; a script takes some 10 ms.
constexpr double quick_seconds = 5;

/// The scene with lanes of another precision; a proof needs no number of lanes.
model::Result<model::Scene> with_precision(model::Scene scene, int precision) {
  const model::FloatFormat& known = scene.reduced.format.value_or(scene.reference.format);
  MIXCMP_TRY(format, model::FloatFormat::make(precision, known.exponent_bits()));
  scene.reduced.format = format;
  return scene;
}

model::Result<model::Lane> lane_of(model::Scene scene, const model::Comparisons* data) {
  scene.system.lanes = scene.system.lanes.value_or(1);
  scene.system.references = scene.system.references.value_or(1);
  MIXCMP_TRY(design, model::make_design(scene, data));
  return std::move(design.lane);
}

ProvenLane prove_lane(const std::string& name, const model::Lane& lane,
                      const ProveOptions& options) {
  ProvenLane result{.format = lane.graph.arithmetic.format.name()};
  const std::string stem = fmt::format("{}_{}", name, result.format);
  result.directory =
      options.directory.empty() ? std::filesystem::path(stem + "_proof") : options.directory;
  proof::ProofDirectory directory =
      value_or_exit(proof::ProofDirectory::open(result.directory, options.seconds_a_script));
  result.proof = proof::prove_lane(lane, std::ref(directory), proof::Effort::whole);
  if (directory.failure()) value_or_exit<model::Done>(*directory.failure());
  result.gappa = directory.gappa().value_or("");
  result.reused = directory.reused();
  const nlohmann::ordered_json report = proof::to_json(result.proof, result.gappa);
  value_or_exit(directory.write_report(stem + ".json", report.dump(2) + "\n"));
  return result;
}

}  // namespace

void add_prove_options(CLI::App& verb, ProveOptions& options) {
  auto* prove = verb.add_flag("--prove", options.prove,
                              "have Gappa prove the error bound; exit code 2 where it refuses");
  verb.add_option("--proof-dir", options.directory,
                  "where scripts, certificates and verdicts are kept (default: NAME_LANE_proof)")
      ->needs(prove);
  verb.add_option("--precisions", options.precisions,
                  "prove lanes of these precisions instead of the scene's: 4,8,17")
      ->delimiter(',')
      ->check(CLI::Range(4, 52))
      ->needs(prove);
  verb.add_option("--proof-seconds", options.seconds_a_script, "for each script, 10 if not given")
      ->check(CLI::PositiveNumber)
      ->needs(prove);
}

std::vector<ProvenLane> prove(const LoadedScene& loaded, const ProveOptions& options) {
  std::vector<model::Scene> scenes;
  for (const int precision : options.precisions) {
    scenes.push_back(value_or_exit(with_precision(loaded.scene, precision)));
  }
  if (scenes.empty()) scenes.push_back(loaded.scene);
  std::vector<ProvenLane> proven;
  for (const model::Scene& scene : scenes) {
    const auto lane = lane_of(scene, loaded.data ? &*loaded.data : nullptr);
    if (lane.ok()) {
      proven.push_back(prove_lane(scene.name, *lane, options));
    } else {
      proven.push_back({.format = scene.reduced.format ? scene.reduced.format->name() : "auto",
                        .error = lane.error().to_string()});
    }
  }
  return proven;
}

std::string to_text(const ProvenLane& lane) {
  if (!lane.error.empty()) return fmt::format("no lane in {}: {}\n", lane.format, lane.error);
  return proof::to_text(lane.proof, lane.gappa) +
         fmt::format("  {:<16} {}{}\n", "kept in", lane.directory.string(),
                     lane.reused == 0 ? "" : fmt::format("; {} proven before", lane.reused));
}

nlohmann::ordered_json to_json(const ProvenLane& lane) {
  if (!lane.error.empty()) return {{"format", lane.format}, {"error", lane.error}};
  nlohmann::ordered_json report = proof::to_json(lane.proof, lane.gappa);
  report["format"] = lane.format;
  report["directory"] = lane.directory.string();
  report["reused"] = lane.reused;
  return report;
}

QuickProof prove_quickly(const std::filesystem::path& scene, const model::Lane& lane) {
  proof::QuickProver prover(quick_seconds);
  QuickProof quick{proof::prove_lane(lane, std::ref(prover), proof::Effort::operations),
                   prover.gappa().value_or("")};
  if (!quick.proof.refused()) return quick;
  value_or_exit<model::Done>(
      model::Error{.file = scene.string(),
                   .field = "reduced.bound",
                   .message = quick.proof.verdict(),
                   .received = "a certified bound that the machine check refuses",
                   .accepted = "reduced.bound = \"profiled\"; `mixcmp check --prove` keeps the "
                               "scripts; --no-prove trusts docs/error_bounds.md alone"});
  throw Exit{1};
}

}  // namespace mixcmp::cli

#include "generator/faces/cli/prove.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <variant>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/present/report/json_text.hpp"
#include "generator/present/report/proof_report.hpp"
#include "model/judge/proof/gappa.hpp"
#include "model/judge/proof/provers.hpp"
#include "model/plan/profile/profiled_error.hpp"

namespace mixcmp::cli {
namespace {

/// Time limit for all scripts of a quick proof together; a script takes some 10 ms.
constexpr double quick_seconds = 5;

/// The scene with one kind of lane, that of [reduced], in the given precision.
Result<scene::Scene> with_precision(const scene::Scene& scene, int precision) {
  scene::Scene one_kind = scene.with_one_kind();
  if (scene.reduced.fixed_point) {
    const settings::Limits limits = settings::lane_fixed_bits(scene.reference.format);
    FixedPoint& format = *one_kind.reduced.fixed_point;
    format.bits = precision;
    if (allow(limits, format)) return one_kind;
    return Error{.field = "--precisions",
                 .message = "no lane in fixed point has that many bits",
                 .received = std::to_string(precision),
                 .accepted = fmt::format("{}{}", to_string(limits),
                                         format.guard_digits == 0 ? "" : " with guard digits")};
  }
  const FloatFormat& known = scene.reduced.format.value_or(scene.reference.format);
  MIXCMP_TRY(format, FloatFormat::make(precision, known.exponent_bits()));
  one_kind.reduced.format = format;
  return one_kind;
}

/// A lane to prove, or why there is none.
struct LaneCandidate {
  std::string name;
  Result<design::Lane> lane;
};

/// One lane of each kind, or why there is none. A proof does not depend on the number of lanes or
/// on the engine around them.
std::vector<LaneCandidate> candidates(scene::Scene scene, const data::Comparisons* data) {
  scene.system.lanes = scene.system.lanes.value_or(1);
  scene.system.references = scene.system.references.value_or(1);
  scene.system.engine = {};
  const auto design = design::make_design(scene, data, profile::profile_error);
  std::vector<LaneCandidate> found;
  if (!design.ok()) {
    for (const scene::LaneGroupSpec& group : scene.lane_groups()) {
      found.push_back({group.reduced.format_name(),
                       design::design_lane(scene, group.reduced, data, profile::profile_error)});
    }
    return found;
  }
  for (const design::NamedLane& named : named_lanes(*design)) {
    const auto same = [&](const LaneCandidate& earlier) { return earlier.name == named.name; };
    const bool known = std::any_of(found.begin(), found.end(), same);
    if (!known) found.push_back({named.name, named.lane});
  }
  return found;
}

/// Ends the program if Gappa is there and fails; where it is missing, scripts are left unchecked.
void end_if_broken(const Result<std::string>& gappa) {
  if (!gappa.ok() && gappa.error().kind != ErrorKind::missing_tool) fail(gappa.error());
}

/// The version of a tool; empty where the tool is missing.
std::string version_text(const Result<std::string>& version) {
  return version.ok() ? *version : "";
}

ProvenLane prove_lane(const scene::Scene& scene, const std::string& name, const design::Lane& lane,
                      const ProveOptions& options,
                      const std::vector<std::filesystem::path>& inputs) {
  ProvenLane result{.format = design::format_name(lane)};
  const std::string stem = fmt::format("{}_{}", scene.name, name);
  result.directory =
      options.directory.empty() ? std::filesystem::path(stem + "_proof") : options.directory;
  value_or_exit(check_outputs({result.directory / (stem + ".json")}, inputs));
  proof::ProofDirectory directory = value_or_exit(
      proof::ProofDirectory::open(result.directory, options.seconds_a_script, tell_waiting));
  end_if_broken(directory.gappa());
  show_progress("Gappa checks the error bound of " + result.format);
  result.proof = std::visit(
      [&](const auto& l) {
        return proof::prove_lane(l, std::ref(directory), proof::Effort::whole);
      },
      lane);
  show_progress("");
  if (directory.failure()) fail(*directory.failure());
  if (directory.broken()) fail(*directory.broken());
  result.gappa = version_text(directory.gappa());
  result.reused = directory.reused();
  const nlohmann::ordered_json report = report::to_json(result.proof, result.gappa);
  value_or_exit(directory.write_report(stem + ".json", report::json_text(report)));
  return result;
}

}  // namespace

void add_prove_options(const Verb& verb, ProveOptions& options) {
  const Option prove = verb.flag("--prove", options.prove,
                                 "have Gappa prove the error bound; exit code 2 where it refuses");
  verb.option("--proof-dir", options.directory,
              "where scripts, certificates and verdicts are kept (default: NAME_LANE_proof)")
      .needs(prove);
  verb.option("--precisions", options.precisions,
              "prove lanes of these precisions instead of the scene's: 4,8,17")
      .separated_by(',')
      .check(within(settings::limits::lane_precision))
      .needs(prove);
  verb.option("--proof-seconds", options.seconds_a_script,
              "for each script, 1e-6..1e6 (default: 10)")
      .check(between(1e-6, 1e6, "S"))
      .needs(prove);
}

std::vector<ProvenLane> prove(const LoadedScene& loaded, const ProveOptions& options,
                              const std::vector<std::filesystem::path>& inputs) {
  std::vector<scene::Scene> scenes;
  for (const int precision : options.precisions) {
    const int most = loaded.scene.reference.format.precision();
    if (precision > most) {
      fail({.field = "--precisions",
            .message = "a lane has no more digits than the reference",
            .received = std::to_string(precision),
            .accepted = fmt::format("at most {}", most)});
    }
    scenes.push_back(value_or_exit(with_precision(loaded.scene, precision)));
  }
  if (scenes.empty()) scenes.push_back(loaded.scene);
  std::vector<ProvenLane> proven;
  std::set<std::string> known;  // a second tier and a reference are the same at each precision
  for (const scene::Scene& scene : scenes) {
    for (const auto& [name, lane] : candidates(scene, loaded.data ? &*loaded.data : nullptr)) {
      if (!known.insert(name).second) continue;
      if (lane.ok()) {
        proven.push_back(prove_lane(scene, name, *lane, options, inputs));
      } else {
        proven.push_back({.format = name, .error = lane.error().to_string()});
      }
    }
  }
  return proven;
}

std::string to_text(const ProvenLane& lane) {
  if (!lane.error.empty()) return fmt::format("no lane in {}: {}\n", lane.format, lane.error);
  return report::to_text(lane.proof, lane.gappa) +
         fmt::format("  {:<16} {}{}\n", "kept in", lane.directory.string(),
                     lane.reused == 0 ? "" : fmt::format("; {} proven before", lane.reused));
}

nlohmann::ordered_json to_json(const ProvenLane& lane) {
  if (!lane.error.empty()) return {{"format", lane.format}, {"error", lane.error}};
  nlohmann::ordered_json report = report::to_json(lane.proof, lane.gappa);
  report["format"] = lane.format;
  report["directory"] = lane.directory.string();
  report["reused"] = lane.reused;
  return report;
}

QuickProof prove_quickly(const std::filesystem::path& scene, const design::Lane& lane) {
  proof::QuickProver prover(quick_seconds);
  QuickProof quick;
  show_progress("Gappa checks the error bound");
  quick.proof = std::visit(
      [&](const auto& l) {
        return proof::prove_lane(l, std::ref(prover), proof::Effort::operations);
      },
      lane);
  show_progress("");
  quick.gappa = version_text(prover.gappa());
  if (!quick.proof.refused()) return quick;
  const bool is_fixed = std::holds_alternative<fixed::FixedLane>(lane);
  fail(Error{
      .file = scene.string(),
      .field = is_fixed ? "reduced.format" : "reduced.bound",
      .message = quick.proof.verdict(),
      .received = "a certified bound that the machine check refuses",
      .accepted = fmt::format("{}; `mixcmp check --prove` keeps the scripts; --no-prove "
                              "trusts only docs/{}.md",
                              is_fixed ? "a floating-point format" : "reduced.bound = \"profiled\"",
                              is_fixed ? "fixed_point" : "error_bounds"),
      .kind = ErrorKind::refuted});
}

}  // namespace mixcmp::cli

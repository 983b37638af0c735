#include "generator/tasks/generate.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/fit.hpp"
#include "generator/faces/cli/options.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/project.hpp"
#include "generator/faces/cli/prove.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/hardware/emit/system.hpp"
#include "generator/present/report/json_text.hpp"
#include "generator/present/report/proof_report.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::cli {
namespace {

struct GenerateOptions {
  SceneOptions scene;
  std::filesystem::path output;
  bool skip_proof = false;
  ProjectOptions project;
};

/// The proof of one group of lanes.
struct GroupProof {
  std::string name;
  QuickProof quick;
};

std::string_view certainty(bool certified) {
  return certified ? "certified" : "not certified";
}

std::string counted(int count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// "67 cycles"; for a folded reference "74 cycles, one comparison in 16".
std::string timing(const emit::SignatureReferences& group) {
  const std::string latency = fmt::format("{} cycles", group.latency_cycles);
  if (group.initiation_interval_cycles == 1) return latency;
  return fmt::format("{}, one comparison in {}", latency, group.initiation_interval_cycles);
}

/// "p_L = 8"; for lanes in lock step "p_L = 8 (in groups of 4)".
std::string lane_count(const emit::Signature& s) {
  const std::string lanes = fmt::format("p_L = {}", s.lanes);
  return s.lanes_per_group == 1 ? lanes
                                : fmt::format("{} (in groups of {})", lanes, s.lanes_per_group);
}

/// Prints lanes and references, in one line if there is one kind of each, else one line per kind.
void print_parts(const emit::Signature& s) {
  if (s.lane_groups.size() == 1 && s.reference_groups.size() <= 1) {
    const emit::SignatureLanes& lanes = s.lane_groups.front();
    const std::string reference =
        s.reference_groups.empty() ? ""
                                   : fmt::format(" in {} ({})", s.reference_groups.front().format,
                                                 timing(s.reference_groups.front()));
    return print(fmt::format("{}: {} in {} ({} cycles), p_H = {}{}, {}\n", s.top, lane_count(s),
                             lanes.format, lanes.latency_cycles, s.references, reference,
                             certainty(s.certified)));
  }
  const std::string reference =
      s.reference_groups.empty() ? "" : " in " + s.reference_groups.front().format;
  print(fmt::format("{}: {}, p_H = {}{}, {}\n", s.top, lane_count(s), s.references, reference,
                    certainty(s.certified)));
  for (const emit::SignatureLanes& group : s.lane_groups) {
    print(fmt::format("  {} in {}: {} cycles, inputs {}, multipliers {}; {}\n",
                      counted(group.count, "lane"), group.format, group.latency_cycles,
                      to_string(group.inputs), to_string(group.multipliers), group.decision));
  }
  for (const emit::SignatureReferences& group : s.reference_groups) {
    print(fmt::format("  {}: {}, multipliers {}\n", counted(group.count, "reference"),
                      timing(group), to_string(group.multipliers)));
  }
}

/// The words for the output of a pairwise engine and the number of its streams.
std::string what_leaves(const emit::SignatureEngine& engine) {
  const std::string pairs = fmt::format("pairs that are {}", fmt::join(engine.report, ", "));
  const std::string streams =
      engine.report_streams == 1 ? "" : fmt::format(" by {} streams", engine.report_streams);
  switch (engine.report_as) {
    case scene::ReportForm::pairs: return fmt::format("{} leave{}", pairs, streams);
    case scene::ReportForm::bitmap:
      return fmt::format("{} leave{} as flags of {}", pairs, streams, engine.report_lanes);
    case scene::ReportForm::count: return fmt::format("the number of {} leaves{}", pairs, streams);
  }
  MIXCMP_CHECK(!"a form of no enumerator");
}

void print_engine(const emit::Signature& signature) {
  if (!signature.engine) return;
  const emit::SignatureEngine& engine = *signature.engine;
  if (engine.kind == scene::EngineKind::arg_min) {
    print(fmt::format(
        "{}: {} candidates of {} bytes, rows of {} bytes, the least one's number leaves\n",
        engine.top, engine.capacity, engine.item_bytes, engine.row_bytes));
    return;
  }
  print(fmt::format("{}: up to {} items of {} bytes, {}\n", engine.top, engine.capacity,
                    engine.item_bytes, what_leaves(engine)));
  if (const auto& tier = signature.second_tier) {
    print(fmt::format("  second tier behind each group: a lane in {} ({} cycles)\n", tier->format,
                      tier->latency_cycles));
  }
}

void print_second_tier(const emit::Signature& signature) {
  if (!signature.second_tier || signature.engine) return;
  const emit::SignatureLanes& tier = *signature.second_tier;
  print(fmt::format("  second tier behind a crossbar: {} lane{} in {} ({} cycles)\n", tier.count,
                    tier.count == 1 ? "" : "s", tier.format, tier.latency_cycles));
}

/// A line for each simulator, "simulated: Verilator, 207046 comparisons, 164 recomputed, passed",
/// or "not simulated yet: COMMAND" if there is none.
std::string simulation_lines(const std::vector<emit::SignatureSimulation>& simulations,
                             const std::string& command) {
  if (simulations.empty()) return fmt::format("not simulated yet: {}\n", command);
  std::string text;
  for (const emit::SignatureSimulation& run : simulations) {
    text += fmt::format("simulated: {}, {} comparisons, {} recomputed, {}\n", run.simulator,
                        run.comparisons, run.recomputations, run.passed ? "passed" : "FAILED");
  }
  return text;
}

/// `verify`: the command that simulates the system.
void print_text(const emit::GeneratedSystem& system, const std::vector<GroupProof>& proofs,
                const std::string& verify, const std::filesystem::path& directory) {
  print_parts(system.signature);
  print_second_tier(system.signature);
  print_engine(system.signature);
  for (const std::string& note : system.notes) print(fmt::format("note: {}\n", note));
  for (const GroupProof& proof : proofs) {
    print(fmt::format("error bound{}: {}\n", proofs.size() == 1 ? "" : " of " + proof.name,
                      proof.quick.proof.verdict()));
  }
  print(simulation_lines(system.signature.simulations, verify));
  print(fmt::format("{} files in {}\n", system.files.size(), directory.string()));
}

void print_commands(const std::set<project::Tool>& tools, const std::string& top,
                    const std::filesystem::path& directory) {
  for (const project::Tool tool : tools) {
    print(fmt::format("  {}\n", project::start_command(tool, top, quoted(directory.string()))));
  }
}

void print_json(const emit::GeneratedSystem& system, const std::vector<GroupProof>& proofs,
                const std::filesystem::path& directory) {
  nlohmann::ordered_json report;
  report["directory"] = directory.string();
  report["signature"] = nlohmann::ordered_json::parse(emit::to_json(system.signature));
  report["notes"] = system.notes;
  for (const GroupProof& proof : proofs) {
    report["proof"].push_back(report::to_json(proof.quick.proof, proof.quick.gappa));
    report["proof"].back()["lanes"] = proof.name;
  }
  print(report::json_text(report));
}

/// Proves every kind of lane that claims a proof.
std::vector<GroupProof> prove_groups(const std::filesystem::path& scene,
                                     const design::Design& design) {
  std::vector<GroupProof> proofs;
  for (const design::NamedLane& named : named_lanes(design)) {
    if (!design::is_certified(named.lane)) continue;
    proofs.push_back({named.name, prove_quickly(scene, named.lane)});
  }
  return proofs;
}

void run(const GenerateOptions& options) {
  const LoadedScene loaded = value_or_exit(load(options.scene));
  value_or_exit(check_project(options.project, loaded));
  auto [design, system] = value_or_exit(
      with_shortcuts(tasks::generate(options.scene.request(), loaded), options.scene));
  add_project(system, options.project, loaded, design, command_line("generate", options.scene));
  if (auto note = fit_note(loaded, design)) system.notes.push_back(std::move(*note));
  std::vector<GroupProof> proofs;
  if (!options.skip_proof) proofs = prove_groups(options.scene.scene, design);
  const std::filesystem::path directory =
      options.output.empty() ? std::filesystem::path(system.signature.top) : options.output;
  value_or_exit(check_replaced_folder(directory, inputs_of(options.scene, loaded.scene)));
  value_or_exit(emit::write_system(system, directory));
  if (options.scene.json) return print_json(system, proofs, directory);
  print_text(system, proofs, runnable_command("verify", options.scene).text(), directory);
  print_commands(options.project.tools, system.signature.top, directory);
}

}  // namespace

void add_generate(CLI::App& app) {
  const Verb verb(app, "generate", "write the Verilog of a system");
  auto options = std::make_shared<GenerateOptions>();
  add_scene_options(verb, options->scene);
  verb.option("-o,--output", options->output, "directory to write (default: the top's name)");
  add_project_options(verb, options->project);
  verb.flag("--no-prove", options->skip_proof,
            "do not have Gappa check the error bound's lemmas first");
  verb.when_chosen([options] { run(*options); });
}

}  // namespace mixcmp::cli

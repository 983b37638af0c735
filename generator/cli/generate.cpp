#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "generator/cli/exit.hpp"
#include "generator/cli/options.hpp"
#include "generator/cli/prove.hpp"
#include "generator/cli/verbs.hpp"
#include "generator/emit/system.hpp"
#include "model/proof/report.hpp"

namespace mixcmp::cli {
namespace {

struct GenerateOptions {
  SceneOptions scene;
  std::filesystem::path output;
  bool skip_proof = false;
};

/// None for a bound that claims no proof, and where the user wants none.
using MaybeProof = std::optional<QuickProof>;

void print_text(const gen::GeneratedSystem& system, const MaybeProof& proof,
                const std::filesystem::path& directory) {
  const gen::Signature& s = system.signature;
  fmt::print("{}: p_L = {} in {} ({} cycles), p_H = {} in {} ({} cycles), {}\n", s.top, s.lanes,
             s.lane_format.name(), s.lane_latency_cycles, s.references, s.reference_format.name(),
             s.reference_latency_cycles, s.certified ? "certified" : "not certified");
  for (const std::string& note : system.notes) fmt::print("note: {}\n", note);
  if (proof) fmt::print("error bound: {}\n", proof->proof.verdict());
  fmt::print("{} files in {}\n", system.files.size(), directory.string());
}

void print_json(const gen::GeneratedSystem& system, const MaybeProof& proof,
                const std::filesystem::path& directory) {
  nlohmann::ordered_json report;
  report["directory"] = directory.string();
  report["signature"] = nlohmann::ordered_json::parse(gen::to_json(system.signature));
  report["notes"] = system.notes;
  if (proof) report["proof"] = model::proof::to_json(proof->proof, proof->gappa);
  fmt::print("{}\n", report.dump(2));
}

void run(const GenerateOptions& options) {
  const LoadedScene loaded = value_or_exit(load(options.scene));
  const model::Design design =
      value_or_exit(make_design(loaded.scene, loaded.data ? &*loaded.data : nullptr));
  const gen::GeneratedSystem system =
      value_or_exit(gen::generate_system(design, command_line("generate", options.scene)));
  MaybeProof proof;
  if (design.lane.certified() && !options.skip_proof) {
    proof = prove_quickly(options.scene.scene, design.lane);
  }
  const std::filesystem::path directory =
      options.output.empty() ? std::filesystem::path(system.signature.top) : options.output;
  value_or_exit(gen::write_system(system, directory));
  options.scene.json ? print_json(system, proof, directory) : print_text(system, proof, directory);
}

}  // namespace

void add_generate(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("generate", "write the Verilog of a system");
  auto options = std::make_shared<GenerateOptions>();
  add_scene_options(*verb, options->scene);
  verb->add_option("-o,--output", options->output, "directory to write (default: the top's name)");
  verb->add_flag("--no-prove", options->skip_proof,
                 "do not have Gappa check the error bound's lemmas first");
  verb->callback([options] { run(*options); });
}

}  // namespace mixcmp::cli

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "generator/cli/costs.hpp"
#include "generator/cli/exit.hpp"
#include "generator/cli/options.hpp"
#include "generator/cli/prove.hpp"
#include "generator/cli/verbs.hpp"
#include "generator/emit/system.hpp"
#include "model/scene/summary.hpp"

namespace mixcmp::cli {
namespace {

/// What `generate` would write, or why it would refuse.
struct Outlook {
  model::Result<gen::GeneratedSystem> system;
};

Outlook outlook(const LoadedScene& loaded) {
  const auto design = make_design(loaded.scene, loaded.data ? &*loaded.data : nullptr);
  if (!design.ok()) return {design.error()};
  return {gen::generate_system(*design, "")};
}

void print_text(const Outlook& outlook) {
  const auto line = [](const char* name, const std::string& text) {
    fmt::print("  {:<18} {}\n", name, text);
  };
  fmt::print("what generate writes\n");
  if (!outlook.system.ok()) return line("nothing", outlook.system.error().to_string());
  const gen::Signature& signature = outlook.system->signature;
  line("top", signature.top);
  const bool one_kind = signature.lane_groups.size() == 1;
  for (const gen::SignatureLanes& group : signature.lane_groups) {
    const std::string kind =
        one_kind
            ? ""
            : fmt::format("{} in {}, inputs {}, multipliers {}: ", group.count, group.format.name(),
                          to_string(group.inputs), to_string(group.multipliers));
    line(one_kind ? "lane" : "lanes", fmt::format("{}{} cycles", kind, group.latency_cycles));
    line("decision", group.decision);
  }
  for (const gen::SignatureReferences& group : signature.reference_groups) {
    const std::string kind =
        signature.reference_groups.size() == 1
            ? ""
            : fmt::format("{}, multipliers {}: ", group.count, to_string(group.multipliers));
    line(kind.empty() ? "reference" : "references",
         fmt::format("{}{} cycles", kind, group.latency_cycles));
  }
}

nlohmann::json to_json(const Outlook& outlook) {
  if (!outlook.system.ok()) {
    const model::Error& error = outlook.system.error();
    return {{"error",
             {{"field", error.field},
              {"message", error.message},
              {"received", error.received},
              {"accepted", error.accepted}}}};
  }
  const auto signature = nlohmann::json::parse(gen::to_json(outlook.system->signature));
  return {{"top", signature["top"]},
          {"lane_groups", signature["lane_groups"]},
          {"reference_groups", signature["reference_groups"]}};
}

struct CheckOptions {
  SceneOptions scene;
  ProveOptions prove;
  bool costs = false;
};

void print_text(const std::vector<ProvenLane>& proven) {
  for (const ProvenLane& lane : proven) fmt::print("{}", to_text(lane));
}

nlohmann::json to_json(const std::vector<ProvenLane>& proven) {
  nlohmann::json report = nlohmann::json::array();
  for (const ProvenLane& lane : proven) report.push_back(nlohmann::json(to_json(lane)));
  return report;
}

bool any_refused(const std::vector<ProvenLane>& proven) {
  return std::any_of(proven.begin(), proven.end(),
                     [](const ProvenLane& lane) { return lane.proof.refused(); });
}

void run(const CheckOptions& options) {
  const LoadedScene loaded = value_or_exit(load(options.scene));
  const model::Summary summary =
      model::summarise(loaded.scene, loaded.data ? &*loaded.data : nullptr);
  const Outlook generated = outlook(loaded);
  std::vector<ProvenLane> proven;
  if (options.prove.prove) proven = prove(loaded, options.prove);
  std::optional<BoundCosts> costs;
  if (options.costs) costs = measure_costs(loaded);
  if (options.scene.json) {
    nlohmann::json report = to_json(summary);
    report["generate"] = to_json(generated);
    if (options.prove.prove) report["proof"] = to_json(proven);
    if (costs) report["costs"] = to_json(*costs);
    fmt::print("{}\n", report.dump(2));
  } else {
    fmt::print("{}", to_text(summary));
    print_text(generated);
    if (costs) fmt::print("{}", to_text(*costs));
    print_text(proven);
  }
  if (any_refused(proven)) throw Exit{2};
}

}  // namespace

void add_check(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("check", "parse a scene; say what was understood and what it requires");
  auto options = std::make_shared<CheckOptions>();
  add_scene_options(*verb, options->scene);
  add_prove_options(*verb, options->prove);
  verb->add_flag("--costs", options->costs,
                 "recomputation rate and area of every error bound (Yosys maps each lane)");
  verb->callback([options] { run(*options); });
}

}  // namespace mixcmp::cli

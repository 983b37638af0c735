#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "generator/cli/exit.hpp"
#include "generator/cli/options.hpp"
#include "generator/cli/verbs.hpp"
#include "generator/emit/system.hpp"
#include "model/scene/summary.hpp"

namespace mixcmp::cli {
namespace {

/// What `generate` would write, or why it would refuse.
struct Outlook {
  std::string decision;
  model::Result<gen::GeneratedSystem> system;
};

Outlook outlook(const LoadedScene& loaded) {
  const auto design = make_design(loaded.scene, loaded.data ? &*loaded.data : nullptr);
  if (!design.ok()) return {"", design.error()};
  return {describe_decision(design->lane), gen::generate_system(*design, "")};
}

void print_text(const Outlook& outlook) {
  const auto line = [](const char* name, const std::string& text) {
    fmt::print("  {:<18} {}\n", name, text);
  };
  fmt::print("what generate writes\n");
  if (!outlook.system.ok()) return line("nothing", outlook.system.error().to_string());
  const gen::Signature& signature = outlook.system->signature;
  line("top", signature.top);
  line("lane", fmt::format("{} cycles", signature.lane_latency_cycles));
  line("decision", outlook.decision);
  if (signature.references == 0) return;
  line("reference", fmt::format("{} cycles", signature.reference_latency_cycles));
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
  const gen::Signature& signature = outlook.system->signature;
  return {{"top", signature.top},
          {"decision", outlook.decision},
          {"lane_latency_cycles", signature.lane_latency_cycles},
          {"reference_latency_cycles", signature.reference_latency_cycles}};
}

void run(const SceneOptions& options) {
  const LoadedScene loaded = value_or_exit(load(options));
  const model::Summary summary =
      model::summarise(loaded.scene, loaded.data ? &*loaded.data : nullptr);
  const Outlook generated = outlook(loaded);
  if (options.json) {
    nlohmann::json report = to_json(summary);
    report["generate"] = to_json(generated);
    fmt::print("{}\n", report.dump(2));
  } else {
    fmt::print("{}", to_text(summary));
    print_text(generated);
  }
}

}  // namespace

void add_check(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("check", "parse a scene; say what was understood and what it requires");
  auto options = std::make_shared<SceneOptions>();
  add_scene_options(*verb, *options);
  verb->callback([options] { run(*options); });
}

}  // namespace mixcmp::cli

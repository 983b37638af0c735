#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "generator/faces/cli/costs.hpp"
#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/fit.hpp"
#include "generator/faces/cli/options.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/prove.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/hardware/emit/system.hpp"
#include "generator/present/report/function_report.hpp"
#include "generator/present/report/json_text.hpp"
#include "generator/present/report/summary_report.hpp"
#include "model/plan/profile/variant_check.hpp"

namespace mixcmp::cli {
namespace {

/// The system that `generate` would write, or why it would refuse.
struct Outlook {
  Result<emit::GeneratedSystem> system;
  std::optional<design::Design> design = {};  ///< there is one if there is a system
};

const fixed::FixedLane* fixed_lane(const design::Lane& lane) {
  return std::get_if<fixed::FixedLane>(&lane);
}

Outlook outlook(const SceneOptions& options, const LoadedScene& loaded) {
  const auto design = design_of(options, loaded);
  if (!design.ok()) return {design.error()};
  auto system = emit::generate_system(*design, "");
  if (!system.ok()) return {system.error()};
  emit::GeneratedSystem generated = std::move(system).value();
  if (auto note = fit_note(loaded, *design)) generated.notes.push_back(std::move(*note));
  return {std::move(generated), *design};
}

/// The outermost module.
const std::string& top_of(const emit::Signature& signature) {
  return signature.engine ? signature.engine->top : signature.top;
}

bool has_requests_of_operands(const emit::Signature& signature) {
  return signature.operands == scene::OperandStore::carried && signature.references > 0;
}

/// The functions of a lane or a reference, which a line above has named; null: not in fixed point.
void print_functions(const fixed::FixedLane* lane) {
  if (lane == nullptr) return;
  for (const auto& [function, words] : report::function_lines(*lane)) {
    print(fmt::format("  {:<18} {} {}\n", "", function, words));
  }
}

void print_text(const Outlook& outlook) {
  const auto line = [](const char* name, const std::string& text) {
    print(fmt::format("  {:<18} {}\n", name, text));
  };
  print("what generate writes\n");
  if (!outlook.system.ok()) return line("nothing", outlook.system.error().to_string());
  const emit::Signature& signature = outlook.system->signature;
  line("top", top_of(signature));
  const bool one_kind = signature.lane_groups.size() == 1;
  for (std::size_t k = 0; k < signature.lane_groups.size(); ++k) {
    const emit::SignatureLanes& group = signature.lane_groups[k];
    const std::string kind =
        one_kind ? ""
                 : fmt::format("{} in {}, inputs {}, multipliers {}: ", group.count, group.format,
                               to_string(group.inputs), to_string(group.multipliers));
    line(one_kind ? "lane" : "lanes", fmt::format("{}{} cycles", kind, group.latency_cycles));
    line("decision", group.decision);
    print_functions(fixed_lane(outlook.design->lanes[k].lane));
  }
  if (const auto& tier = signature.second_tier) {
    line("second tier",
         fmt::format("{} x {}, {} cycles", tier->count, tier->format, tier->latency_cycles));
    line("decision", tier->decision);
    print_functions(fixed_lane(outlook.design->second_tier->lane));
  }
  for (const emit::SignatureReferences& group : signature.reference_groups) {
    const std::string kind =
        signature.reference_groups.size() == 1
            ? ""
            : fmt::format("{}, multipliers {}: ", group.count, to_string(group.multipliers));
    line(kind.empty() ? "reference" : "references",
         fmt::format("{}{} cycles", kind, group.latency_cycles));
  }
  if (!signature.reference_groups.empty()) print_functions(outlook.design->requested_reference());
  if (has_requests_of_operands(signature)) {
    line("request_beats", fmt::format("{}", signature.request_beats));
  }
  for (const std::string& note : outlook.system->notes) line("note", note);
}

nlohmann::json to_json(const Outlook& outlook) {
  if (!outlook.system.ok()) return {{"error", report::to_json(outlook.system.error())}};
  auto signature = nlohmann::json::parse(emit::to_json(outlook.system->signature));
  const auto add_functions = [](nlohmann::json& group, const fixed::FixedLane* lane) {
    if (lane != nullptr) group["functions"] = report::functions_json(*lane);
  };
  for (std::size_t k = 0; k < signature["lane_groups"].size(); ++k) {
    add_functions(signature["lane_groups"][k], fixed_lane(outlook.design->lanes[k].lane));
  }
  if (const auto& tier = outlook.design->second_tier) {
    add_functions(signature["second_tier"], fixed_lane(tier->lane));
  }
  for (auto& group : signature["reference_groups"]) {
    add_functions(group, outlook.design->requested_reference());
  }
  return {{"top", top_of(outlook.system->signature)},
          {"request_beats", signature["request_beats"]},
          {"lane_groups", signature["lane_groups"]},
          {"second_tier", signature.value("second_tier", nlohmann::json())},
          {"reference_groups", signature["reference_groups"]},
          {"notes", outlook.system->notes}};
}

struct CheckOptions {
  SceneOptions scene;
  ProveOptions prove;
  bool costs = false;
};

void print_text(const std::vector<ProvenLane>& proven) {
  for (const ProvenLane& lane : proven) print(to_text(lane));
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

/// Compares each of the scene's variants with the scene on its data, unless it was loaded as one.
std::vector<profile::VariantCheck> check_variants(const SceneOptions& options,
                                                  const LoadedScene& loaded) {
  std::vector<profile::VariantCheck> checks;
  const auto formulations = value_or_exit(tasks::load_formulations(options.request(), loaded));
  for (std::size_t k = 1; k < formulations.size() && loaded.data; ++k) {
    const scene::Scene& variant = formulations[k].scene;
    checks.push_back(profile::check_variant(
        loaded.scene, variant, *loaded.data, profile::checked_comparisons, [&](double share) {
          show_progress(fmt::format("variant {}: {:.0f} %", variant.variant, share * 100));
        }));
  }
  show_progress("");
  return checks;
}

void print_text(const std::vector<profile::VariantCheck>& checks) {
  if (!checks.empty()) print("variants\n");
  for (const profile::VariantCheck& check : checks) {
    std::string verdict = check.undetermined == 0
                              ? "decides all of them alike"
                              : fmt::format("decides alike all but {} that {} bits do not tell",
                                            check.undetermined, profile::checked_bits);
    if (const auto& first = check.first_difference) {
      verdict = fmt::format("decides {} of them differently, the first number {}: {}, not {}",
                            check.differences, first->index, to_string(first->variant),
                            to_string(first->given));
    }
    if (check.out_of_range == check.comparisons)
      verdict = "none is within the ranges of the inputs";
    print(fmt::format("  {:<18} {} comparisons: {}\n", check.variant,
                      check.comparisons - check.out_of_range, verdict));
    if (check.reference_differences == 0) continue;
    print(fmt::format("  {:<18} rounded in the reference format, {} differ\n", "",
                      check.reference_differences));
  }
}

nlohmann::json to_json(const std::vector<profile::VariantCheck>& checks) {
  nlohmann::json report = nlohmann::json::array();
  for (const profile::VariantCheck& check : checks) {
    report.push_back({{"name", check.variant},
                      {"comparisons", check.comparisons - check.out_of_range},
                      {"differences", check.differences},
                      {"untold", check.undetermined},
                      {"reference_differences", check.reference_differences}});
    if (const auto& first = check.first_difference) {
      report.back()["first_difference"] = {{"index", first->index},
                                           {"given", to_string(first->given)},
                                           {"variant", to_string(first->variant)}};
    }
  }
  return report;
}

bool any_differs(const std::vector<profile::VariantCheck>& checks) {
  return std::any_of(checks.begin(), checks.end(), [](const profile::VariantCheck& check) {
    return check.first_difference.has_value();
  });
}

/// Ends the program if a proof was asked for of a lane that does not exist: a mistake of the user.
void end_without_lanes(const std::vector<ProvenLane>& proven) {
  bool all_exist = true;
  for (const ProvenLane& lane : proven) {
    if (lane.error.empty()) continue;
    tell(fmt::format("--prove, {}: there is no such lane: {}", lane.format, lane.error));
    all_exist = false;
  }
  if (!all_exist) throw Exit(ExitCode::mistake);
}

/// Why a required part of a lane's proof is missing; empty if none is.
std::string unproven_part(const ProvenLane& lane) {
  for (const proof::Finding& finding : lane.proof.findings) {
    const bool open = finding.outcome == proof::Outcome::out_of_time ||
                      finding.outcome == proof::Outcome::unchecked;
    if (open && !finding.optional) return fmt::format("{}: {}", finding.what, finding.detail);
  }
  return "";
}

/// The parts of the report that were asked for and are missing, each with its reason.
std::vector<std::string> not_done(const CheckOptions& options,
                                  const std::vector<ProvenLane>& proven,
                                  const std::optional<BoundCosts>& costs) {
  std::vector<std::string> parts;
  for (const ProvenLane& lane : proven) {
    const std::string why = unproven_part(lane);
    if (!why.empty()) parts.push_back(fmt::format("--prove, {}: {}", lane.format, why));
  }
  if (options.prove.prove && proven.empty()) parts.emplace_back("--prove: the scene has no lane");
  for (const BoundCost& cost : costs ? costs->bounds : std::vector<BoundCost>()) {
    if (!cost.why_no_area) continue;
    parts.push_back(
        fmt::format("--costs, areas, {}: {}", cost.name, cost.why_no_area->to_string()));
  }
  if (costs && !costs->why_no_rate.empty())
    parts.push_back("--costs, rates: " + costs->why_no_rate);
  return parts;
}

/// Ends with the first area that a tool failed to measure; one that is not installed is no failure.
void end_if_broken(const BoundCosts& costs) {
  for (const BoundCost& cost : costs.bounds) {
    if (!cost.why_no_area || cost.why_no_area->kind != ErrorKind::mistake) continue;
    tell(cost.why_no_area->to_string());
    throw Exit(ExitCode::mistake);
  }
}

void run(const CheckOptions& options) {
  const LoadedScene loaded = value_or_exit(load(options.scene));
  const scene::Summary summary =
      scene::summarise(loaded.scene, loaded.data ? &*loaded.data : nullptr);
  const Outlook generated = outlook(options.scene, loaded);
  const std::vector<profile::VariantCheck> variants = check_variants(options.scene, loaded);
  std::vector<ProvenLane> proven;
  if (options.prove.prove) {
    proven = prove(loaded, options.prove, inputs_of(options.scene, loaded.scene));
  }
  std::optional<BoundCosts> costs;
  if (options.costs) {
    auto measured = measure_costs(loaded);
    if (!measured.ok()) fail(as_user_error(measured.error(), options.scene));
    costs = std::move(measured).value();
  }
  if (options.scene.json) {
    nlohmann::json report = report::to_json(summary);
    report["generate"] = to_json(generated);
    if (!variants.empty()) report["variants"] = to_json(variants);
    if (options.prove.prove) report["proof"] = to_json(proven);
    if (costs) report["costs"] = to_json(*costs);
    print(report::json_text(report));
  } else {
    print(report::to_text(summary));
    print_text(generated);
    print_text(variants);
    if (variants.empty() && !loaded.scene.variants.empty() && !loaded.data) {
      print(fmt::format("variants\n  {:<18} the scene has no data to compare them on\n",
                        "not compared"));
    }
    if (costs) print(to_text(*costs));
    print_text(proven);
  }
  end_without_lanes(proven);
  if (costs) end_if_broken(*costs);
  if (any_refused(proven) || any_differs(variants)) throw Exit(ExitCode::refuted);
  end_if_incomplete(not_done(options, proven, costs));
}

}  // namespace

void add_check(CLI::App& app) {
  const Verb verb(app, "check", "parse a scene; say what was understood and what it requires");
  auto options = std::make_shared<CheckOptions>();
  add_scene_options(verb, options->scene);
  add_prove_options(verb, options->prove);
  verb.flag("--costs", options->costs,
            "recomputation rate and area of every error bound (Yosys maps each lane)");
  verb.when_chosen([options] { run(*options); });
}

}  // namespace mixcmp::cli

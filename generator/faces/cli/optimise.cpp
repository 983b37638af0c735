#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "generator/faces/cli/characterise_table.hpp"
#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/planning.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/present/report/json_text.hpp"
#include "generator/present/report/plan_report.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/output_file.hpp"
#include "model/plan/optimise/plan.hpp"
#include "model/plan/optimise/plan_summary.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;

struct OptimiseCommand {
  PlanningOptions planning;
  fs::path rates;
  fs::path plan;
  fs::path csv;
  fs::path lp;
  bool no_characterise = false;
};

/// Refuses rates of another reference. Notes that the rates are of other data, which may be
/// intended.
void check_rates(const optimise::Rates& rates, const fs::path& file, const LoadedScene& loaded) {
  if (!rates.origin()) return;
  const optimise::Rates::Origin& origin = *rates.origin();
  const int precision = loaded.scene.reference.format.precision();
  if (origin.reference_precision != precision) {
    fail({.file = file.string(),
          .field = "reference",
          .message = "these rates are of another reference",
          .received = fmt::format("a reference of {} digits", origin.reference_precision),
          .accepted = fmt::format("the scene's, of {}", precision)});
  }
  if (loaded.data && loaded.data->size() != origin.comparisons) {
    tell_note(fmt::format("{}: counted on {} comparisons; the scene's data have {}", file.string(),
                          origin.comparisons, loaded.data->size()));
  }
}

/// The rates that were counted to choose a quick table, one for each formulation; none where no
/// table was made.
using CountedRates = std::vector<std::optional<optimise::Rates>>;

optimise::Rates rates_for(const OptimiseCommand& command, const LoadedScene& loaded,
                          const measured::Characterisation& table,
                          const std::optional<optimise::Rates>& counted) {
  if (!command.rates.empty()) {
    optimise::Rates rates = value_or_exit(optimise::Rates::read(command.rates));
    check_rates(rates, command.rates, loaded);
    return rates;
  }
  if (counted) return *counted;
  return optimise::Rates::of(value_or_exit(
      measure_rates(loaded, optimise::inputs_of_lanes(table), command.planning.choice)));
}

std::string command_of(const OptimiseCommand& command) {
  return planning_command_line("optimise", command.planning)
      .add("--rates", command.rates.string())
      .text();
}

/// The name that distinguishes this formulation from the scene's others.
std::string name_of(const scene::Scene& scene) {
  std::string name = scene.variant.empty() ? "[comparison]" : "variant " + scene.variant;
  if (scene.second_tier) name += ", second tier " + scene.second_tier->format_name();
  return scene.leaves_out_second_tier ? name + ", one tier" : name;
}

/// The settings that make this formulation of the scene as the user gave it.
std::vector<std::string> settings_of(const scene::Scene& formulation, const SceneOptions& given) {
  std::vector<std::string> settings;
  if (!formulation.variant.empty() && !is_set(given, "comparison.variant")) {
    settings.push_back("comparison.variant=" + formulation.variant);
  }
  if (formulation.leaves_out_second_tier) settings.push_back("second_tier.format=none");
  return settings;
}

/// The plans of one formulation of the comparison.
struct Candidate {
  Planning known;
  optimise::Optimisation found;

  double throughput_per_s() const {
    return found.best() == nullptr ? 0 : found.best()->throughput_per_s();
  }
  std::string name() const { return name_of(known.scene); }
};

/// The scene as it is and, if it names no variant, its variants. A table or rates given by hand
/// belong to one formulation; then there is only the scene.
std::vector<LoadedScene> variants_of(const OptimiseCommand& command, const LoadedScene& loaded) {
  const bool by_hand = !command.planning.table.empty() || !command.rates.empty();
  if (!by_hand)
    return value_or_exit(tasks::load_formulations(command.planning.scene.request(), loaded));
  if (loaded.scene.variant.empty() && !loaded.scene.variants.empty()) {
    tell_note("--table and --rates are of [comparison]; variants left out");
  }
  return {loaded};
}

/// Whether engines are also planned without the second tier. They are, unless the user names the
/// tier, or a table, which belongs to one of the two.
bool weighs_second_tier(const OptimiseCommand& command) {
  return command.planning.table.empty() && !is_set(command.planning.scene, "second_tier.format");
}

/// The variants. Each that has a second tier is also listed without it.
std::vector<LoadedScene> formulations_of(const OptimiseCommand& command,
                                         const LoadedScene& loaded) {
  std::vector<LoadedScene> formulations = variants_of(command, loaded);
  if (!weighs_second_tier(command)) return formulations;
  for (std::size_t k = 0, given = formulations.size(); k < given; ++k) {
    if (!formulations[k].scene.second_tier) continue;
    SceneOptions one_tier = command.planning.scene;
    for (const std::string& setting : settings_of(formulations[k].scene, one_tier)) {
      one_tier.settings.push_back(setting);
    }
    one_tier.settings.emplace_back("second_tier.format=none");
    formulations.push_back(
        {value_or_exit(scene::load_scene(one_tier.scene, one_tier.settings)), loaded.data});
  }
  return formulations;
}

/// The quick measurement of components that plans of this formulation may use: only areas.
CharacteriseCommand quick_characterisation(const PlanningOptions& planning,
                                           const scene::Scene& formulation) {
  const optimise::OptimiseOptions& choice = planning.choice;
  const optimise::OptimiseOptions usual;
  CharacteriseCommand quick{.scene = planning.scene, .quick = true, .area_only = true};
  for (const std::string& setting : settings_of(formulation, planning.scene)) {
    quick.scene.settings.push_back(setting);
  }
  const int most = settings::lane_precisions(formulation.reference.format).most;
  if (choice.first_precision != usual.first_precision || choice.last_precision < most) {
    quick.precisions =
        fmt::format("{}-{}", choice.first_precision, std::min(choice.last_precision, most));
  }
  const auto take = [](const auto& chosen, std::string& words) {
    if (!chosen.empty()) words = text_of(chosen);
  };
  take(choice.bounds, quick.bounds);
  take(choice.inputs, quick.inputs);
  take(choice.multipliers, quick.multipliers);
  return quick;
}

/// Whether each formulation gets a quick table: none has one yet.
bool lacks_tables(const OptimiseCommand& command, const std::vector<LoadedScene>& formulations) {
  const PlanningOptions& planning = command.planning;
  if (command.no_characterise || !planning.table.empty()) return false;
  return std::none_of(formulations.begin(), formulations.end(), [&](const LoadedScene& each) {
    return path_exists(table_of(planning, each.scene));
  });
}

/// Measures promising components where no formulation has a table yet. Returns the rates that were
/// counted to choose them.
CountedRates make_missing_tables(const OptimiseCommand& command,
                                 const std::vector<LoadedScene>& formulations) {
  CountedRates counted(formulations.size());
  if (!lacks_tables(command, formulations)) return counted;
  for (std::size_t k = 0; k < formulations.size(); ++k) {
    const LoadedScene& each = formulations[k];
    tell_note(
        fmt::format("no areas of {} yet: measuring some into {}. An interrupted run goes on "
                    "when it is given again; --no-characterise measures nothing",
                    name_of(each.scene), table_of(command.planning, each.scene).string()));
    const CharacteriseCommand quick = quick_characterisation(command.planning, each.scene);
    counted[k] = rates_of_choice(quick, each);
    end_if_unfinished(measure_table(quick, each, &*counted[k]));
  }
  return counted;
}

Result<Candidate> find_plans(const OptimiseCommand& command, const LoadedScene& loaded,
                             const std::optional<optimise::Rates>& counted) {
  const PlanningOptions& planning = command.planning;
  const data::Comparisons* data = loaded.data ? &*loaded.data : nullptr;
  MIXCMP_TRY(known, load_planning(planning, loaded.scene, data));
  MIXCMP_TRY(found,
             optimise::optimise(known.scene, known.device, known.table,
                                rates_for(command, loaded, known.table, counted), planning.choice));
  return Candidate{std::move(known), std::move(found)};
}

/// The plans of all formulations. A formulation that cannot be planned is left out with a note; if
/// none can be planned, the program ends with an error.
std::vector<Candidate> find_candidates(const OptimiseCommand& command,
                                       const std::vector<LoadedScene>& formulations,
                                       const CountedRates& counted) {
  std::vector<Candidate> candidates;
  std::vector<std::pair<std::string, Error>> left_out;
  for (std::size_t k = 0; k < formulations.size(); ++k) {
    const LoadedScene& formulation = formulations[k];
    Result<Candidate> candidate = find_plans(command, formulation, counted[k]);
    if (candidate.ok()) {
      candidates.push_back(std::move(candidate).value());
    } else {
      left_out.emplace_back(name_of(formulation.scene), candidate.error());
    }
  }
  if (candidates.empty()) fail(left_out.front().second);
  for (const auto& [name, error] : left_out) {
    tell_note(fmt::format("{} left out: {}", name, error.to_string()));
  }
  return candidates;
}

/// Notes that a file in the place of a plan is from an earlier run.
void tell_of_older(const fs::path& file) {
  if (file.empty() || !path_exists(file)) return;
  tell(fmt::format("{}: not written, since no plan was found; the file is of an earlier run",
                   file.string()));
}

std::string text_of_plan(const OptimiseCommand& command, const Candidate& chosen,
                         const optimise::PrecisionPlan& plan) {
  PlanningOptions planning = command.planning;
  for (const std::string& setting : settings_of(chosen.known.scene, planning.scene)) {
    planning.scene.settings.push_back(setting);
  }
  const optimise::PlanSource source =
      plan_source(planning, chosen.known.scene.system.device, command.plan, command_of(command));
  return plan_toml(chosen.found, plan, source);
}

/// Writes the files that were asked for: all of them, or none if one cannot be written.
void write_files(const OptimiseCommand& command, const Candidate& chosen) {
  const optimise::Optimisation& found = chosen.found;
  std::vector<std::pair<fs::path, std::string>> files;
  const auto add = [&files](const fs::path& path, auto text) {
    if (!path.empty()) files.emplace_back(path, text());
  };
  add(command.csv, [&] { return report::figure9_csv(found); });
  if (const optimise::PrecisionPlan* best = found.best(); best != nullptr) {
    add(command.lp, [&] { return to_lp(best->problem); });
    add(command.plan, [&] { return text_of_plan(command, chosen, *best); });
  } else {
    tell_of_older(command.plan);
    tell_of_older(command.lp);
  }
  write_together(files);
}

/// A table that compares the best plans of all formulations; empty for a single one.
std::string compare_formulations(const std::vector<Candidate>& candidates, std::size_t chosen) {
  if (candidates.size() < 2) return "";
  std::size_t width = 22;
  for (const Candidate& candidate : candidates) width = std::max(width, candidate.name().size());
  std::string text = "formulations, the best plan of each\n";
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const optimise::PlanSummary s = summary_of(candidates[k].found);
    text += fmt::format("{} {:<{}} ", k == chosen ? '*' : ' ', candidates[k].name(), width);
    if (s.throughput_per_s == 0) {
      text += "no feasible plan\n";
      continue;
    }
    text += fmt::format("L = {:>2}, {:>3} x {}: {:8.2f} G/s; the chosen is {:.2f} times as fast\n",
                        s.precision, s.lanes, s.references, s.throughput_per_s / 1e9,
                        candidates[chosen].throughput_per_s() / s.throughput_per_s);
  }
  return text + "\n";
}

/// The variant's name, null for the formulation in [comparison] itself, and the second tier's
/// format, null without one.
nlohmann::ordered_json json_name(const Candidate& candidate) {
  const scene::Scene& scene = candidate.known.scene;
  nlohmann::ordered_json json = {{"variant", nullptr}};
  if (!scene.variant.empty()) json["variant"] = scene.variant;
  if (scene.second_tier) json["second_tier"] = scene.second_tier->format_name();
  if (scene.leaves_out_second_tier) json["second_tier"] = nullptr;
  return json;
}

nlohmann::ordered_json to_json(const std::vector<Candidate>& candidates, std::size_t chosen) {
  nlohmann::ordered_json json = report::to_json(candidates[chosen].found);
  if (candidates.size() < 2 && candidates[chosen].known.scene.variants.empty()) return json;
  json.update(json_name(candidates[chosen]));
  for (const Candidate& candidate : candidates) {
    json["formulations"].push_back(json_name(candidate));
    json["formulations"].back()["throughput_per_s"] = candidate.throughput_per_s();
  }
  return json;
}

void run(OptimiseCommand& command) {
  PlanningOptions& planning = command.planning;
  const LoadedScene loaded = value_or_exit(load(planning.scene));
  std::vector<fs::path> inputs = inputs_of(planning.scene, loaded.scene);
  inputs.push_back(command.rates);
  const std::vector<LoadedScene> formulations = formulations_of(command, loaded);
  for (const LoadedScene& each : formulations) inputs.push_back(table_of(planning, each.scene));
  const std::vector<fs::path> outputs = {command.plan, command.csv, command.lp};
  value_or_exit(check_outputs(outputs, inputs));
  value_or_exit(check_writable(outputs));
  const CountedRates counted = make_missing_tables(command, formulations);
  const std::vector<Candidate> candidates = find_candidates(command, formulations, counted);
  const auto best = std::max_element(candidates.begin(), candidates.end(),
                                     [](const Candidate& a, const Candidate& b) {
                                       return a.throughput_per_s() < b.throughput_per_s();
                                     });
  const auto chosen = static_cast<std::size_t>(best - candidates.begin());
  write_files(command, *best);
  if (planning.scene.json) {
    print(report::json_text(to_json(candidates, chosen)));
  } else {
    print(fmt::format("{}{}", compare_formulations(candidates, chosen),
                      report::to_text(best->found)));
    if (best->found.best() != nullptr && !command.plan.empty()) {
      print(fmt::format("plan: {}\n", command.plan.string()));
    }
  }
  if (best->found.best() == nullptr) throw Exit(ExitCode::refuted);
}

}  // namespace

void add_optimise(CLI::App& app) {
  const Verb verb(app, "optimise",
                  "choose L, p_L, p_H and kinds of lanes for a device: the paper's Algorithm 1");
  auto command = std::make_shared<OptimiseCommand>();
  add_planning_options(verb, command->planning);
  verb.option("--rates", command->rates,
              "recomputation rates instead of measuring them: figure5.csv of mixcmp profile");
  verb.option("-o,--output", command->plan,
              "plan file to write: generate and verify take it in place of the scene");
  verb.option("--csv", command->csv, "figure 9 as a table: the best plan at each precision");
  verb.option("--lp", command->lp, "the best plan's integer program, in the LP format");
  verb.flag("--no-characterise", command->no_characterise,
            "where no table is there, end with an error; without this the lanes that look "
            "promising are measured first, only their areas (mixcmp characterise --quick)");
  verb.when_chosen([command] { run(*command); });
}

}  // namespace mixcmp::cli

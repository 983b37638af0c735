#include "generator/tasks/optimise.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/optimise_on.hpp"
#include "generator/faces/cli/optimise_report.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/plan_set.hpp"
#include "generator/faces/cli/planning.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/present/report/json_text.hpp"
#include "generator/present/report/plan_report.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/output_file.hpp"
#include "model/plan/optimise/plan.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;

struct OptimiseCommand {
  PlanningOptions planning;
  fs::path rates;
  fs::path plan;
  fs::path csv;
  fs::path lp;
  bool predict_only = false;
  double at_least = 0;          ///< G comparisons/s
  std::vector<std::string> on;  ///< in place of the scene's device
  PlanSetOptions set;
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

/// The rates of a file, or none: they are counted.
std::optional<optimise::Rates> given_rates(const OptimiseCommand& command,
                                           const LoadedScene& loaded) {
  if (command.rates.empty()) return std::nullopt;
  optimise::Rates rates = value_or_exit(optimise::Rates::read(command.rates));
  check_rates(rates, command.rates, loaded);
  return rates;
}

std::string command_of(const OptimiseCommand& command) {
  CommandLine line = planning_command_line("optimise", command.planning);
  line.add("--rates", command.rates.string()).add_flag("--predict-only", command.predict_only);
  if (command.at_least > 0) line.add("--at-least", fmt::format("{}", command.at_least));
  line.add("--on", fmt::format("{}", fmt::join(command.on, ",")));
  add_to(line, command.set);
  return line.text();
}

tasks::OptimiseRequest request_of(const OptimiseCommand& command, const LoadedScene& loaded) {
  tasks::OptimiseRequest request = search_request(command.planning, command.predict_only);
  request.rates = given_rates(command, loaded);
  request.at_least_per_s = command.at_least * 1e9;
  request.at_least_option = "--at-least";
  request.confirming = [](double per_s, int components) {
    show_progress("");
    tell_note(
        fmt::format("predicted {} G comparisons/s; its {} components are synthesised to "
                    "confirm it. An interrupted run goes on when it is given again; "
                    "--predict-only stops here",
                    giga_text(per_s), components));
  };
  return request;
}

/// Notes what the user must know about the tables and the formulations without a plan.
void tell_notes(const OptimiseCommand& command, const scene::Scene& given,
                const tasks::OptimiseResult& result) {
  for (const tasks::PlannedSystem& system : result.systems) {
    tell_notes_of(system.known, given, command.planning);
  }
  for (const std::string& note : result.notes) tell_note(note);
  for (const auto& [name, error] : result.left_out) {
    tell_note(fmt::format("{} left out: {}", name, error.to_string()));
  }
}

/// Notes that a file in the place of a plan is from an earlier run.
void tell_of_older(const fs::path& file) {
  if (file.empty() || !path_exists(file)) return;
  tell(fmt::format("{}: not written, since no plan was found; the file is of an earlier run",
                   file.string()));
}

std::string text_of_plan(const OptimiseCommand& command, const tasks::OptimiseRequest& request,
                         const tasks::OptimiseResult& result) {
  const tasks::PlannedSystem& chosen = result.best();
  PlanningOptions planning = command.planning;
  planning.scene.settings = settings_of(request, chosen);
  optimise::PlanSource source =
      plan_source(planning, chosen.known.scene.system.device, command.plan, command_of(command));
  if (result.confirmation) source.areas = areas_of(*result.confirmation);
  return plan_toml(chosen.found, *chosen.found.best(), source);
}

/// Writes the files that were asked for: all of them, or none if one cannot be written.
void write_files(const OptimiseCommand& command, const tasks::OptimiseRequest& request,
                 const tasks::OptimiseResult& result) {
  const optimise::Optimisation& found = result.best().found;
  std::vector<std::pair<fs::path, std::string>> files;
  const auto add = [&files](const fs::path& path, auto text) {
    if (!path.empty()) files.emplace_back(path, text());
  };
  add(command.csv, [&] { return report::figure9_csv(found); });
  if (const optimise::PrecisionPlan* best = found.best(); best != nullptr) {
    add(command.lp, [&] { return to_lp(best->problem); });
    add(command.plan, [&] { return text_of_plan(command, request, result); });
  } else {
    tell_of_older(command.plan);
    tell_of_older(command.lp);
  }
  write_together(files);
}

void print_result(const OptimiseCommand& command, const tasks::OptimiseResult& result) {
  if (command.planning.scene.json) {
    print(report::json_text(cli::to_json(result)));
    return;
  }
  print(cli::to_text(result));
  if (result.best().found.best() != nullptr && !command.plan.empty()) {
    print(fmt::format("plan: {}\n", command.plan.string()));
  }
}

/// Without a least throughput no device is chosen whose plan could be written.
void check_on(const OptimiseCommand& command) {
  if (command.at_least > 0) return;
  const std::pair<const char*, fs::path> files[] = {
      {"--output", command.plan}, {"--csv", command.csv}, {"--lp", command.lp}};
  for (const auto& [option, path] : files) {
    if (path.empty()) continue;
    fail({.field = option,
          .message = "is for one plan, and --on makes one on each device",
          .received = path.string(),
          .accepted =
              "--at-least, which chooses the smallest device, or --device in place of --on"});
  }
}

/// Plans on the devices of --on; with --at-least, the plan on the smallest is the result.
void run_on_devices(const OptimiseCommand& command, const tasks::OptimiseRequest& request,
                    const LoadedScene& loaded) {
  check_on(command);
  const tasks::OptimiseOnRequest on{.optimise = request, .devices = devices_on(command.on)};
  const tasks::OptimiseOnResult result =
      value_or_exit(with_shortcuts(tasks::optimise_on(on, loaded), command.planning.scene));
  show_progress("");
  for (const std::string& note : result.notes) tell_note(note);
  if (result.smallest) write_files(command, request, *result.smallest);
  if (command.planning.scene.json) {
    nlohmann::ordered_json json =
        result.smallest ? cli::to_json(*result.smallest) : nlohmann::ordered_json::object();
    json.update(cli::to_json(result));
    print(report::json_text(json));
    return;
  }
  print(cli::to_text(result));
  if (!result.smallest) return;
  print(fmt::format("\nthe smallest: {}\n", result.smallest->best().found.device.name));
  print_result(command, *result.smallest);
}

void run(OptimiseCommand& command) {
  PlanningOptions& planning = command.planning;
  const LoadedScene loaded = value_or_exit(load(planning.scene));
  value_or_exit(check_options_of(planning));
  const tasks::OptimiseRequest request = request_of(command, loaded);
  if (command.set.plans > 0) {
    command.set.output = command.plan;
    return run_plan_set(planning, command.set, request, loaded, command_of(command));
  }
  std::vector<fs::path> inputs = inputs_of(planning.scene, loaded.scene);
  inputs.push_back(command.rates);
  for (const tasks::Formulation& each : value_or_exit(tasks::formulations_of(request, loaded))) {
    inputs.push_back(table_of(planning, each.loaded.scene));
  }
  const std::vector<fs::path> outputs = {command.plan, command.csv, command.lp};
  value_or_exit(check_outputs(outputs, inputs));
  value_or_exit(check_writable(outputs));
  if (!command.on.empty()) return run_on_devices(command, request, loaded);
  const tasks::OptimiseResult result =
      value_or_exit(with_shortcuts(tasks::optimise(request, loaded), planning.scene));
  show_progress("");
  tell_notes(command, loaded.scene, result);
  end_if_not_confirmed(result);
  write_files(command, request, result);
  print_result(command, result);
  if (result.best().found.best() == nullptr) throw Exit(ExitCode::refuted);
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
  verb.flag("--predict-only,--no-characterise", command->predict_only,
            "plan with predicted areas; without this the components of the best plan are "
            "synthesised, and the plan is made again with their measured areas");
  verb.option("--at-least", command->at_least,
              "plan the smallest system with so many G comparisons/s, not the fastest; without "
              "--table")
      .check(between(1e-6, 1e9, "G/S"));
  add_plan_set_options(verb, command->set);
  add_on_option(verb, command->on);
  verb.when_chosen([command] { run(*command); });
}

}  // namespace mixcmp::cli

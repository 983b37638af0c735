#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "generator/cli/exit.hpp"
#include "generator/cli/output.hpp"
#include "generator/cli/planning.hpp"
#include "generator/cli/verbs.hpp"
#include "model/optimise/plan.hpp"
#include "model/optimise/report.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;

struct OptimiseCommand {
  PlanningOptions planning;
  fs::path rates;
  fs::path plan;
  fs::path csv;
  fs::path lp;
};

model::Rates rates_for(const OptimiseCommand& command, const LoadedScene& loaded) {
  if (!command.rates.empty()) return value_or_exit(model::Rates::read(command.rates));
  return model::Rates::of(value_or_exit(measure_rates(loaded, command.planning.choice)));
}

std::string command_of(const OptimiseCommand& command) {
  const std::string line = planning_command_line("optimise", command.planning);
  return command.rates.empty() ? line : line + " --rates " + quoted(command.rates.string());
}

void write_files(const OptimiseCommand& command, const std::string& device,
                 const model::Optimisation& found) {
  if (!command.csv.empty()) value_or_exit(write_file(command.csv, figure9_csv(found)));
  const model::PrecisionPlan* best = found.best();
  if (best == nullptr) return;
  if (!command.lp.empty()) value_or_exit(write_file(command.lp, to_lp(best->problem)));
  if (command.plan.empty()) return;
  const model::PlanSource source =
      plan_source(command.planning, device, command.plan, command_of(command));
  value_or_exit(write_file(command.plan, plan_toml(found, *best, source)));
}

void run(OptimiseCommand& command) {
  PlanningOptions& planning = command.planning;
  if (planning.separate_clocks) planning.choice.clocks.domains = model::ClockDomains::separate;
  const LoadedScene loaded = value_or_exit(load(planning.scene));
  const Planning known =
      value_or_exit(load_planning(planning, loaded.scene, loaded.data ? &*loaded.data : nullptr));
  const fs::path table = planning.table.empty()
                             ? default_table(planning.scene.scene, known.device.name)
                             : planning.table;
  value_or_exit(check_outputs({command.plan, command.csv, command.lp},
                              {planning.scene.scene, table, command.rates}));
  const model::Optimisation found = value_or_exit(optimise(
      known.scene, known.device, known.table, rates_for(command, loaded), planning.choice));
  write_files(command, known.scene.system.device, found);
  if (planning.scene.json) {
    fmt::print("{}\n", to_json(found).dump(2));
  } else {
    fmt::print("{}", to_text(found));
    if (found.best() != nullptr && !command.plan.empty()) {
      fmt::print("plan: {}\n", command.plan.string());
    }
  }
  if (found.best() == nullptr) throw Exit{2};
}

}  // namespace

void add_optimise(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "optimise", "choose L, p_L, p_H and kinds of lanes for a device: the paper's Algorithm 1");
  auto command = std::make_shared<OptimiseCommand>();
  add_planning_options(*verb, command->planning);
  verb->add_option("--rates", command->rates,
                   "recomputation rates instead of measuring them: figure5.csv of mixcmp profile");
  verb->add_option("-o,--output", command->plan,
                   "plan file to write: generate and verify take it in place of the scene");
  verb->add_option("--csv", command->csv, "figure 9 as a table: the best plan at each precision");
  verb->add_option("--lp", command->lp, "the best plan's integer program, in the LP format");
  verb->callback([command] { run(*command); });
}

}  // namespace mixcmp::cli

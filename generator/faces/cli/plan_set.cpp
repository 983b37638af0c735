#include "generator/faces/cli/plan_set.hpp"

#include <fmt/core.h>

#include <array>
#include <nlohmann/json.hpp>

#include "generator/faces/cli/data_sets.hpp"
#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/plan_set_report.hpp"
#include "generator/present/report/json_text.hpp"
#include "generator/project/switching_files.hpp"
#include "generator/tasks/plan_set.hpp"
#include "model/plan/optimise/plan.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::array plan_set_files = {"plan_1.toml", "plan_2.toml", "plan_3.toml", "plan_4.toml",
                                       "plan_5.toml", "plan_6.toml", "plan_7.toml", "plan_8.toml",
                                       "switching.h", "switching.py"};
constexpr int most_plans = plan_set_files.size() - 2;

constexpr double least_seconds = 1e-6;
constexpr double most_seconds = 1e6;

/// The data sets of an option, loaded.
struct NamedSets {
  std::vector<std::string> names;
  std::vector<tasks::DataSet> sets;
  std::vector<fs::path> inputs;
};

NamedSets load_sets(const PlanningOptions& planning, const std::string& option,
                    const std::string& text) {
  NamedSets named;
  if (text.empty()) return named;
  for (const std::string& set : value_or_exit(data_sets(option, text))) {
    const SceneOptions options = with_data_set(planning.scene, option, set);
    LoadedScene loaded = value_or_exit(load(options));
    value_or_exit(check_has_data(loaded, "recomputation rates are counted on data"));
    check_ranges(option, loaded.scene);
    const std::vector<fs::path> inputs = inputs_of(options, loaded.scene);
    named.inputs.insert(named.inputs.end(), inputs.begin(), inputs.end());
    named.sets.push_back({{set}, *std::move(loaded.data)});
    named.names.push_back(set);
  }
  return named;
}

project::SwitchingSpec switching_of(const tasks::PlanSetResult& result,
                                    const std::string& command) {
  const tasks::PlannedSystem& first = result.plans.front().system;
  const bool is_pairwise = first.known.scene.system.engine.kind == scene::EngineKind::pairwise;
  project::SwitchingSpec spec{.rule = result.rule,
                              .name = first.found.scene,
                              .command = command,
                              .plans = plan_lines(result),
                              .comparisons_of_word = {},
                              .counts_comparisons = !is_pairwise};
  for (const tasks::SetPlan& each : result.plans) {
    spec.comparisons_of_word.push_back(each.system.known.scene.system.lanes_per_group);
  }
  return spec;
}

void write_files(const PlanningOptions& planning, const PlanSetOptions& options,
                 const tasks::OptimiseRequest& base, const tasks::PlanSetResult& result,
                 const std::string& command) {
  if (options.output.empty()) return;
  ResultFiles files(options.output, plan_set_files);
  for (std::size_t k = 0; k < most_plans; ++k) {
    const std::string name = plan_set_files[k];
    if (k >= result.plans.size()) {
      files.leave_out(name);
      continue;
    }
    const tasks::SetPlan& each = result.plans[k];
    PlanningOptions own = planning;
    own.scene.settings = settings_of(base, each.system);
    const std::string& device = each.system.known.scene.system.device;
    optimise::PlanSource source = plan_source(own, device, options.output / name, command);
    source.areas = "predicted";
    files.add(name, plan_toml(each.system.found, each.plan(), source));
  }
  for (emit::GeneratedFile& file : switching_files(switching_of(result, command))) {
    files.add(file.name, std::move(file.text));
  }
  files.write_out();
  files.commit();
}

void print_result(const PlanningOptions& planning, const PlanSetOptions& options,
                  const tasks::PlanSetResult& result, const NamedSets& sets,
                  const NamedSets& stream) {
  if (planning.scene.json) {
    print(report::json_text(to_json(result, sets.names, stream.names)));
    return;
  }
  print(to_text(result, sets.names, stream.names));
  if (options.output.empty()) return;
  print(fmt::format("\nplans and the rule that switches them: {}\n", options.output.string()));
}

}  // namespace

void add_plan_set_options(const Verb& verb, PlanSetOptions& options) {
  const Option plans =
      verb.option("--plans", options.plans,
                  "plan for data whose rates change: at most so many systems that "
                  "together lose least over the data sets of --over, and the rule that "
                  "switches between them by their counters; -o is then a folder")
          .check(within({1, most_plans}))
          .excludes("--rates")
          .excludes("--csv")
          .excludes("--lp")
          .excludes("--at-least");
  const Option over = verb.option("--over", options.over,
                                  "the data sets, by a key of the scene: data.radius_max=5,10,25")
                          .needs(plans);
  plans.needs(over);
  verb.option("--stream", options.stream,
              "simulate the rule on a stream of such data, in this order: "
              "data.radius_max=5,6,7,8")
      .needs(plans);
  verb.option("--reconfiguration-seconds", options.reconfiguration_seconds,
              "the time to load another plan (default: 600 bits for each LUT of the device, at "
              "3.2 Gbit/s)")
      .check(between(least_seconds, most_seconds, "SECONDS"))
      .needs(plans);
}

void add_to(CommandLine& line, const PlanSetOptions& options) {
  if (options.plans == 0) return;
  line.add("--plans", std::to_string(options.plans))
      .add("--over", options.over)
      .add("--stream", options.stream)
      .add("--reconfiguration-seconds", text_of(options.reconfiguration_seconds));
}

void run_plan_set(const PlanningOptions& planning, const PlanSetOptions& options,
                  tasks::OptimiseRequest base, LoadedScene own, const std::string& command) {
  value_or_exit(check_options_of(planning));
  const NamedSets sets = load_sets(planning, "--over", options.over);
  const NamedSets stream = load_sets(planning, "--stream", options.stream);
  std::vector<fs::path> inputs = sets.inputs;
  inputs.insert(inputs.end(), stream.inputs.begin(), stream.inputs.end());
  inputs.push_back(planning.table);
  std::vector<fs::path> outputs;
  if (!options.output.empty()) outputs = ResultFiles::paths(options.output, plan_set_files);
  value_or_exit(check_outputs(outputs, inputs));
  const tasks::PlanSetRequest request{.optimise = std::move(base),
                                      .own = std::move(own.data),
                                      .sets = sets.sets,
                                      .stream = stream.sets,
                                      .most_plans = options.plans,
                                      .reconfiguration_seconds = options.reconfiguration_seconds};
  const tasks::PlanSetResult result =
      value_or_exit(with_shortcuts(tasks::plan_set(request), planning.scene));
  show_progress("");
  for (const std::string& note : result.notes) tell_note(note);
  write_files(planning, options, request.optimise, result, command);
  print_result(planning, options, result, sets, stream);
}

}  // namespace mixcmp::cli

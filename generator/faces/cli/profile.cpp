#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "generator/faces/cli/advice.hpp"
#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/options.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/profiling.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/present/report/json_text.hpp"
#include "generator/present/report/profile_report.hpp"
#include "generator/present/report/trade_report.hpp"
#include "model/base/common/output_file.hpp"
#include "model/base/common/quote.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;

/// Reads the bounds to count. Profiles count running bounds only with 4 digits and 1 digit, but
/// guard digits of any number.
Result<std::vector<Bound>> bounds_to_count(const std::vector<std::string>& names) {
  const std::string option = "--bounds";
  MIXCMP_TRY(bounds, parse_bounds(option, names));
  const auto counted = counted_bounds();
  std::vector<std::string> accepted;
  for (const Bound& bound : counted) accepted.push_back(to_string(bound));
  for (const Bound& bound : bounds) {
    const bool is_counted = std::find(counted.begin(), counted.end(), bound) != counted.end();
    if (is_counted || bound.is_fixed_point()) continue;
    return Error{.field = option,
                 .message = "a profile does not count this bound",
                 .received = in_quotes(to_string(bound)),
                 .accepted = fmt::format("{}, or of fixed point with guard digits",
                                         fmt::join(accepted, ", "))};
  }
  return bounds;
}

struct ProfileCommand {
  SceneOptions scene;
  profile::ProfileOptions run;
  std::optional<int> last;
  std::optional<std::uint64_t> samples;
  fs::path output;
  bool both_inputs = false;
  bool brute_force = false;
  bool trade = false;
  std::vector<double> accepted;  ///< wrong verdicts per million
  fs::path areas;
};

void add_options(const Verb& verb, ProfileCommand& command) {
  add_scene_options(verb, command.scene);
  verb.option("--first", command.run.first_precision, "the lowest L (default: the lowest there is)")
      .check(within(settings::limits::lane_precision));
  verb.option("--last", command.last,
              "the highest L (default: the highest there is, or the reference's precision if "
              "that is less)")
      .check(within(settings::limits::lane_precision));
  verb.option("--samples", command.samples,
              "comparisons that relative errors are measured on, 0..2^40 (default: 1000000, or 0 "
              "where --bounds names only fixed point, which does without them)")
      .check(whole(0, std::uint64_t{1} << 40));
  verb.option("--threads", command.run.threads,
              "threads; results do not depend on them (default: one a processor)")
      .check(within(settings::limits::threads));
  verb.list_option(
          "--bounds",
          [&run = command.run](const std::vector<std::string>& names) {
            run.bounds = value_or_exit(bounds_to_count(names));
          },
          "rates of only the lanes with these bounds: relative, running_4, running_1, constant, "
          "profiled, fixed_norm, fixed_constant, fixed_running, block_norm, block_constant, "
          "block_running, fixed_grid; fixed_norm_g3 has three guard digits (default: those without "
          "guard digits, except the two running ones in fixed point, those of the scene's own "
          "lanes, and "
          "lanes without a bound)")
      .separated_by(',');
  verb.flag("--both-inputs", command.both_inputs,
            "also rates for rounded and for exact inputs, whatever the scene says");
  verb.flag("--brute-force", command.brute_force,
            "every comparison through every lane and MPFR: slow, the same counts");
  verb.flag("--trade", command.trade, "weigh wrong verdicts against area, system by system");
  verb.option("--accept", command.accepted,
              "say which system is cheapest with at most N wrong verdicts per million; 0: only "
              "certified lanes, where the reference was always right; may be repeated (includes "
              "--trade)")
      .one_value_each()
      .check(between(0, 1e6, "N"));
  verb.option("--areas", command.areas,
              "measured areas instead of the cost model: CSV of scheme,precision,luts "
              "(includes --trade)");
  verb.option("-o,--output", command.output,
              "directory for figure4, figure5 and trade as .csv and .svg, and all of it as "
              "profile.json");
}

/// The files in the folder of -o.
constexpr std::array profile_files = {"profile.json", "figure4.csv", "figure4.svg", "figure5.csv",
                                      "figure5.svg",  "trade.csv",   "trade.svg"};

nlohmann::ordered_json json_of(const report::ProfileReport& report, const Trades& weighed,
                               const Result<Advice>& advice) {
  nlohmann::ordered_json all = report::to_json(report);
  for (const profile::Trade& trade : weighed.trades) all["trade"].push_back(report::to_json(trade));
  for (const std::string& answer : weighed.accepted) all["advice"].push_back(answer);
  if (advice.ok()) all["cheapest"] = to_json(*advice);
  return all;
}

/// Writes the files of -o. Returns descriptions of those that could not be made.
std::vector<std::string> write_results(const report::ProfileReport& report, const Trades& weighed,
                                       const Result<Advice>& advice, const fs::path& folder) {
  const FolderLock held = lock_folder(folder);
  ResultFiles results(folder, profile_files);
  results.add("profile.json", report::json_text(json_of(report, weighed, advice)));
  results.add("figure4.csv", report::figure4_csv(report));
  results.add("figure5.csv", report::figure5_csv(report));
  results.add_picture("figure4.svg", script(report::figure4(report)));
  results.add_picture("figure5.svg", script(report::figure5(report)));
  if (weighed.trades.empty()) {
    results.leave_out("trade.csv");
    results.leave_out("trade.svg");
  } else {
    results.add("trade.csv", report::trade_csv(weighed.trades));
    results.add_picture("trade.svg", report::trade_script(weighed.trades, report.scene));
  }
  results.write_out();
  return results.commit();
}

void print_text(const report::ProfileReport& report, const Trades& weighed,
                const Result<Advice>& advice) {
  print(report::to_text(report));
  for (const profile::Trade& trade : weighed.trades) print(report::to_text(trade));
  for (const std::string& answer : weighed.accepted) print(answer);
  print(advice.ok() ? to_text(*advice)
                    : fmt::format("\nadvice: none: {}\n", advice.error().to_string()));
}

/// The usual number of comparisons on which errors are measured. Only profiled lanes need measured
/// errors, and a user who asks only for lanes in fixed point wants none of floating point.
std::uint64_t usual_samples(const std::vector<Bound>& bounds) {
  const bool fixed_point_alone =
      !bounds.empty() && std::all_of(bounds.begin(), bounds.end(),
                                     [](const auto& bound) { return bound.is_fixed_point(); });
  return fixed_point_alone ? 0 : profile::ProfileOptions().error_samples;
}

void run(const ProfileCommand& command) {
  const LoadedScene loaded = value_or_exit(load(command.scene));
  value_or_exit(check_has_data(loaded, "a profile needs data to measure"));
  profile::ProfileOptions options = command.run;
  options.last_precision =
      command.last.value_or(settings::lane_precisions(loaded.scene.reference.format).most);
  options.error_samples = command.samples.value_or(usual_samples(options.bounds));
  if (command.brute_force) options.method = profile::ProfileMethod::brute_force;
  value_or_exit(check_profile(loaded.scene, options));
  const estimated::MeasuredAreas areas =
      command.areas.empty() ? estimated::MeasuredAreas()
                            : value_or_exit(estimated::MeasuredAreas::read(command.areas));
  std::vector<fs::path> inputs = inputs_of(command.scene, loaded.scene);
  inputs.push_back(command.areas);
  if (!command.output.empty()) {
    value_or_exit(check_outputs(ResultFiles::paths(command.output, profile_files), inputs));
  }
  // A folder that cannot be written should not cost a long run first.
  if (!command.output.empty()) value_or_exit(make_writable_folder(command.output));
  const LaneInputs own = loaded.scene.reduced.inputs;
  const std::set<LaneInputs> counted =
      command.both_inputs ? std::set{own, LaneInputs::exact, LaneInputs::rounded} : std::set{own};
  const report::ProfileReport report = measure_profile(loaded, counted, options);
  const bool weighs = command.trade || !command.accepted.empty() || !command.areas.empty();
  const Trades weighed = weighs ? weigh(loaded, report, areas, command.accepted) : Trades();
  // A scene that is only profiled may ask for more than hardware has. Then there is nothing to
  // advise.
  const Result<Advice> advice = advise(command.scene, loaded, report.rates);
  std::vector<std::string> not_done;
  if (!command.output.empty()) not_done = write_results(report, weighed, advice, command.output);
  if (command.scene.json) {
    print(report::json_text(json_of(report, weighed, advice)));
  } else {
    print_text(report, weighed, advice);
  }
  end_if_incomplete(not_done);
}

}  // namespace

void add_profile(CLI::App& app) {
  const Verb verb(app, "profile",
                  "measure errors, recomputation rates and wrong verdicts at every precision");
  auto command = std::make_shared<ProfileCommand>();
  add_options(verb, *command);
  verb.when_chosen([command] { run(*command); });
}

}  // namespace mixcmp::cli

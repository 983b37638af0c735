#include "generator/tasks/verify.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "generator/tasks/generate.hpp"
#include "generator/tasks/simulations.hpp"
#include "model/base/common/command_line.hpp"
#include "model/base/common/content_hash.hpp"
#include "verilator_tb/counterexample.hpp"

namespace mixcmp::tasks {
namespace {

namespace fs = std::filesystem;
using verilator_tb::Selection;

/// The command that repeats the run; none for a scene from a text and for data of a caller.
std::optional<CommandLine> repeat_command(const SceneRequest& request, const LoadedScene& loaded,
                                          const VerifyOptions& options) {
  if (request.source.text || !loaded.scene.data) return std::nullopt;
  const bool icarus = options.run.simulator == verilator_tb::SimulatorKind::icarus;
  return CommandLine("verify", request.source.path, request.settings)
      .add("--simulator", icarus ? "icarus" : "")
      .add("--truth", options.truth ? "all" : "");
}

/// The command that shows a short run of the same traffic as waves.
std::string waves_command(CommandLine repeat, const verilator_tb::VerifyOptions& run,
                          const Selection::Options& selection) {
  if (run.traffic == verilator_tb::TrafficKind::stressed) {
    repeat.add("--traffic", "stressed").add("--seed", std::to_string(run.selection.seed));
  }
  repeat.add("--resets", std::to_string(run.resets), "0");
  repeat.add("--share", std::to_string(run.share_size),
             std::to_string(verilator_tb::VerifyOptions().share_size));
  selection.only ? repeat.add("--only", std::to_string(*selection.only))
                 : repeat.add("--first", std::to_string(selection.limit));
  return repeat.add("--trace", "counterexample.fst").text();
}

/// Refuses a work folder in which the simulator cannot build. Verilator's makefiles take no path
/// with blanks. iverilog hands the paths of its temporary files to a shell, in double quotes.
Result<Done> check_work(verilator_tb::SimulatorKind simulator, const fs::path& work) {
  const std::string path = fs::absolute(work).string();
  switch (simulator) {
    case verilator_tb::SimulatorKind::icarus:
      if (path.find_first_of("\"$`\\\n") == std::string::npos) return Done{};
      return Error{.field = "--work",
                   .message = "Icarus cannot compile where the path has one of \" $ ` \\",
                   .received = path,
                   .accepted = "a path without these"};
    case verilator_tb::SimulatorKind::verilator:
      if (path.find_first_of(" \t\n") == std::string::npos) return Done{};
      return Error{.field = "--work",
                   .message = "Verilator cannot build where the path has blanks",
                   .received = path,
                   .accepted = "a path without blanks, or the simulator icarus"};
  }
  MIXCMP_CHECK(false);
}

/// Checks that the trace can be written, before the simulation takes its time.
Result<Done> check_trace(const fs::path& trace) {
  if (trace.empty()) return Done{};
  MIXCMP_TRY(possible, verilator_tb::WaveFile::open(trace));
  return Done{};
}

verilator_tb::VerifyOptions run_options(const SceneRequest& request, const LoadedScene& loaded,
                                        const VerifyOptions& options, const fs::path& work) {
  verilator_tb::VerifyOptions run = options.run;
  run.work_dir = work / "build";
  run.jobs = options.jobs > 0 ? options.jobs
                              : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  run.traffic_seed = run.selection.seed;
  const auto repeat = repeat_command(request, loaded, options);
  run.repeat_command = repeat ? repeat->text() : "";
  if (options.truth) run.truth = {&loaded.scene.graph, *options.truth};
  return run;
}

/// Writes the system into a folder of WORK/rtl whose name holds a hash of all its bytes. Runs of
/// different systems can thus share a work folder.
Result<verilator_tb::System> write_rtl(const emit::GeneratedSystem& system, const fs::path& work,
                                       const Waiting& waiting) {
  ContentHash hash;
  for (const emit::GeneratedFile& file : system.files) hash.add(file.name).add(file.text);
  MIXCMP_TRY(held, FolderLock::take(work / "rtl", waiting));
  const fs::path folder =
      work / "rtl" / fmt::format("{}-{}", system.signature.top, hash.hex().substr(0, 16));
  MIXCMP_DO(emit::write_system(system, folder));
  return verilator_tb::System{fs::absolute(folder), system.signature};
}

/// The short run that fails, as a report states it. `waves`: the command that shows it.
verilator_tb::LeastCounterexample describe(const verilator_tb::Counterexample& found,
                                           std::string waves) {
  verilator_tb::LeastCounterexample least;
  least.comparisons = found.selection.only
                          ? fmt::format("only comparison {}", *found.selection.only)
                          : fmt::format("the first {} comparisons", found.selection.limit);
  if (!found.report.mismatches.empty()) {
    least.mismatch = found.report.mismatches.front();
  } else if (!found.report.violations.empty()) {
    least.violation = found.report.violations.front();
  }
  least.waves = std::move(waves);
  return least;
}

/// Looks for a short run that also fails.
Result<std::optional<verilator_tb::Counterexample>> find_counterexample(
    const verilator_tb::VerifyReport& failed, const verilator_tb::System& system,
    const design::Design& design, const data::Comparisons& data,
    const verilator_tb::VerifyOptions& run) {
  const auto rerun = [&](const Selection::Options& selection) {
    verilator_tb::VerifyOptions again = run;
    again.selection = selection;
    again.waves.clear();
    again.repeat_command.clear();
    again.on_result = {};
    return verilator_tb::verify(design, data, system, again);
  };
  constexpr double seconds = 60;
  return verilator_tb::least_counterexample(failed, run.selection, rerun, seconds);
}

}  // namespace

Result<Done> check_verify(const SceneRequest& request, const LoadedScene& loaded,
                          const VerifyOptions& options) {
  MIXCMP_DO(check_has_data(loaded, "verify needs data to run on"));
  MIXCMP_TRY(design, design_of(request, loaded));
  return check_request(design, *loaded.data, run_options(request, loaded, options, {}));
}

Result<Verification> verify(const SceneRequest& request, const LoadedScene& loaded,
                            const VerifyOptions& options) {
  MIXCMP_DO(check_has_data(loaded, "verify needs data to run on"));
  MIXCMP_TRY(built, build_system(request, loaded));
  const auto& [design, generated] = built;
  const fs::path work =
      options.work.empty() ? fs::path(generated.signature.top + "_simulation") : options.work;
  MIXCMP_DO(check_work(options.run.simulator, work));
  const verilator_tb::VerifyOptions run = run_options(request, loaded, options, work);
  MIXCMP_DO(check_request(design, *loaded.data, run));
  MIXCMP_DO(check_trace(run.waves));
  MIXCMP_TRY(system, write_rtl(generated, work, run.waiting));
  MIXCMP_TRY(report, verilator_tb::verify(design, *loaded.data, system, run));
  Verification found{.report = std::move(report), .not_done = {}};
  const bool has_engine = design.system.engine.kind != scene::EngineKind::none;
  if (!found.report.passed() && options.find_counterexample && !has_engine) {
    const auto least = find_counterexample(found.report, system, design, *loaded.data, run);
    const auto repeat = repeat_command(request, loaded, options);
    if (!least.ok()) {
      found.not_done.push_back("no counterexample was looked for: " + least.error().to_string());
    } else if (*least) {
      found.report.counterexample =
          describe(**least, repeat ? waves_command(*repeat, run, (*least)->selection) : "");
    }
  }
  const auto kept = keep_simulation(generated.signature.spec_hash, found.report);
  if (!kept.ok()) found.not_done.push_back("the run is not on record: " + kept.error().to_string());
  found.report.inputs = data::input_sources(*loaded.data, loaded.scene.graph.inputs());
  return found;
}

}  // namespace mixcmp::tasks

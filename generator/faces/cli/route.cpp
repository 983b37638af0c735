#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/options.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/present/report/json_text.hpp"
#include "generator/synthesis/characterise/job_hash.hpp"
#include "generator/synthesis/characterise/job_runner.hpp"
#include "generator/synthesis/components/whole_job.hpp"
#include "model/base/common/scratch_folder.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;

struct RouteCommand {
  SceneOptions scene;
  int references_alone = 0;  ///< 0: the scene's system
  characterise::SynthesisOptions synthesis;
  std::filesystem::path work;
};

void add_options(const Verb& verb, RouteCommand& command) {
  add_scene_options(verb, command.scene);
  verb.option("--references-alone", command.references_alone,
              "not the system: so many reference datapaths with nothing around them")
      .check(within({1, 1024}));
  verb.option("--seeds", command.synthesis.seeds, "of the router (default: 3)")
      .check(within(settings::limits::seeds));
  verb.option("--work", command.work,
              "folder that keeps netlists and logs, those of each job in a folder of its own "
              "(default: none)");
}

characterise::SynthesisJob job_of(const RouteCommand& command, const LoadedScene& loaded) {
  if (command.references_alone > 0) {
    return value_or_exit(components::references_job(loaded.scene, command.references_alone));
  }
  const design::Design design = value_or_exit(design_of(command.scene, loaded));
  return components::system_job(value_or_exit(emit::generate_system(design, "")));
}

std::string clock_text(const characterise::SynthesisResult& result) {
  if (!result.clock) return "none: " + result.no_clock;
  const measured::Clock& clock = *result.clock;
  const std::string_view source =
      clock.source == measured::ClockSource::routed ? "routed" : "estimate before routing";
  return fmt::format("{:.1f} MHz ({:.1f} .. {:.1f}, {} seeds), {}", clock.mhz, clock.low_mhz,
                     clock.high_mhz, clock.seeds, source);
}

void print_text(const characterise::SynthesisJob& job, const devices::Device& device,
                const characterise::SynthesisResult& result) {
  print(fmt::format("{} on {}\n", job.top, device.name));
  for (const devices::Resource& resource : devices::bounded_resources) {
    print(fmt::format("  {:<10} {} of {}\n", resource.name, result.area.*resource.amount,
                      device.available.*resource.amount));
  }
  print(fmt::format("  {:<10} {}\n", "clock", clock_text(result)));
}

void print_json(const characterise::SynthesisJob& job, const devices::Device& device,
                const characterise::SynthesisResult& result, const std::string& tools) {
  nlohmann::ordered_json report = {{"top", job.top}, {"device", device.name}, {"tools", tools}};
  for (const devices::Resource& resource : devices::bounded_resources) {
    report[resource.name] = {{"used", result.area.*resource.amount},
                             {"available", device.available.*resource.amount}};
  }
  report["clock"] = nullptr;
  if (result.clock) {
    report["clock"] = {{"mhz", result.clock->mhz},
                       {"low_mhz", result.clock->low_mhz},
                       {"high_mhz", result.clock->high_mhz},
                       {"seeds", result.clock->seeds},
                       {"source", to_string(result.clock->source)}};
  } else {
    report["no_clock"] = result.no_clock;
  }
  print(report::json_text(report));
}

/// The folder in which --work keeps a job's files; each job has its own. Empty without --work.
fs::path kept_folder(const RouteCommand& command, const characterise::SynthesisJob& job,
                     const devices::Device& device, const std::string& tools) {
  if (command.work.empty()) return {};
  const std::string hash = job_hash(job, device, command.synthesis, tools);
  return fs::absolute(command.work) / fmt::format("{}-{}", job.top, hash.substr(0, 12));
}

/// The message of a failed job, with its scratch folder replaced by the folder that keeps its
/// files.
std::string with_kept_names(const characterise::FailedJob& job, const std::string& kept) {
  const std::string scratch = job.directory.string();
  std::string message = job.message;
  for (std::size_t place = 0; (place = message.find(scratch, place)) != std::string::npos;
       place += kept.size()) {
    message.replace(place, scratch.size(), kept);
  }
  return message;
}

/// Runs one job; an interrupt ends its tools. The files of a job that failed stay in `kept` or, if
/// that is empty, in a scratch folder until the next run.
characterise::SynthesisResult result_of(const RouteCommand& command,
                                        const characterise::SynthesisJob& job,
                                        const devices::Device& device, const std::string& tools,
                                        const fs::path& kept) {
  ScratchFolder scratch = value_or_exit(ScratchFolder::make());
  const fs::path store = scratch.path() / "result.sqlite";
  const characterise::JobRunOptions options = {
      .synthesis = command.synthesis, .keep = kept, .progress = [&](int, double seconds) {
        show_progress(fmt::format("{} on {}: {:.0f} s", job.top, device.name, seconds));
      }};
  const characterise::JobRun run =
      value_or_exit(run_jobs({{.hash = job.top, .label = job.top, .job = [&] { return job; }}},
                             device, tools, store, options));
  show_progress("");
  if (run.interrupted_by != 0) throw Exit::interrupted(run.interrupted_by);
  if (!run.failed.empty()) {
    const characterise::FailedJob& failed = run.failed.front();
    const Error error = {.message = kept.empty() ? failed.message
                                                 : with_kept_names(failed, kept.string())};
    scratch.keep_for(error);
    fail(error);
  }
  auto opened = value_or_exit(characterise::ResultStore::open(store));
  return value_or_exit(opened.find(job.top)).value();
}

void run(const RouteCommand& command) {
  const LoadedScene loaded = value_or_exit(load(command.scene));
  const devices::Device device = value_or_exit(devices::find_device(loaded.scene.system.device));
  const characterise::SynthesisJob job = job_of(command, loaded);
  std::optional<FolderLock> held;
  if (!command.work.empty()) held.emplace(lock_folder(command.work));
  const std::string tools = value_or_exit(tool_versions(device, command.synthesis.effort));
  const fs::path kept = kept_folder(command, job, device, tools);
  if (!kept.empty()) {
    value_or_exit(check_replaced_folder(kept, inputs_of(command.scene, loaded.scene)));
  }
  const characterise::SynthesisResult result = result_of(command, job, device, tools, kept);
  command.scene.json ? print_json(job, device, result, tools) : print_text(job, device, result);
  if (!kept.empty()) tell(fmt::format("netlists and logs are in {}", kept.string()));
  end_if_router_is_missing(device);
}

}  // namespace

void add_route(CLI::App& app) {
  const Verb verb(
      app, "route",
      "area and clock of the whole system on its device, placed and routed where a router "
      "is there; or of references alone");
  auto command = std::make_shared<RouteCommand>();
  add_options(verb, *command);
  verb.when_chosen([command] { run(*command); });
}

}  // namespace mixcmp::cli

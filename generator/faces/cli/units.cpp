#include "generator/tasks/units.hpp"

#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "generator/faces/cli/characterise_table.hpp"
#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/verb.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/present/report/json_text.hpp"
#include "generator/synthesis/components/unit_library.hpp"
#include "model/base/common/output_file.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;

struct UnitsCommand {
  std::string device;
  std::vector<fs::path> scenes;
  fs::path output;
  int units_of_a_template = tasks::UnitsRequest().units_of_a_template;
  std::vector<std::string> templates;
  bool json = false;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
};

void run(UnitsCommand& command) {
  const devices::Device device = value_or_exit(devices::find_device(command.device));
  if (command.output.empty()) {
    const std::optional<fs::path> folder = components::unit_library_folder();
    if (!folder) {
      fail({.field = "--output",
            .message = "there is no folder for caches",
            .received = "neither $XDG_CACHE_HOME nor $HOME",
            .accepted = "the path of the library"});
    }
    value_or_exit(make_writable_folder(*folder));
    command.output = *folder / (device.name + ".csv");
  }
  tasks::UnitsRequest request{.scenes = {},
                              .device = device,
                              .library = command.output,
                              .templates = {command.templates.begin(), command.templates.end()},
                              .units_of_a_template = command.units_of_a_template,
                              .workers = command.jobs,
                              .progress = tell_progress};
  for (const fs::path& scene : command.scenes) request.scenes.push_back({scene});
  value_or_exit(check_outputs({command.output}, command.scenes));
  const tasks::UnitsReport report = value_or_exit(tasks::make_unit_library(request));
  show_progress("");
  for (const characterise::FailedJob& job : report.failed) {
    tell(fmt::format("{}: {}", job.label, job.message));
  }
  if (report.interrupted_by != 0) {
    tell("interrupted; the same command goes on");
    throw Exit::interrupted(report.interrupted_by);
  }
  const nlohmann::ordered_json json = {{"library", command.output.string()},
                                       {"candidates", report.candidates},
                                       {"measured", report.measured},
                                       {"kept", report.kept},
                                       {"failed", report.failed.size()}};
  const std::string text =
      fmt::format("{} units of {} scenes, {} measured, {} kept\n{}\n", report.candidates,
                  command.scenes.size(), report.measured, report.kept, command.output.string());
  print(command.json ? report::json_text(json) : text);
  if (!report.failed.empty()) throw Exit(ExitCode::mistake);
}

}  // namespace

void add_units(CLI::App& app) {
  const Verb verb(app, "units",
                  "measure a library of unit areas, from which optimise predicts other areas");
  auto command = std::make_shared<UnitsCommand>();
  verb.option("SCENE", command->scenes, "scenes whose units are candidates").required();
  verb.option("--device", command->device, "a device of the family").required();
  verb.option("-o,--output", command->output,
              "the library; units that it has are kept (default: where optimise looks, "
              "$XDG_CACHE_HOME/mixcmp/units/DEVICE.csv)");
  verb.option("--units", command->units_of_a_template, "so many of each template (default: 60)")
      .check(within({10, 10'000}));
  verb.option("--template", command->templates,
              "only units of this template, such as fp_add; may be repeated (default: all)");
  verb.option("--jobs", command->jobs, "at a time (default: one a processor)")
      .check(within(settings::limits::threads));
  verb.flag("--json", command->json, "print the result as JSON");
  verb.when_chosen([command] { run(*command); });
}

}  // namespace mixcmp::cli

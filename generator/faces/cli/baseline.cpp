#include "generator/software/baseline.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/options.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/present/report/json_text.hpp"
#include "model/base/common/scratch_folder.hpp"

namespace mixcmp::cli {
namespace {

struct BaselineCommand {
  SceneOptions scene;
  software::BaselineOptions run;
  bool csv = false;
};

void add_options(const Verb& verb, BaselineCommand& command) {
  add_scene_options(verb, command.scene);
  verb.flag("--csv", command.csv, "print the rates as CSV").excludes("--json");
  verb.option("--threads", command.run.threads, "\"all cores\" (default: the machine's)")
      .check(within(settings::limits::threads));
  verb.option("--rounds", command.run.rounds, "measurements of each kernel (default: 5)")
      .check(within({1, 1000}));
  verb.option("--seconds", command.run.seconds,
              "that one measurement takes, 0.001..600 (default: 0.5)")
      .check(between(0.001, 600, "S"));
  verb.option("--sample", command.run.sample,
              "comparisons held against the golden model, about, 1..16777216 (default: 4096)")
      .check(whole(1, std::uint64_t{1} << 24));
  verb.option("--work", command.run.work,
              "folder that keeps source, program and logs (default: none are kept)");
}

void run(const BaselineCommand& command) {
  const LoadedScene loaded = value_or_exit(load(command.scene));
  value_or_exit(check_has_data(loaded, "a baseline needs data to run on"));
  software::BaselineOptions options = command.run;
  std::optional<ScratchFolder> scratch;
  std::optional<FolderLock> held;
  if (options.work.empty()) {
    scratch.emplace(value_or_exit(ScratchFolder::make()));
    options.work = scratch->path();
  } else {
    std::vector<std::filesystem::path> outputs;
    for (const char* name :
         {"comparison", "comparison.cpp", "compile.log", "data.bin", "run.log"}) {
      outputs.push_back(options.work / name);
    }
    value_or_exit(check_outputs(outputs, inputs_of(command.scene, loaded.scene)));
    held.emplace(lock_folder(options.work));
  }
  options.progress = show_progress;
  const auto measured = software_baseline(loaded.scene, *loaded.data, options);
  if (!measured.ok() && scratch) scratch->keep_for(measured.error());
  const software::Baseline& baseline = value_or_exit(measured);
  show_progress("");
  if (command.scene.json) {
    print(report::json_text(to_json(baseline)));
  } else {
    print(command.csv ? to_csv(baseline) : to_text(baseline));
  }
  if (!baseline.passed()) throw Exit(ExitCode::refuted);
}

}  // namespace

void add_baseline(CLI::App& app) {
  const Verb verb(app, "baseline",
                  "the comparison in software on this machine, in double and with float filters");
  auto command = std::make_shared<BaselineCommand>();
  add_options(verb, *command);
  verb.when_chosen([command] { run(*command); });
}

}  // namespace mixcmp::cli

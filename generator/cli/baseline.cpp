#include "generator/software/baseline.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "generator/cli/exit.hpp"
#include "generator/cli/options.hpp"
#include "generator/cli/scratch.hpp"
#include "generator/cli/verbs.hpp"

namespace mixcmp::cli {
namespace {

struct BaselineCommand {
  SceneOptions scene;
  gen::BaselineOptions run;
  bool csv = false;
};

void add_options(CLI::App& verb, BaselineCommand& command) {
  add_scene_options(verb, command.scene);
  verb.add_flag("--csv", command.csv, "print the rates as CSV")->excludes("--json");
  verb.add_option("--threads", command.run.threads, "\"all cores\" (default: the machine's)")
      ->check(CLI::Range(1u, 1024u));
  verb.add_option("--rounds", command.run.rounds, "measurements of each kernel (default: 5)")
      ->check(CLI::Range(1, 1000));
  verb.add_option("--seconds", command.run.seconds, "that one measurement takes (default: 0.5)")
      ->check(CLI::Range(0.001, 600.0));
  verb.add_option("--sample", command.run.sample,
                  "comparisons held against the golden model, about (default: 4096)")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 24));
  verb.add_option("--work", command.run.work,
                  "folder that keeps source, program and logs (default: none are kept)");
}

/// A line that is overwritten, on a terminal only.
void show_progress(const std::string& text) {
  if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\x1b[K{}", text);
}

model::Result<model::Done> prepare(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (!failed) return model::Done{};
  return model::Error{.file = folder.string(),
                      .field = "--work",
                      .message = "cannot be written: " + failed.message()};
}

void run(const BaselineCommand& command) {
  const LoadedScene loaded = value_or_exit(load(command.scene));
  if (!loaded.data) {
    value_or_exit<model::Done>(model::Error{.file = command.scene.scene.string(),
                                            .field = "data",
                                            .message = "a baseline needs data to run on",
                                            .received = "a scene without [data]",
                                            .accepted = "[data] with items or file"});
  }
  const Scratch scratch;
  gen::BaselineOptions options = command.run;
  if (options.work.empty()) options.work = scratch.path();
  value_or_exit(prepare(options.work));
  options.progress = show_progress;
  const gen::Baseline baseline =
      value_or_exit(software_baseline(loaded.scene, *loaded.data, options));
  show_progress("");
  if (command.scene.json) {
    fmt::print("{}\n", to_json(baseline).dump(2));
  } else {
    fmt::print("{}", command.csv ? to_csv(baseline) : to_text(baseline));
  }
  if (!baseline.passed()) throw Exit{2};
}

}  // namespace

void add_baseline(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "baseline", "the comparison in software on this machine, in double and with float filters");
  auto command = std::make_shared<BaselineCommand>();
  add_options(*verb, *command);
  verb->callback([command] { run(*command); });
}

}  // namespace mixcmp::cli

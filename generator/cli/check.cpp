#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "generator/cli/exit.hpp"
#include "generator/cli/options.hpp"
#include "generator/cli/verbs.hpp"
#include "model/scene/summary.hpp"

namespace mixcmp::cli {
namespace {

void run(const SceneOptions& options) {
  const LoadedScene loaded = value_or_exit(load(options));
  const model::Summary summary =
      model::summarise(loaded.scene, loaded.data ? &*loaded.data : nullptr);
  fmt::print("{}", options.json ? to_json(summary).dump(2) + "\n" : to_text(summary));
}

}  // namespace

void add_check(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("check", "parse a scene; say what was understood and what it requires");
  auto options = std::make_shared<SceneOptions>();
  add_scene_options(*verb, *options);
  verb->callback([options] { run(*options); });
}

}  // namespace mixcmp::cli

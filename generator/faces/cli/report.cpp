#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/report_maker.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/present/report/json_text.hpp"
#include "model/base/common/output_file.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;

struct ReportCommand {
  PlanningOptions planning;
  ReportChoice choice;
  fs::path output;
};

/// The command with the options that change the page.
std::string command_of(const ReportCommand& command) {
  const std::vector<std::string> without(command.choice.without.begin(),
                                         command.choice.without.end());
  return command_line("report", command.planning.scene)
      .add("--table", command.planning.table.filename().string())
      .add_flag("--beside-paper", command.choice.beside_paper)
      .add_each("--without", without)
      .text();
}

nlohmann::ordered_json json_of(const fs::path& output, const page::Page& page,
                               const std::vector<std::string>& not_done) {
  nlohmann::ordered_json sections = nlohmann::ordered_json::array();
  for (const page::Section& section : page.sections) {
    sections.push_back({{"id", section.id}, {"title", section.title}});
  }
  return {{"report", output.string()}, {"sections", sections}, {"not_done", not_done}};
}

void run(const ReportCommand& command) {
  const SceneOptions& options = command.planning.scene;
  const LoadedScene loaded = value_or_exit(load(options));
  const fs::path output =
      command.output.empty() ? fs::path(loaded.scene.name + ".html") : command.output;
  std::vector<fs::path> inputs = inputs_of(options, loaded.scene);
  inputs.push_back(command.planning.table);
  value_or_exit(check_outputs({output}, inputs));
  value_or_exit(check_writable({output}));
  ReportChoice choice = command.choice;
  choice.command = command_of(command);
  ReportMaker maker(command.planning, loaded, std::move(choice));
  const page::Page page = maker.make();
  value_or_exit(write_file(output, to_html(page)));
  print(options.json ? report::json_text(json_of(output, page, maker.not_done()))
                     : fmt::format("{}: {} sections\n", output.string(), page.sections.size()));
  end_if_incomplete(maker.not_done());
}

}  // namespace

void add_report(CLI::App& app) {
  const Verb verb(app, "report",
                  "write one HTML file that shows the scene, its proof, rates, plan and hardware");
  auto command = std::make_shared<ReportCommand>();
  add_scene_options(verb, command->planning.scene);
  verb.option("-o,--output", command->output, "HTML file to write (default: NAME.html)");
  verb.option("--table", command->planning.table,
              "areas and clocks, made by mixcmp characterise (default: "
              "characterisation/SCENE-DEVICE.csv beside the scene)");
  verb.list_option(
          "--without",
          [command](const std::vector<std::string>& words) {
            command->choice.without = {words.begin(), words.end()};
          },
          "slow parts to leave out: profile,plan,front,waves; the front is a part of the plan")
      .separated_by(',')
      .one_of({"profile", "plan", "front", "waves"});
  verb.flag("--beside-paper", command->choice.beside_paper,
            "also draw the paper's published numbers; the scene should be its benchmark");
  verb.when_chosen([command] { run(*command); });
}

}  // namespace mixcmp::cli

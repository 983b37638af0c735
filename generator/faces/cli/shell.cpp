#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "generator/faces/cli/command_table.hpp"
#include "generator/faces/cli/completion.hpp"
#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/manual.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/verb.hpp"
#include "generator/faces/cli/verbs.hpp"

/// The verbs that tell a shell and `man` about all verbs, themselves included.
namespace mixcmp::cli {
namespace {

/// Writes one page for the program and one for each verb.
void write_pages(const std::filesystem::path& folder, const CommandTable& table) {
  value_or_exit(make_writable_folder(folder));
  std::vector<std::pair<std::filesystem::path, std::string>> pages;
  pages.emplace_back(folder / "mixcmp.1", manual_page(table));
  for (const CommandEntry& verb : table.verbs) {
    pages.emplace_back(folder / fmt::format("mixcmp-{}.1", verb.name), manual_page(table, verb));
  }
  write_together(pages);
}

std::string manual_of(const std::string& name, const CommandTable& table) {
  const auto verb = std::find_if(table.verbs.begin(), table.verbs.end(),
                                 [&](const CommandEntry& entry) { return entry.name == name; });
  return verb == table.verbs.end() ? manual_page(table) : manual_page(table, *verb);
}

}  // namespace

void add_completion(CLI::App& app) {
  const Verb verb(app, "completion", "print a script that completes mixcmp in a shell");
  auto shell = std::make_shared<std::string>();
  verb.option("SHELL", *shell, "the shell; bash reads: source <(mixcmp completion bash)")
      .required()
      .one_of({"bash", "zsh", "fish"});
  verb.when_chosen([shell] { print(completion_script(*shell)); });
}

void add_manual(CLI::App& app) {
  const Verb verb(app, "manual",
                  "print a manual page in roff; to read it: mixcmp manual | man -l -");
  auto name = std::make_shared<std::string>();
  auto folder = std::make_shared<std::filesystem::path>();
  const Option named =
      verb.option("VERB", *name, "the verb that the page is of (default: the program's own page)")
          .one_of(verbs_of(app));
  verb.option("-o,--output", *folder, "directory for the pages of the program and of all verbs")
      .excludes(named);
  verb.when_chosen([name, folder, &app] {
    const CommandTable table = command_table(app);
    folder->empty() ? print(manual_of(*name, table)) : write_pages(*folder, table);
  });
}

}  // namespace mixcmp::cli

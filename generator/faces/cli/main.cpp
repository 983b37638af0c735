#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "generator/faces/cli/completion.hpp"
#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/usage.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/faces/cli/version.hpp"
#include "generator/hardware/emit/version.hpp"
#include "model/base/common/quote.hpp"

namespace {

using mixcmp::cli::Exit;
using mixcmp::cli::ExitCode;

/// Opens /dev/null, read-only, in place of standard streams that are closed. Otherwise the first
/// output file would get the descriptor of standard output, and receive the printed text.
void occupy_standard_streams() {
  while (true) {
    const int descriptor = open("/dev/null", O_RDONLY);
    if (descriptor > STDERR_FILENO || descriptor < 0) {
      close(descriptor);
      return;
    }
  }
}

/// Adds --version, and the two options that go only with it.
void add_version_options(CLI::App& app) {
  CLI::Option* version = app.set_version_flag("--version", std::string(mixcmp::emit::version),
                                              "print version and commit");
  const std::string verbose = "with --version: also compiler, libraries and tools";
  const std::string json = "with --version: all of that as JSON";
  app.add_flag("--verbose", verbose)->needs(version);
  app.add_flag("--json", json)->needs(version);
}

void print_version(const CLI::App& app) {
  using mixcmp::cli::VersionDetail;
  if (app.count("--json") > 0) return mixcmp::cli::print(mixcmp::cli::version_json());
  const bool full = app.count("--verbose") > 0;
  mixcmp::cli::print(mixcmp::cli::version_text(full ? VersionDetail::full : VersionDetail::line));
}

void parse_and_run(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) {
      throw CLI::RequiredError("A verb (" + mixcmp::cli::verb_names(app) + ")");
    }
  } catch (const CLI::CallForHelp&) {
    const auto verbs = app.get_subcommands();
    return mixcmp::cli::print(verbs.empty() ? app.help() : verbs.front()->help());
  } catch (const CLI::CallForVersion&) {
    return print_version(app);
  } catch (const CLI::ParseError& error) {
    mixcmp::cli::fail(mixcmp::cli::usage_error(app, error));
  }
}

/// Checks that each argument is one line of UTF-8, since arguments are written into comments of
/// generated files, into plans and into JSON. An empty argument is also refused: an empty path
/// would count as an absent option, and its file would not be written.
void check_arguments(int argc, char** argv) {
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    if (!mixcmp::is_one_line(word)) {
      mixcmp::cli::fail({.field = fmt::format("argument {}", k),
                         .message = "cannot be written into files",
                         .received = mixcmp::in_quotes(word),
                         .accepted = "UTF-8 without control characters"});
    }
    if (!word.empty() && !(word.starts_with("--") && word.ends_with('='))) continue;
    const std::string before = word.empty() ? (k > 1 ? argv[k - 1] : "") : std::string(word);
    mixcmp::cli::fail({.field = before, .message = "an empty argument", .accepted = "a text"});
  }
}

void check_working_directory() {
  std::error_code failed;
  if (!std::filesystem::current_path(failed).empty()) return;
  mixcmp::cli::fail({.message = "there is no working directory: " + failed.message(),
                     .accepted = "one that exists"});
}

void run(int argc, char** argv) {
  CLI::App app("Turns a numerical comparison, the sign of f(x) - g(y), into verified Verilog.",
               "mixcmp");
  add_version_options(app);
  app.require_subcommand(0, 1);
  mixcmp::cli::add_new(app);
  mixcmp::cli::add_check(app);
  mixcmp::cli::add_generate(app);
  mixcmp::cli::add_verify(app);
  mixcmp::cli::add_profile(app);
  mixcmp::cli::add_characterise(app);
  mixcmp::cli::add_optimise(app);
  mixcmp::cli::add_explore(app);
  mixcmp::cli::add_devices(app);
  mixcmp::cli::add_doctor(app);
  mixcmp::cli::add_baseline(app);
  mixcmp::cli::add_route(app);
  mixcmp::cli::add_sweep(app);
  mixcmp::cli::add_units(app);
  mixcmp::cli::add_completion(app);
  mixcmp::cli::add_report(app);
  mixcmp::cli::add_manual(app);  // the last one, which names all verbs
  if (argc > 1 && argv[1] == std::string_view(mixcmp::cli::complete_option)) {
    const std::vector<std::string> words(argv + 2, argv + argc);
    return mixcmp::cli::print(completions(mixcmp::cli::command_table(app), words));
  }
  check_working_directory();
  check_arguments(argc, argv);
  parse_and_run(app, argc, argv);
}

/// Tells of a failure that no verb expects, such as no memory or a failing file system.
Exit unexpected_end(const char* why) {
  // A library that fails for want of a working directory may say "out of memory" (HiGHS).
  std::error_code failed;
  const std::filesystem::path ignored = std::filesystem::current_path(failed);
  Exit exit(ExitCode::mistake);
  exit.error = mixcmp::Error{.message = std::string("ended before its time: ") +
                                        (failed ? "the working directory is gone" : why)};
  mixcmp::cli::tell(exit.error->to_string());
  return exit;
}

/// Ends the program before all is done. With --json, which is a word of its own in every verb, the
/// error is also an object on standard output.
int end_early(const Exit& exit, int argc, char** argv) {
  const bool json = std::find(argv, argv + argc, std::string_view("--json")) != argv + argc;
  if (json) mixcmp::cli::print_error_as_json(exit);
  return exit.code;
}

}  // namespace

int main(int argc, char** argv) {
  occupy_standard_streams();
  mixcmp::cli::start_console();
  signal(SIGCHLD, SIG_DFL);  // where a parent ignored it, no exit code of a tool could be read
  signal(SIGXFSZ, SIG_IGN);  // at a file size limit, write() fails: whoever writes reports it
  try {
    run(argc, argv);
  } catch (const Exit& exit) {
    return end_early(exit, argc, argv);
  } catch (const std::bad_alloc&) {
    return end_early(unexpected_end("out of memory"), argc, argv);
  } catch (const std::exception& error) {
    return end_early(unexpected_end(error.what()), argc, argv);
  }
  return static_cast<int>(ExitCode::done);
}

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <string>

#include "generator/cli/exit.hpp"
#include "generator/cli/usage.hpp"
#include "generator/cli/verbs.hpp"
#include "generator/emit/version.hpp"

int main(int argc, char** argv) {
  CLI::App app("Turns a numerical comparison, the sign of f(x) - g(y), into verified Verilog.",
               "mixcmp");
  app.set_version_flag("--version", std::string(mixcmp::gen::version));
  app.require_subcommand(0, 1);
  mixcmp::cli::add_check(app);
  mixcmp::cli::add_generate(app);
  mixcmp::cli::add_verify(app);
  mixcmp::cli::add_profile(app);
  mixcmp::cli::add_characterise(app);
  mixcmp::cli::add_optimise(app);
  mixcmp::cli::add_explore(app);
  mixcmp::cli::add_doctor(app);
  mixcmp::cli::add_baseline(app);
  mixcmp::cli::add_route(app);
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) {
      throw CLI::RequiredError(
          "A verb (check, generate, verify, profile, characterise, optimise, explore, doctor, "
          "baseline, route)");
    }
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    fmt::print(stderr, "mixcmp: {}\n", mixcmp::cli::usage_error(app, error));
    return 1;
  } catch (const mixcmp::cli::Exit& exit) {
    return exit.code;
  }
  return 0;
}

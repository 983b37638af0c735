#pragma once

#include <CLI/CLI.hpp>

/// One function a verb: it adds its subcommand, whose callback runs it. A user's mistake is printed
/// to stderr and ends the program with exit code 1; `verify` ends with 2 where the hardware and the
/// golden model disagree, `check --prove` where Gappa refuses a bound, `baseline` where
/// software and the golden model do.
namespace mixcmp::cli {

void add_check(CLI::App& app);
void add_generate(CLI::App& app);
void add_verify(CLI::App& app);
void add_profile(CLI::App& app);
void add_characterise(CLI::App& app);
void add_optimise(CLI::App& app);
void add_explore(CLI::App& app);
void add_doctor(CLI::App& app);
void add_baseline(CLI::App& app);
void add_route(CLI::App& app);

}  // namespace mixcmp::cli

#pragma once

namespace CLI {
class App;
}

/// One function for each verb: it adds the verb's subcommand, whose callback runs it and throws
/// Exit (exit.hpp) where it does not end well.
namespace mixcmp::cli {

void add_new(CLI::App& app);
void add_check(CLI::App& app);
void add_generate(CLI::App& app);
void add_verify(CLI::App& app);
void add_profile(CLI::App& app);
void add_characterise(CLI::App& app);
void add_optimise(CLI::App& app);
void add_explore(CLI::App& app);
void add_devices(CLI::App& app);
void add_doctor(CLI::App& app);
void add_baseline(CLI::App& app);
void add_route(CLI::App& app);
void add_sweep(CLI::App& app);
void add_completion(CLI::App& app);
void add_report(CLI::App& app);
void add_units(CLI::App& app);
void add_manual(CLI::App& app);

}  // namespace mixcmp::cli

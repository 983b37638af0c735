#pragma once

#include "generator/cli/characterise_options.hpp"

namespace mixcmp::cli {

/// The table to which `characterise` writes: that of -o, or the default one.
std::filesystem::path table_of(const CharacteriseCommand& command, const scene::Scene& scene,
                               const devices::Device& device);

/// The options of a campaign; with --quick its lanes are chosen, which takes a profile of the data.
/// Ends the program on an error.
components::CharacteriseOptions prepared_options(const CharacteriseCommand& command,
                                                 const LoadedScene& loaded,
                                                 const devices::Device& device);

/// Measures the components that the command asks for and writes the table, unless a signal has
/// interrupted it or there is nothing to write. Ends the program on an error.
components::CharacteriseReport measure_table(const CharacteriseCommand& command,
                                             const LoadedScene& loaded);

/// Puts rows into the table of the command, in place of those of the same components; other rows
/// stay as they are. Returns the table. Ends the program on an error.
characterise::Characterisation add_to_table(const CharacteriseCommand& command,
                                            const LoadedScene& loaded,
                                            const devices::Device& device,
                                            std::vector<characterise::Measurement> rows);

/// Refuses a table that would be written over one of these inputs, or cannot be written.
void check_place(const std::filesystem::path& table, std::vector<std::filesystem::path> inputs);

/// Whether a table of this report is not written.
bool nothing_measured(const components::CharacteriseReport& report);

/// Tells which components failed, and how an interrupted run goes on; ends the program if there is
/// anything to tell.
void end_if_unfinished(const components::CharacteriseReport& report);

}  // namespace mixcmp::cli

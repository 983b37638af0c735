#pragma once

#include "generator/faces/cli/characterise_options.hpp"
#include "model/plan/optimise/rates.hpp"

namespace mixcmp::cli {

/// Shows how many jobs of a campaign have ended, and about how long the others take.
void tell_progress(int finished, int jobs, double seconds);

/// The table to which `characterise` writes: that of -o, or the default one.
std::filesystem::path table_of(const CharacteriseCommand& command, const scene::Scene& scene,
                               const devices::Device& device);

/// The options of a campaign; with --quick its lanes are chosen by `counted`, or where that is null
/// by rates_of_choice. Ends the program on an error.
components::CharacteriseOptions prepared_options(const CharacteriseCommand& command,
                                                 const LoadedScene& loaded,
                                                 const devices::Device& device,
                                                 const optimise::Rates* counted = nullptr);

/// The recomputation rates by which --quick chooses lanes, counted on the scene's data: of all
/// inputs and precisions that the command names. Ends the program on an error.
optimise::Rates rates_of_choice(const CharacteriseCommand& command, const LoadedScene& loaded);

/// Measures the components that the command asks for and writes the table, unless a signal has
/// interrupted it or there is nothing to write. With --quick lanes are chosen by `counted`, or
/// where that is null by rates_of_choice. Ends the program on an error.
components::CharacteriseReport measure_table(const CharacteriseCommand& command,
                                             const LoadedScene& loaded,
                                             const optimise::Rates* counted = nullptr);

/// Puts rows into the table of the command, in place of those of the same components; other rows
/// stay as they are. Returns the table. Ends the program on an error.
measured::Characterisation add_to_table(const CharacteriseCommand& command,
                                        const LoadedScene& loaded, const devices::Device& device,
                                        std::vector<measured::Measurement> rows);

/// Refuses a table that would be written over one of these inputs, or cannot be written.
void check_place(const std::filesystem::path& table, std::vector<std::filesystem::path> inputs);

/// Whether a table of this report is not written.
bool nothing_measured(const components::CharacteriseReport& report);

/// Tells which components failed, and how an interrupted run goes on; ends the program if there is
/// anything to tell.
void end_if_unfinished(const components::CharacteriseReport& report);

}  // namespace mixcmp::cli

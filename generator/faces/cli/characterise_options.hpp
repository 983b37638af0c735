#pragma once

#include "generator/faces/cli/options.hpp"
#include "generator/faces/cli/suite_file.hpp"
#include "generator/synthesis/components/characterise.hpp"

namespace mixcmp::cli {

/// The options of `characterise` as the user wrote them.
struct CharacteriseCommand {
  SceneOptions scene;
  std::string precisions;  ///< empty: all that the scene can have
  std::string bounds;      ///< empty: those that a profile counts of the scene
  std::string inputs = "exact,rounded";
  std::string multipliers = "both";
  std::string components;  ///< empty: all that the scene's systems have
  std::string ports = "1-8,12,16,24,32,48,64,96,128";
  std::string exponents;             ///< empty: as the scene says
  std::string initiation_intervals;  ///< of references; empty: as the scene says
  std::string reference_targets;     ///< MHz; empty: as the scene says, or the usual ones
  bool quick = false;
  bool area_only = false;
  int seeds = 3;
  unsigned jobs = 0;  ///< 0: one per processor
  std::filesystem::path output;
  std::filesystem::path store;
  std::vector<std::filesystem::path>
      reports;  ///< of a vendor's tool, to import in place of measuring
};

void add_characterise_options(const Verb& verb, CharacteriseCommand& command);

/// A group's run as [[characterise]] of a sweep has it, as a command. Errors name the group's place
/// and the option.
Result<CharacteriseCommand> characterise_command(const SuiteRun& run);

/// The keys that a [[characterise]] group of a sweep may have.
const GroupForm& characterise_group();

/// Converts the options of `characterise`. Errors name the option.
Result<components::CharacteriseOptions> characterise_options(const CharacteriseCommand& command,
                                                             const scene::Scene& scene);

/// Reads a list such as "4-9,12": numbers that are `allowed`, each once, in rising order. Errors
/// name `option`.
Result<std::vector<int>> number_list(const std::string& option, const std::string& text,
                                     settings::Limits allowed);

/// The command that makes the same table. It names the scene by its file name, without folders.
CommandLine characterise_command_line(const CharacteriseCommand& command);

}  // namespace mixcmp::cli

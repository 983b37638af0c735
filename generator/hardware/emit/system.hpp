#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "generator/hardware/emit/signature.hpp"
#include "model/design/design.hpp"

namespace mixcmp::emit {

struct GeneratedFile {
  std::string name;  ///< relative to the output's folder, "yosys/run"; Verilog has no folders
  std::string text;
  std::string cells = {};  ///< the family whose cell it is; see TechnologyCell
  bool is_script = false;  ///< the file may be executed
};

/// Everything that `generate` writes, in memory; the same design gives the same bytes.
struct GeneratedSystem {
  Signature signature;
  std::vector<GeneratedFile> files;  ///< Verilog, signature, file list, constraint
  /// Remarks for the user: stages that the delay table cannot bring under the period.
  std::vector<std::string> notes;
};

/// Generates all files of a design. `command` is printed in each header as the command that
/// regenerates the file: it must name no path, host or date.
Result<GeneratedSystem> generate_system(const design::Design& design, const std::string& command);

/// Lines for the head of a generated file: the version, the command that makes the file, and that
/// it is unencumbered.
std::vector<std::string> provenance(const Signature& signature, const std::string& command);

/// Lists these simulations of the design in its signature.
void set_simulations(GeneratedSystem& system, std::vector<SignatureSimulation> simulations);

/// Adds files for other tools to a generated system, and their names to its signature. An error
/// names a module whose name is too long.
Result<Done> add_project_files(GeneratedSystem& system, std::vector<GeneratedFile> files);

/// Writes the files as the whole content of `directory`: all or nothing. An existing directory is
/// replaced only if it is empty, or if it and its folders hold nothing but a previous output of
/// this program.
Result<Done> write_system(const GeneratedSystem& system, const std::filesystem::path& directory);

}  // namespace mixcmp::emit

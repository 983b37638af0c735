#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "generator/emit/signature.hpp"
#include "model/design/design.hpp"

namespace mixcmp::emit {

struct GeneratedFile {
  std::string name;  ///< no folders
  std::string text;
  std::string cells = {};  ///< of a family with cells of its own; see TechnologyCell
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

/// Writes the files as the whole content of `directory`: all or nothing. An existing directory is
/// replaced only where it is empty or holds nothing but a previous output of this program.
Result<Done> write_system(const GeneratedSystem& system, const std::filesystem::path& directory);

}  // namespace mixcmp::emit

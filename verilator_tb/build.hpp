#pragma once

#include <filesystem>
#include <string>

#include "generator/emit/signature.hpp"
#include "model/common/folder_lock.hpp"
#include "model/common/process.hpp"
#include "verilator_tb/clocked_block.hpp"

namespace mixcmp::verilator_tb {

/// A generated system in its folder.
struct System {
  std::filesystem::path directory;
  emit::Signature signature;

  /// Absolute paths of the Verilog files, in compile order.
  std::vector<std::filesystem::path> sources() const;
};

/// Finds the one signature in `directory` and reads it.
Result<System> load_system(const std::filesystem::path& directory);

enum class Waves {
  off,
  on,
};

struct BuildOptions {
  std::filesystem::path work_dir;  ///< builds are kept here, one folder for each content
  Waves waves = Waves::off;
  Progress progress;
  Waiting waiting = {};
};

/// The file in a build's folder that marks its simulator as whole.
constexpr const char* build_stamp = "complete";

struct Executable {
  std::filesystem::path path;
  double build_seconds = 0;  ///< 0: it was there already
};

/// The Verilog files that the system's signature names; an error names a missing one.
Result<SourceFiles> system_sources(const System& system);

/// The folder WORK/NAME-HASH. The hash is that of the command, the tool's version and all files
/// that the tool reads.
std::filesystem::path work_folder(const std::filesystem::path& work, const std::string& name,
                                  const std::string& version, const Command& command,
                                  const SourceFiles& inputs);

/// The error where a program is missing that compiles simulators.
std::optional<Error> missing_compiler();

/// Runs Verilator on the system together with our harness. A build is found again by the content of
/// everything that went into it; one that was interrupted starts anew (ccache keeps its objects).
/// Lane channels and reference datapaths are blocks (clocked_block.hpp), built once in folders of
/// their own, which other systems use, too.
Result<Executable> build_simulator(const System& system, const BuildOptions& options);

}  // namespace mixcmp::verilator_tb

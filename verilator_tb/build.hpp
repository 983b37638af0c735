#pragma once

#include <filesystem>
#include <string>

#include "generator/hardware/emit/signature.hpp"
#include "model/base/common/folder_lock.hpp"
#include "model/base/common/process.hpp"
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

/// Tells whether ccache is installed and can write its folders.
bool is_ccache_usable();

/// A folder in which a simulator, or a part of one, is built from `inputs`.
struct ModelBuild {
  std::filesystem::path folder;
  std::string prefix = {};  ///< of the model's C++ names, which Verilator makes
  std::string product;      ///< the program or the archive, a file of obj/
  Command compile;          ///< the call of Verilator or Icarus
  SourceFiles inputs;
};

/// Builds a program by its folder's build.mk, which also builds `parts` in their folders. A
/// complete product is used as it is. Any other starts anew with an empty obj/, so that no file
/// which another process runs is written over. All callers sort parts by the names of their
/// modules, so that two builds never wait for each other.
Result<Executable> make_program(const ModelBuild& program, const std::vector<ModelBuild>& parts,
                                const BuildOptions& options);

/// Runs Verilator on the system together with our harness. A build is found again by the content of
/// everything that went into it; one that was interrupted starts anew (ccache keeps its objects).
/// Lane channels and reference datapaths are blocks (clocked_block.hpp), built once in folders of
/// their own. Other systems also use these.
Result<Executable> build_simulator(const System& system, const BuildOptions& options);

}  // namespace mixcmp::verilator_tb

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "generator/hardware/emit/signature.hpp"
#include "model/base/common/scratch_folder.hpp"
#include "verilator_tb/harness/protocol.hpp"

namespace mixcmp::verilator_tb {

/// A GTKWave save file: the streams of one lane, or of its group of lanes, and the counters.
/// `marked` chooses the lane (0 without it) and sets marker A where that comparison was accepted
/// and B where it left.
struct SaveFile {
  std::filesystem::path waves;
  std::string scope;             ///< scope of the system's ports in the wave file, "TOP.top"
  std::uint64_t time_per_cycle;  ///< clock period in the wave file's time unit
  std::optional<harness::wire::Result> marked;
};

std::string gtkwave_save_file(const emit::Signature& signature, const SaveFile& options);
/// A save file that shows all ports of an engine.
std::string gtkwave_save_file(const emit::SignatureEngine& engine, const SaveFile& options);

/// Tells whether a file is an FST that its writer has closed: its blocks follow one another to the
/// end of the file, and header, geometry and hierarchy are among them (GTKWave's fstapi). This
/// finds a full disk, which simulators do not report.
bool is_whole_fst(const std::filesystem::path& path);

/// A wave file and the GTKWave save file that goes with it. Until both are complete, the simulator
/// writes into a folder of its own, beside the final path.
class WaveFile {
public:
  static Result<WaveFile> open(const std::filesystem::path& path);
  std::filesystem::path unfinished() const { return folder_.path() / "waves.fst"; }
  void set_save_file(std::string text) { save_file_text_ = std::move(text); }
  Result<Done> commit();

private:
  WaveFile(std::filesystem::path path, ScratchFolder folder)
      : path_(std::move(path)), folder_(std::move(folder)) {}

  std::filesystem::path path_;
  ScratchFolder folder_;
  std::string save_file_text_;
};

/// The waves' name with the ending .gtkw; empty for none.
std::filesystem::path save_file_beside(std::filesystem::path waves);

}  // namespace mixcmp::verilator_tb

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "generator/emit/signature.hpp"
#include "verilator_tb/harness/protocol.hpp"

namespace mixcmp::tb {

/// A GTKWave save file: the streams of one lane, grouped, and the counters. `marked` chooses the
/// lane (0 without it) and sets marker A where it was accepted and B where it left.
struct SaveFile {
  std::filesystem::path waves;
  std::string scope;             ///< of the system's ports, "TOP.top"
  std::uint64_t time_per_cycle;  ///< in the wave file's unit
  std::optional<wire::Result> marked;
};

std::string gtkwave_save_file(const gen::Signature& signature, const SaveFile& options);
/// Of an engine: all of its ports.
std::string gtkwave_save_file(const gen::SignatureEngine& engine, const SaveFile& options);

/// Beside the waves, under their name with the ending .gtkw.
model::Result<model::Done> write_save_file(const std::filesystem::path& waves,
                                           const std::string& text);

}  // namespace mixcmp::tb

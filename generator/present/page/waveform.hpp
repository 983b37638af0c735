#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "generator/present/page/element.hpp"

namespace mixcmp::page {

/// The value of a bus in one cycle.
struct WaveBeat {
  std::string text;  ///< short: a few letters fit into a cycle
  int color = -1;    ///< of chart colours; -1: none
  std::string tip;
};

struct WaveClock {};
/// A signal of one bit: the cycles in which it is 1.
struct WaveBit {
  std::set<std::uint64_t> high;
};
/// Cycles without a beat are drawn as idle.
struct WaveBus {
  std::map<std::uint64_t, WaveBeat> beats;
};

struct WaveRow {
  std::string name;
  std::variant<WaveClock, WaveBit, WaveBus> signal;
};

/// Cycles that are shown side by side, both included.
struct WaveWindow {
  std::uint64_t first;
  std::uint64_t last;
};

struct Waveform {
  std::string title;                ///< describes the picture to readers who cannot see it
  std::uint64_t cycle_zero = 0;     ///< the cycle that is numbered 0
  std::vector<WaveWindow> windows;  ///< in order; cycles between them are left out
  std::vector<WaveRow> rows;
};

Element draw(const Waveform& waveform);

}  // namespace mixcmp::page

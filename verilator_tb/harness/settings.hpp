#pragma once

#include <cstdint>
#include <string>

#include "traffic.hpp"

namespace mixcmp::harness {

struct Settings {
  Traffic::Kind traffic = Traffic::Kind::full_rate;
  std::uint64_t seed = 1;
  std::uint64_t hang_cycles = 50'000;
  std::string trace;
};

/// Reads the command line's "name=value" words. Only the host writes them.
inline Settings read_settings(int count, char** words) {
  Settings settings;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    const std::string name = word.substr(0, word.find('='));
    const std::string value = word.substr(word.find('=') + 1);
    if (name == "traffic" && value == "stressed") settings.traffic = Traffic::Kind::stressed;
    if (name == "seed") settings.seed = std::stoull(value);
    if (name == "hang_cycles") settings.hang_cycles = std::stoull(value);
    if (name == "trace") settings.trace = value;
  }
  return settings;
}

}  // namespace mixcmp::harness

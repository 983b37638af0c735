#pragma once

#include <string>
#include <vector>

#include "generator/hardware/emit/system.hpp"
#include "model/plan/optimise/switching.hpp"

namespace mixcmp::project {

/// A rule as programs get it.
struct SwitchingSpec {
  const optimise::SwitchingRule& rule;
  std::string name;                ///< of the scene
  std::string command;             ///< that makes these files, for their heads
  std::vector<std::string> plans;  ///< a line about each
  std::vector<int>
      comparisons_of_word;         ///< of each plan: comparisons that its counters count as one
  bool counts_comparisons = true;  ///< else the engine counts only recomputations
};

/// The rule as a header for C and C++, switching.h, and as a module for Python 3, switching.py.
/// They load the plans that optimise::SwitchingRule::next loads. The same sums are made in the same
/// order, in double.
std::vector<emit::GeneratedFile> switching_files(const SwitchingSpec& spec);

}  // namespace mixcmp::project

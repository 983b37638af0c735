#pragma once

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "verilated_fst_c.h"

namespace mixcmp::harness {

/// Declares the signals of a model among waves, in the scopes that its name has: "TOP system lane".
/// Verilator 5.006 makes a scope of each word; 5.032 makes one of the last word alone, so that the
/// scopes around it are opened and closed here.
template <class Trace = VerilatedFst>
class WavesScope {
public:
  explicit WavesScope(const std::string& name) {
    std::istringstream words(name);
    for (std::string word; words >> word;) outer_.push_back(word);
    if (!outer_.empty()) outer_.pop_back();
  }

  template <class Model>
  void declare(Model& model, VerilatedFstC* waves) {
    constexpr int all_levels = 99;
    if constexpr (requires { &Trace::pushPrefix; }) {
      waves->spTrace()->addInitCb(&open, this);
      model.trace(waves, all_levels);
      waves->spTrace()->addInitCb(&close, this);
    } else {
      model.trace(waves, all_levels);
    }
  }

private:
  /// Verilator's kind of scope has no name in those versions that lack it.
  template <class Kind>
  static void push(Trace* trace, void (Trace::*push_prefix)(const std::string&, Kind),
                   const std::string& word) {
    (trace->*push_prefix)(word, Kind::SCOPE_MODULE);
  }

  static void open(void* self, Trace* trace, std::uint32_t) {
    for (const std::string& word : static_cast<WavesScope*>(self)->outer_) {
      push(trace, &Trace::pushPrefix, word);
    }
  }

  static void close(void* self, Trace* trace, std::uint32_t) {
    for (std::size_t k = static_cast<WavesScope*>(self)->outer_.size(); k > 0; --k) {
      trace->popPrefix();
    }
  }

  std::vector<std::string> outer_;  ///< the scopes around the model's own
};

}  // namespace mixcmp::harness

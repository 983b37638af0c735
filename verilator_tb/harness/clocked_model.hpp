#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>

#include "settings.hpp"

namespace mixcmp::harness {

/// The model of the top with its clock and its waves, in Verilator (clocked_model.cpp) or in an
/// event-driven simulator (vpi_clocked_model.cpp, whose waves are the simulator's own).
class ClockedModel {
public:
  ClockedModel(const Settings& settings, int count, char** words);
  ~ClockedModel();

  /// The ports of the top, of the kind that it has (ports.hpp).
  template <class TopPorts>
  TopPorts ports();
  /// The streams in which an output is neither 0 nor 1 where that matters. Verilator has no such
  /// values.
  const std::set<std::uint32_t>& unknown_streams() const;

  /// Lowers the clock. Inputs are changed while it is high, outputs are read while it is low.
  void settle(std::uint64_t cycle);
  void rise(std::uint64_t cycle);

  void open_trace(const std::string& path);

private:
  struct Model;
  std::unique_ptr<Model> model_;
};

}  // namespace mixcmp::harness

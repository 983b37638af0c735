#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "model/emulator/kernels.hpp"
#include "model/error/lane.hpp"

namespace mixcmp::model::emulator {

/// A graph, and what is decided from it, as instructions on columns of doubles. Column k holds node
/// k of the graph; those of an absolute bound follow. Why it is exact: docs/emulator.md.
struct Code {
  int columns = 0;
  std::vector<std::pair<int, int>> inputs;        ///< column, operand
  std::vector<std::pair<int, double>> constants;  ///< column, value
  std::vector<Instruction> values;
  std::vector<Instruction> bounds;   ///< after the values, for decisions alone
  std::vector<TrustedRange> ranges;  ///< values outside: the golden model answers
  /// Operands inside this window have all their values inside `ranges`; none: no window is known.
  std::optional<OperandWindow> window;
  int f = -1, g = -1;
  DecisionRule decision;
  /// Outside means exceptional, and so undecided: the golden model need not be asked.
  bool doubtful_is_undecided = false;
};

/// `lane` is null for a reference, else the graph is the lane's. None where double does not hold
/// some format, or cannot be trusted with a constant or a bound.
std::optional<Code> make_code(const TypedGraph& graph, const Lane* lane);

}  // namespace mixcmp::model::emulator

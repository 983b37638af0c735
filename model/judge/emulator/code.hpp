#pragma once

#include <optional>
#include <vector>

#include "model/judge/emulator/column_blocks.hpp"
#include "model/judge/emulator/kernels.hpp"
#include "model/lane/error/lane.hpp"

namespace mixcmp::emulator {

/// A graph and its criterion, compiled to instructions on columns of doubles. Column k holds node k
/// of the graph; the columns of an absolute bound follow. docs/emulator.md proves that this is
/// exact.
struct Code {
  ColumnLayout layout;
  std::vector<Instruction> values;
  std::vector<Instruction> bounds;   ///< after the values, and only for decisions
  std::vector<TrustedRange> ranges;  ///< if a value is outside, the golden model answers
  /// If all operands are inside this window, all values are inside `ranges`. None if no such window
  /// is known.
  std::optional<OperandWindow> window;
  int f = -1, g = -1;
  FloatCriterion criterion;
  /// A value outside `ranges` is exceptional, so the lane is undecided and the golden model is not
  /// needed.
  bool doubtful_is_undecided = false;
};

/// Compiles a graph. `lane` is null for a reference; otherwise the graph is the lane's. None if
/// double does not hold some format, or cannot reproduce a constant or the criterion.
std::optional<Code> make_code(const TypedGraph& graph, const error::Lane* lane);

}  // namespace mixcmp::emulator

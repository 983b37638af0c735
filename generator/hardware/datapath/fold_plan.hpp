#pragma once

#include <optional>
#include <vector>

#include "model/comparison/expression/typed_graph.hpp"

namespace mixcmp::datapath {

/// A node of a folded datapath, with the properties that the plan depends on.
struct FoldedNode {
  enum class Kind {
    input,      ///< its value stays for a whole interval
    constant,   ///< its value is always there
    wires,      ///< no unit: its operand with another sign, or a sum that is compared with zero
    operation,  ///< a unit computes it
  };

  Kind kind;
  std::vector<NodeId> operands;
  int width;                   ///< bits of the value
  int latency = 0;             ///< cycles from the operands to the value
  std::size_t unit_class = 0;  ///< the class of an operation
};

/// Operations that compute the same function, and the units that they share.
struct UnitClass {
  std::vector<NodeId> operations;
  std::size_t units = 1;
  int cycles = 1;  ///< cycles that an operation keeps its unit; at most the interval
  /// The units have no registers of their own for operands: an operation starts in the cycle in
  /// which its operands come out of another unit.
  bool reads_results = false;
};

/// A datapath to be folded, so that one set of operands may enter every `interval` cycles.
struct FoldedGraph {
  int interval;
  std::vector<FoldedNode> nodes;  ///< in topological order
  std::vector<UnitClass> classes;
  std::vector<std::vector<NodeId>> compared;  ///< values that are read in the same cycle
};

/// When each node starts, and the unit of each operation.
struct FoldPlan {
  std::vector<int> starts;
  std::vector<std::size_t> units;  ///< index in the class; 0 for nodes that are no operations
};

/// A plan by list scheduling. In each cycle, operations start whose operands are ready and whose
/// unit is free in this phase; the operation with the longest way left to a verdict comes first. If
/// other operations read its result at once, their units must also be free. Returns nothing if an
/// operation would then wait for ever.
std::optional<FoldPlan> list_schedule(const FoldedGraph& graph);

/// A plan in which fewer bits wait in registers and units read from fewer places, while the
/// compared values are ready no later than with `plan`. It is the best that a bounded search finds.
FoldPlan reduce_storage(const FoldedGraph& graph, FoldPlan plan);

}  // namespace mixcmp::datapath

#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/hardware/datapath/schedule.hpp"
#include "generator/hardware/rtl/datapath_builder.hpp"
#include "model/comparison/expression/typed_graph.hpp"

namespace mixcmp::rtl {

/// The units of a folded datapath that several operations share. Each has a name and, for each
/// phase, the operands that it reads, through registers or straight from one other unit.
class SelectingUnits {
public:
  struct Unit {
    std::string name;
    TypedNode node;  ///< the unit's operation; an addition if it also subtracts
    std::vector<PhaseCase> cases;
  };

  SelectingUnits(const TypedGraph& graph, const datapath::Schedule& schedule, NamePool& pool);

  /// The unit of a node; null if the node shares no unit.
  Unit* find(NodeId node);
  /// The units by their indices in the schedule's shared_units.
  const std::map<std::size_t, Unit>& units() const { return units_; }

  /// Adds the operands that the unit of `node` reads when the node starts.
  void read(NodeId node, Literal phase, std::string comment, std::vector<Operand> operands);
  /// Sorts the operands of each unit by phase.
  void sort_by_phase();

private:
  std::map<std::size_t, Unit> units_;
  std::map<NodeId, std::size_t> unit_of_;
};

/// The operand with its sign changed: a net's or a constant's.
Operand sign_changed(const Operand& operand, int width);

}  // namespace mixcmp::rtl

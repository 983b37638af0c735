#pragma once

#include <vector>

#include "generator/present/page/pipeline.hpp"

namespace mixcmp::page {

/// The vertical places of a pipeline's units. Each cycle is a row; units that take no cycle have
/// rows of their own before the cycle in which they work.
class PipelineRows {
public:
  explicit PipelineRows(const Pipeline& pipeline);

  int first_row(int unit) const { return first_[unit]; }
  int last_row(int unit) const { return last_[unit]; }
  double top(int row) const { return tops_[row]; }
  double bottom(int row) const { return tops_[row] + heights_[row]; }
  /// The row of a cycle.
  int row_of_cycle(int cycle) const { return cycle_rows_[cycle]; }
  double height() const { return bottom(static_cast<int>(tops_.size()) - 1); }

private:
  void place_wires(const Pipeline& pipeline);
  void number_rows(const Pipeline& pipeline);
  void choose_heights(const Pipeline& pipeline);
  void stack(const Pipeline& pipeline);

  std::vector<int> levels_;        ///< of a unit without cycles: its place among those of its cycle
  std::vector<int> wire_rows_;     ///< [cycle]: rows for units without cycles
  std::vector<int> cycle_rows_;    ///< [cycle]: its row
  std::vector<int> first_, last_;  ///< [unit]
  std::vector<double> heights_, tops_;  ///< [row]
};

}  // namespace mixcmp::page

#include "generator/present/page/pipeline_rows.hpp"

#include <algorithm>

namespace mixcmp::page {
namespace {

constexpr double box_height = 38;    ///< of two lines of text
constexpr double cycle_height = 9;   ///< of a cycle in the middle of long units
constexpr double wires_height = 22;  ///< between the rows of units that are connected
constexpr double rank_height = 3;    ///< between other rows

bool takes_no_cycle(const PipelineUnit& unit) {
  return unit.start_cycle == unit.ready_cycle;
}

}  // namespace

PipelineRows::PipelineRows(const Pipeline& pipeline) {
  place_wires(pipeline);
  number_rows(pipeline);
  choose_heights(pipeline);
  stack(pipeline);
}

void PipelineRows::place_wires(const Pipeline& pipeline) {
  wire_rows_.assign(static_cast<std::size_t>(pipeline.cycles) + 1, 0);
  for (const PipelineUnit& unit : pipeline.units) {
    int level = 0;
    for (const int operand : unit.operands) {
      const PipelineUnit& before = pipeline.units[operand];
      if (takes_no_cycle(before) && before.start_cycle == unit.start_cycle) {
        level = std::max(level, levels_[operand] + 1);
      }
    }
    levels_.push_back(level);
    if (!takes_no_cycle(unit)) continue;
    int& rows = wire_rows_[unit.start_cycle];
    rows = std::max(rows, level + 1);
  }
}

void PipelineRows::number_rows(const Pipeline& pipeline) {
  int row = 0;
  for (const int wires : wire_rows_) {
    cycle_rows_.push_back(row + wires);
    row = cycle_rows_.back() + 1;
  }
  for (std::size_t k = 0; k < pipeline.units.size(); ++k) {
    const PipelineUnit& unit = pipeline.units[k];
    if (takes_no_cycle(unit)) {
      first_.push_back(cycle_rows_[unit.start_cycle] - wire_rows_[unit.start_cycle] + levels_[k]);
      last_.push_back(first_.back());
    } else {
      first_.push_back(cycle_rows_[unit.start_cycle]);
      last_.push_back(cycle_rows_[unit.ready_cycle - 1]);
    }
  }
}

/// Rows are as low as the boxes in them allow; a box over several rows widens them evenly.
void PipelineRows::choose_heights(const Pipeline& pipeline) {
  heights_.assign(static_cast<std::size_t>(cycle_rows_.back()) + 1, cycle_height);
  heights_.back() = 0;  // the cycle behind the result
  for (std::size_t k = 0; k < pipeline.units.size(); ++k) {
    double height = 0;
    for (int row = first_[k]; row <= last_[k]; ++row) height += heights_[row];
    const double missing = (box_height - height) / (last_[k] - first_[k] + 1);
    for (int row = first_[k]; row <= last_[k] && missing > 0; ++row) heights_[row] += missing;
  }
}

void PipelineRows::stack(const Pipeline& pipeline) {
  std::vector<bool> begins(heights_.size(), false);
  for (std::size_t k = 0; k < pipeline.units.size(); ++k) {
    if (!pipeline.units[k].operands.empty()) begins[first_[k]] = true;
  }
  double y = 0;
  for (std::size_t row = 0; row < heights_.size(); ++row) {
    if (row > 0) y += begins[row] ? wires_height : rank_height;
    tops_.push_back(y);
    y += heights_[row];
  }
}

}  // namespace mixcmp::page

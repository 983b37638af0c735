#pragma once

#include <vector>

#include "generator/present/page/pipeline_rows.hpp"

namespace mixcmp::page {

/// A connection from one unit to an operand of another.
struct PipelineWire {
  int from;
  int to;
  int item = -1;  ///< the column of its straight middle; -1: it passes no row
};

/// The horizontal places of a pipeline's units, and of the wires that pass rows between them. Items
/// in one row do not overlap, and connected items are near each other.
class PipelineColumns {
public:
  PipelineColumns(const Pipeline& pipeline, const PipelineRows& rows);

  double x(int unit) const { return items_[unit].x; }
  double box_width(int unit) const { return items_[unit].width; }
  double x_of_item(int item) const { return items_[item].x; }
  const std::vector<PipelineWire>& wires() const { return wires_; }
  double width() const;

private:
  /// A unit, or the part of a wire that passes rows.
  struct Item {
    double width;
    int first_row, last_row;
    double x = 0;
    std::vector<int> neighbours = {};
  };

  void add_units(const Pipeline& pipeline, const PipelineRows& rows);
  void add_wires(const Pipeline& pipeline, const PipelineRows& rows);
  void connect(int one, int other);
  void order_first(const Pipeline& pipeline);
  void settle(bool may_reorder);
  std::vector<double> wanted() const;
  void separate(const std::vector<double>& wanted);
  double distance(int left, int right) const;
  bool share_a_row(int one, int other) const;
  void move_to_the_left();

  std::vector<Item> items_;
  std::vector<PipelineWire> wires_;
  std::vector<int> order_;  ///< of items, from left to right
};

}  // namespace mixcmp::page

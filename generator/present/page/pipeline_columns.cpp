#include "generator/present/page/pipeline_columns.hpp"

#include <algorithm>
#include <numeric>

namespace mixcmp::page {
namespace {

constexpr double gap = 12;                                      ///< between boxes
constexpr double wire_width = 4;                                ///< of a wire that passes boxes
constexpr double letter_width = 6.9, small_letter_width = 6.2;  ///< of the page's style sheet

/// Counts the characters of UTF-8.
double letters(const std::string& text) {
  return static_cast<double>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  }));
}

double box_width_of(const PipelineUnit& unit) {
  const double text =
      std::max(letters(unit.title) * letter_width, letters(unit.detail) * small_letter_width);
  return std::max(48.0, text + 16);
}

}  // namespace

PipelineColumns::PipelineColumns(const Pipeline& pipeline, const PipelineRows& rows) {
  add_units(pipeline, rows);
  add_wires(pipeline, rows);
  order_first(pipeline);
  constexpr int sweeps = 80;
  for (int sweep = 0; sweep < sweeps; ++sweep) settle(sweep < sweeps / 2);
  move_to_the_left();
}

void PipelineColumns::add_units(const Pipeline& pipeline, const PipelineRows& rows) {
  for (std::size_t k = 0; k < pipeline.units.size(); ++k) {
    const int unit = static_cast<int>(k);
    items_.push_back({.width = box_width_of(pipeline.units[k]),
                      .first_row = rows.first_row(unit),
                      .last_row = rows.last_row(unit)});
  }
}

void PipelineColumns::add_wires(const Pipeline& pipeline, const PipelineRows& rows) {
  for (std::size_t k = 0; k < pipeline.units.size(); ++k) {
    const int to = static_cast<int>(k);
    for (const int from : pipeline.units[k].operands) {
      PipelineWire wire{from, to};
      const int first = rows.last_row(from) + 1, last = rows.first_row(to) - 1;
      if (first <= last) {
        wire.item = static_cast<int>(items_.size());
        items_.push_back({.width = wire_width, .first_row = first, .last_row = last});
        connect(from, wire.item);
        connect(wire.item, to);
      } else {
        connect(from, to);
      }
      wires_.push_back(wire);
    }
  }
}

void PipelineColumns::connect(int one, int other) {
  items_[one].neighbours.push_back(other);
  items_[other].neighbours.push_back(one);
}

/// Orders units in the order of a walk from the results back to the inputs. The wires of a tree
/// then do not cross.
void PipelineColumns::order_first(const Pipeline& pipeline) {
  const std::size_t units = pipeline.units.size();
  std::vector<bool> is_read(units, false), known(units, false);
  for (const PipelineUnit& unit : pipeline.units) {
    for (const int operand : unit.operands) is_read[operand] = true;
  }
  double next = 0;
  const auto place = [&](const auto& self, int unit) -> void {
    if (known[unit]) return;
    known[unit] = true;
    const std::vector<int>& operands = pipeline.units[unit].operands;
    double sum = 0;
    for (const int operand : operands) {
      self(self, operand);
      sum += items_[operand].x;
    }
    items_[unit].x = operands.empty() ? 100 * next++ : sum / static_cast<double>(operands.size());
  };
  for (std::size_t k = 0; k < units; ++k) {
    if (!is_read[k]) place(place, static_cast<int>(k));
  }
  for (const PipelineWire& wire : wires_) {
    if (wire.item >= 0) items_[wire.item].x = (items_[wire.from].x + items_[wire.to].x) / 2;
  }
  order_.resize(items_.size());
  std::iota(order_.begin(), order_.end(), 0);
}

/// One step: everything moves towards its neighbours, as far as there is room.
void PipelineColumns::settle(bool may_reorder) {
  const std::vector<double> places = wanted();
  if (may_reorder) {
    std::stable_sort(order_.begin(), order_.end(),
                     [&](int a, int b) { return places[a] < places[b]; });
  }
  separate(places);
}

std::vector<double> PipelineColumns::wanted() const {
  std::vector<double> places;
  for (const Item& item : items_) {
    double sum = item.x;
    for (const int neighbour : item.neighbours) sum += items_[neighbour].x;
    places.push_back(sum / static_cast<double>(item.neighbours.size() + 1));
  }
  return places;
}

/// Separates from the left and from the right. Both results keep all distances, and so does their
/// mean.
void PipelineColumns::separate(const std::vector<double>& wanted) {
  const std::size_t count = order_.size();
  std::vector<double> from_left = wanted, from_right = wanted;
  for (std::size_t k = 0; k < count; ++k) {
    const int item = order_[k];
    for (std::size_t before = 0; before < k; ++before) {
      const int other = order_[before];
      if (!share_a_row(other, item)) continue;
      from_left[item] = std::max(from_left[item], from_left[other] + distance(other, item));
    }
  }
  for (std::size_t k = count; k-- > 0;) {
    const int item = order_[k];
    for (std::size_t behind = k + 1; behind < count; ++behind) {
      const int other = order_[behind];
      if (!share_a_row(other, item)) continue;
      from_right[item] = std::min(from_right[item], from_right[other] - distance(item, other));
    }
  }
  for (std::size_t k = 0; k < count; ++k) items_[k].x = (from_left[k] + from_right[k]) / 2;
}

double PipelineColumns::distance(int left, int right) const {
  return (items_[left].width + items_[right].width) / 2 + gap;
}

bool PipelineColumns::share_a_row(int one, int other) const {
  return items_[one].first_row <= items_[other].last_row &&
         items_[other].first_row <= items_[one].last_row;
}

void PipelineColumns::move_to_the_left() {
  double least = 0;
  for (std::size_t k = 0; k < items_.size(); ++k) {
    const double left = items_[k].x - items_[k].width / 2;
    least = k == 0 ? left : std::min(least, left);
  }
  for (Item& item : items_) item.x -= least;
}

double PipelineColumns::width() const {
  double width = 0;
  for (const Item& item : items_) width = std::max(width, item.x + item.width / 2);
  return width;
}

}  // namespace mixcmp::page

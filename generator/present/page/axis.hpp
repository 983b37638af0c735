#pragma once

#include <string>
#include <vector>

namespace mixcmp::page {

enum class Scaling {
  linear,       ///< begins at 0 where no value is below it
  logarithmic,  ///< values of 0 have a line of their own below all others
};

/// One axis of a chart: its label, and the values that it shows.
struct AxisSpec {
  std::string label;
  Scaling scaling = Scaling::linear;
  bool begins_at_zero = true;  ///< of a linear axis
  double least_step = 0;       ///< of a linear axis, between ticks: 1 for whole numbers
};

struct Tick {
  double value;
  std::string label;
};

/// Maps values to coordinates of a picture. The axis ends at its first and last tick.
class Axis {
public:
  /// `from` and `to` are the coordinates of the ends. Without values the axis shows 0 to 1.
  Axis(const AxisSpec& spec, const std::vector<double>& values, double from, double to);

  double position(double value) const;
  const std::vector<Tick>& ticks() const { return ticks_; }

private:
  void choose_linear(double low, double high, double least_step);
  void choose_logarithmic(const std::vector<double>& values);
  void add_decades(double low, double high);
  void add_parts_of_decades(double low, double high);

  Scaling scaling_;
  double from_, to_;
  double low_ = 0, high_ = 1;  ///< of a logarithmic axis: exponents of ten
  bool has_zero_ = false;      ///< of a logarithmic axis: there is a line for 0
  std::vector<Tick> ticks_;
};

}  // namespace mixcmp::page

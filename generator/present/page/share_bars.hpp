#pragma once

#include <string>
#include <vector>

#include "generator/present/page/element.hpp"

namespace mixcmp::page {

/// One part of a whole: its share is drawn in the bar of each resource.
struct ShareSegment {
  std::string name;
  int color = 0;
};

/// A bar: a resource, and how much of it each segment takes.
struct ShareBar {
  std::string name;             ///< "LUT"
  double available = 0;         ///< the whole length of the bar
  double usable = 0;            ///< a mark within the bar; equal to `available` for none
  std::vector<double> amounts;  ///< one per segment
};

struct ShareBars {
  std::string title;        ///< describes the picture to readers who cannot see it
  std::string usable_name;  ///< the meaning of the mark: "80 % (slack 0.2)"
  std::vector<ShareSegment> segments;
  std::vector<ShareBar> bars;
};

/// Horizontal stacked bars with a legend. A whole bar is the amount that the device has.
Element draw(const ShareBars& bars);

}  // namespace mixcmp::page

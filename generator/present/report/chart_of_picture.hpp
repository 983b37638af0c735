#pragma once

#include "generator/present/page/chart.hpp"
#include "generator/present/report/plot.hpp"

namespace mixcmp::report {

/// A picture, whose curves are all on the left axis, as a chart of a page. Each point names its
/// curve and its numbers.
page::Chart chart_of(const Picture& picture);

/// "7.921e-04" on a logarithmic axis, "48.6" on a linear one.
std::string number_text(double value, Axis axis);

}  // namespace mixcmp::report

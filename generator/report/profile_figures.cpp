#include <fmt/format.h>

#include <string>
#include <utility>

#include "generator/report/plot.hpp"
#include "generator/report/profile_report.hpp"

namespace mixcmp::report {

using profile::ErrorAtPrecision;
using profile::ErrorProfile;
using profile::RateProfile;
using profile::SchemeKind;
using profile::SchemeProfile;

namespace {

constexpr const char* x_axis = "set xtics 4\n";

void add(Curve& curve, int precision, double value) {
  if (value > 0) curve.points.emplace_back(precision, value);
}

}  // namespace

std::string figure4_script(const ProfileReport& report) {
  Picture picture{
      report.scene + ": largest relative error", precision_axis, "|f_L - f_T| / |f_T|", x_axis, {}};
  int color = 0;
  for (const ErrorProfile& profile : report.errors) {
    const std::string inputs = describe(profile.inputs);
    Curve f{"f, " + inputs, measured_style(color, 7), {}},
        g{"g, " + inputs, measured_style(color + 1, 5), {}};
    Curve f_bound{"f proven, " + inputs, proven_style(color), {}};
    Curve g_bound{"g proven, " + inputs, proven_style(color + 1), {}};
    for (const ErrorAtPrecision& error : profile.precisions) {
      add(f, error.precision, error.f.value_or(0).get_d());
      add(g, error.precision, error.g.value_or(0).get_d());
      add(f_bound, error.precision, error.f_bound.value_or(0));
      add(g_bound, error.precision, error.g_bound.value_or(0));
    }
    for (Curve* curve : {&f, &f_bound, &g, &g_bound}) picture.curves.push_back(std::move(*curve));
    color += 2;
  }
  return script(picture);
}

std::string figure5_script(const ProfileReport& report) {
  Picture picture{
      report.scene + ": recomputation rate", precision_axis, "undecided / comparisons", x_axis, {}};
  for (const RateProfile& profile : report.rates) {
    int color = 0;
    for (const SchemeProfile& scheme : profile.schemes) {
      if (scheme.kind == SchemeKind::lanes_alone) continue;
      const int point = profile.inputs == LaneInputs::exact ? 7 : 6;
      Curve curve{fmt::format("{}, {}", scheme.name, describe(profile.inputs)),
                  measured_style(color++, point),
                  {}};
      for (std::size_t k = 0; k < scheme.counts.size(); ++k) {
        add(curve, profile.first_precision + static_cast<int>(k),
            static_cast<double>(scheme.counts[k].undecided) /
                static_cast<double>(profile.comparisons));
      }
      picture.curves.push_back(std::move(curve));
    }
  }
  return script(picture);
}

}  // namespace mixcmp::report

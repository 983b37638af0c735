#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

#include "generator/present/report/plot.hpp"
#include "generator/present/report/profile_report.hpp"

namespace mixcmp::report {

using profile::ErrorAtPrecision;
using profile::ErrorProfile;
using profile::RateProfile;
using profile::SchemeKind;
using profile::SchemeProfile;

namespace {

constexpr const char* x_axis = "set xtics 4\n";

void add(Curve& curve, int precision, const std::optional<double>& value) {
  if (value) curve.points.emplace_back(precision, *value);
}

std::optional<double> rounded(const std::optional<mpq_class>& value) {
  return value ? std::optional(value->get_d()) : std::nullopt;
}

}  // namespace

Picture figure4(const ProfileReport& report) {
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
      add(f, error.precision, rounded(error.f));
      add(g, error.precision, rounded(error.g));
      add(f_bound, error.precision, error.f_bound);
      add(g_bound, error.precision, error.g_bound);
    }
    for (Curve* curve : {&f, &f_bound, &g, &g_bound}) picture.curves.push_back(std::move(*curve));
    color += 2;
  }
  return picture;
}

Picture figure5(const ProfileReport& report) {
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
        if (!scheme.counts[k].exists) continue;
        add(curve, profile.first_precision + static_cast<int>(k),
            static_cast<double>(scheme.counts[k].undecided) /
                static_cast<double>(profile.comparisons));
      }
      picture.curves.push_back(std::move(curve));
    }
  }
  return picture;
}

}  // namespace mixcmp::report

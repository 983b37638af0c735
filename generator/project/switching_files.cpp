#include "generator/project/switching_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>

#include "generator/hardware/emit/version.hpp"
#include "generator/project/builders.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::project {
namespace {

using Points = std::vector<std::vector<optimise::RatePoint>>;

/// A name of C: other bytes than letters, digits and underscores become underscores.
std::string c_name(const std::string& name) {
  std::string text = name;
  for (char& each : text) {
    if (std::isalnum(static_cast<unsigned char>(each)) == 0) each = '_';
  }
  return std::isdigit(static_cast<unsigned char>(text.front())) != 0 ? "_" + text : text;
}

std::string c_points(const Points& points) {
  std::string text;
  for (std::size_t plan = 0; plan < points.size(); ++plan) {
    text += fmt::format("{}      // while plan {} is loaded\n", plan == 0 ? "" : "\n", plan + 1);
    for (const optimise::RatePoint& point : points[plan]) {
      text += fmt::format("      {{{}, {{{}}}}},\n", point.rate, fmt::join(point.seconds, ", "));
    }
    text.pop_back();
  }
  return text;
}

std::string python_points(const Points& points) {
  std::string text;
  for (const auto& own : points) {
    text += "    (\n";
    for (const optimise::RatePoint& point : own) {
      text += fmt::format("        ({}, [{}]),\n", point.rate, fmt::join(point.seconds, ", "));
    }
    text += "    ),\n";
  }
  text.pop_back();
  return text;
}

/// The places in the C table at which the points of each plan begin, and its end.
std::vector<std::size_t> first_points(const Points& points) {
  std::vector<std::size_t> first = {0};
  for (const auto& own : points) first.push_back(first.back() + own.size());
  return first;
}

Values values_of(const SwitchingSpec& spec, const std::string& comment) {
  const Points& points = spec.rule.points();
  const bool is_c = comment == "//";
  const std::string before = is_c ? "// " : "";
  std::vector<std::string> plans;
  for (std::size_t k = 0; k < spec.plans.size(); ++k) {
    plans.push_back(fmt::format("{}plan {}: {}", before, k + 1, spec.plans[k]));
  }
  const std::string name = c_name(spec.name);
  return {{"NAME", spec.name},
          {"PROVENANCE", fmt::format("{0} Made by mixcmp {1}:\n{0}   {2}\n{0} Its output is "
                                     "unencumbered.",
                                     comment, emit::version, spec.command)},
          {"PREFIX", name},
          {"GUARD", in_capitals(name)},
          {"PLANS", std::to_string(points.size())},
          {"PLANS_TEXT", fmt::format("{}", fmt::join(plans, "\n"))},
          {"COMPARISONS_TEXT",
           spec.counts_comparisons
               ? "The arguments are sums over the system's counters of these names."
               : "comparisons: those that were asked for; recomputations: the engine's counter."},
          {"RECONFIGURATION_SECONDS", fmt::format("{}", spec.rule.reconfiguration_seconds())},
          {"C_POINTS", is_c ? c_points(points) : ""},
          {"PYTHON_POINTS", is_c ? "" : python_points(points)},
          {"FIRST_POINTS", fmt::format("{}", fmt::join(first_points(points), ", "))},
          {"COMPARISONS_OF_WORD", fmt::format("{}", fmt::join(spec.comparisons_of_word, ", "))}};
}

}  // namespace

std::vector<GeneratedFile> switching_files(const SwitchingSpec& spec) {
  const std::size_t plans = spec.rule.points().size();
  MIXCMP_CHECK(spec.plans.size() == plans && spec.comparisons_of_word.size() == plans);
  return {file_from("switching.h", "switching.h", values_of(spec, "//")),
          file_from("switching.py", "switching.py", values_of(spec, "#"))};
}

}  // namespace mixcmp::project

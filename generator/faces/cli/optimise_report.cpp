#include "generator/faces/cli/optimise_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "generator/present/report/plan_fields.hpp"
#include "generator/present/report/plan_report.hpp"
#include "model/plan/optimise/plan_summary.hpp"

namespace mixcmp::cli {
namespace {

using table::Fields;
using table::Json;
using table::within;
using tasks::OptimiseResult;
using tasks::PlannedSystem;
using Systems = std::vector<const PlannedSystem*>;

/// The fastest systems that differ in a trait, in their order.
template <class Trait>
Systems fastest_by(const std::vector<PlannedSystem>& systems, Trait trait) {
  Systems fastest;
  for (const PlannedSystem& system : systems) {
    const auto known = std::find_if(fastest.begin(), fastest.end(), [&](const auto* other) {
      return trait(*other) == trait(system);
    });
    if (known == fastest.end()) {
      fastest.push_back(&system);
    } else if (system.throughput_per_s() > (*known)->throughput_per_s()) {
      *known = &system;
    }
  }
  return fastest;
}

Systems interfaces_of(const OptimiseResult& result) {
  return fastest_by(result.systems, [](const auto& system) { return system.interface; });
}

/// The fastest system of each formulation in the chosen interface.
Systems formulations_of(const OptimiseResult& result) {
  std::vector<const PlannedSystem*> alike;
  for (const PlannedSystem& system : result.systems) {
    if (system.interface == result.best().interface) alike.push_back(&system);
  }
  return alike;
}

std::string plan_text(const optimise::PlanSummary& s) {
  return fmt::format("L = {:>2}, {:>3} x {}: {:>8} G/s", s.precision, s.lanes, s.references,
                     giga_text(s.throughput_per_s));
}

/// A table that compares systems by a name; empty for a single one.
template <class Name>
std::string compare(const std::string& title, const Systems& systems, const PlannedSystem& chosen,
                    Name name) {
  if (systems.size() < 2) return "";
  std::size_t width = 22;
  for (const PlannedSystem* system : systems) width = std::max(width, name(*system).size());
  std::string text = title + ", the best plan of each\n";
  for (const PlannedSystem* system : systems) {
    const optimise::PlanSummary s = summary_of(system->found);
    text += fmt::format("{} {:<{}} ", system == &chosen ? '*' : ' ', name(*system), width);
    if (s.throughput_per_s == 0) {
      text += "no feasible plan\n";
      continue;
    }
    text += fmt::format("{}; the chosen is {:.2f} times as fast\n", plan_text(s),
                        chosen.throughput_per_s() / s.throughput_per_s);
  }
  return text + "\n";
}

std::string confirmation_text(const OptimiseResult& result) {
  if (!result.confirmation) return "";
  const std::string predicted = giga_text(result.confirmation->predicted_per_s);
  const std::string now = giga_text(result.best().throughput_per_s());
  if (result.confirmation->rounds == 0 && !result.confirmation->is_measured) {
    return fmt::format("areas: predicted; predicted {} G comparisons/s\n", predicted);
  }
  const char* const areas = areas_of(*result.confirmation);
  return fmt::format("areas: {0}; predicted {1}, {0} {2} G comparisons/s\n", areas, predicted, now);
}

/// The best systems in parts of the device, and where more area brings little more per area.
std::string front_text(const std::vector<tasks::FrontPoint>& front, double slack) {
  if (front.empty()) return "";
  std::string text = fmt::format(
      "smaller systems of this formulation and interface, by the part of the device (R_S leaves "
      "{:g} %)\n",
      100 * (1 - slack));
  for (const tasks::FrontPoint& point : front) {
    text +=
        fmt::format("{} {:>6.2f} %  {}; {} G/s per 1 %\n", &point == knee_of(front) ? '*' : ' ',
                    100 * point.share, plan_text(point.plan), giga_text(point.per_share() / 100));
  }
  return text +
         "  *: the smallest with 0.9 of the highest throughput per area; --at-least G/s "
         "plans the smallest system that is fast enough\n";
}

Json front_json(const std::vector<tasks::FrontPoint>& front) {
  using Point = tasks::FrontPoint;
  const Fields<Point> share = {{{"share"}, &Point::share}};
  const Fields<Point> rest = {
      {{"is_knee"}, [&](const Point& point) { return &point == knee_of(front); }},
      {{"settings"}, &Point::settings}};
  return to_json(
      table_of(share + within<Point>(report::plan_choice(), &Point::plan) + rest, front));
}

/// The variant's name, null for the formulation in [comparison] itself, and the second tier's
/// format, null without one.
Json json_name(const PlannedSystem& system) {
  const scene::Scene& scene = system.known.scene;
  Json json = {{"variant", nullptr}};
  if (!scene.variant.empty()) json["variant"] = scene.variant;
  if (scene.second_tier) json["second_tier"] = scene.second_tier->format_name();
  if (scene.leaves_out_second_tier) json["second_tier"] = nullptr;
  return json;
}

Json json_of_interface(const PlannedSystem& system) {
  const Fields<PlannedSystem> fields = {{{"interface"}, &PlannedSystem::interface},
                                        {{"settings"}, &PlannedSystem::settings}};
  const auto plan = [](const PlannedSystem& each) { return summary_of(each.found); };
  return object_of(fields + within<PlannedSystem>(report::plan_choice(), plan), system);
}

}  // namespace

const char* areas_of(const tasks::Confirmation& confirmation) {
  if (confirmation.is_measured) return "measured";
  return confirmation.rounds == 0 ? "predicted" : "partly measured";
}

std::string giga_text(double per_s) {
  constexpr double giga = 1e9;
  const double value = per_s / giga;
  const int leading = value > 0 ? static_cast<int>(std::floor(std::log10(value))) : 0;
  return fmt::format("{:.{}f}", value, std::max(2, 1 - leading));
}

std::string to_text(const OptimiseResult& result) {
  const PlannedSystem& best = result.best();
  std::string text = compare("interfaces", interfaces_of(result), best,
                             [](const PlannedSystem& system) { return system.interface; }) +
                     compare("formulations in the chosen interface", formulations_of(result), best,
                             [](const PlannedSystem& system) { return system.formulation; });
  if (result.systems.size() > 1) {
    text += fmt::format("the chosen system at each precision ({}; {})\n", best.formulation,
                        best.interface);
  }
  text += report::to_text(best.found);
  if (!result.confirmation || best.found.best() == nullptr) return text;
  text += fmt::format("system: {}\n", best.interface);
  if (!best.settings.empty()) text += fmt::format("  {}\n", fmt::join(best.settings, " "));
  return text + front_text(result.front, best.found.slack) + confirmation_text(result);
}

Json to_json(const OptimiseResult& result) {
  const PlannedSystem& best = result.best();
  Json json = report::to_json(best.found);
  const Systems formulations = formulations_of(result);
  if (formulations.size() > 1 || !best.known.scene.variants.empty()) {
    json.update(json_name(best));
    for (const PlannedSystem* system : formulations) {
      json["formulations"].push_back(json_name(*system));
      json["formulations"].back()["throughput_per_s"] = system->throughput_per_s();
    }
  }
  if (!result.confirmation) return json;
  json["interface"] = best.interface;
  json["settings"] = best.settings;
  for (const PlannedSystem* system : interfaces_of(result)) {
    json["interfaces"].push_back(json_of_interface(*system));
  }
  json["predicted_per_s"] = result.confirmation->predicted_per_s;
  json["areas"] = areas_of(*result.confirmation);
  json["front"] = front_json(result.front);
  return json;
}

}  // namespace mixcmp::cli

#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "generator/faces/cli/planning.hpp"
#include "generator/present/report/report_sections.hpp"

namespace mixcmp::cli {

/// The choices that change a page.
struct ReportChoice {
  std::set<std::string> without;  ///< of "profile", "plan", "front", "waves": left out
  bool beside_paper = false;      ///< the scene is the paper's benchmark
  std::string command;            ///< that makes the page again
};

/// Makes the page of one scene: measures its rates, proves its bounds, plans, simulates. Remembers
/// the parts that could not be made.
class ReportMaker {
public:
  ReportMaker(const PlanningOptions& planning, const LoadedScene& loaded, ReportChoice choice);

  page::Page make();
  /// The parts that were not made, with reasons, for end_if_incomplete.
  const std::vector<std::string>& not_done() const { return not_done_; }

private:
  const data::Comparisons* data() const { return loaded_.data ? &*loaded_.data : nullptr; }
  /// "mixcmp VERB SCENE ..." with the settings of this run.
  std::string command(const std::string& verb) const {
    return command_line(verb, planning_options_.scene).text();
  }
  std::string subtitle() const;
  table::Lines made_by() const;
  bool shows(const std::string& section) const { return !choice_.without.contains(section); }
  void add_measurements(page::Page& page);
  /// Remembers that a section could not be made.
  report::Missing not_made(const std::string& section, const std::string& why,
                           const std::string& makes_it);
  report::Missing not_made(const std::string& section, const Error& error,
                           const std::string& makes_it);

  report::IfThere<report::BuiltSystem> build_system();
  report::Missing no_system(const Error& error);
  report::IfThere<std::vector<report::ProvenLanes>> proofs() const;
  report::IfThere<report::ProfileReport> measure();
  const Planning* plannable();
  std::filesystem::path table_beside_a_layer() const;
  bool is_measured_plan() const;
  report::IfThere<optimise::Optimisation> search_plans();
  report::IfThere<optimise::Optimisation> find_plans();
  bool has_rates() const;
  optimise::Rates rates();
  std::optional<report::IfThere<report::Front>> front();
  std::optional<optimise::PublishedFigures> published() const;
  report::IfThere<report::LaneTraffic> traffic();

  const PlanningOptions& planning_options_;
  const LoadedScene& loaded_;
  ReportChoice choice_;
  std::vector<std::string> not_done_;
  report::IfThere<report::BuiltSystem> system_;
  report::IfThere<report::ProfileReport> profile_ = report::Missing{};
  std::vector<profile::RateProfile> all_rates_;  ///< also for inputs that the scene has not
  std::optional<Result<Planning>> planning_;     ///< none: not looked for yet
};

}  // namespace mixcmp::cli

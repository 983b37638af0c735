#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/hardware/emit/scheduled_system.hpp"
#include "generator/hardware/emit/signature.hpp"
#include "generator/present/page/html_page.hpp"
#include "generator/present/report/paper_tables.hpp"
#include "generator/present/report/profile_report.hpp"
#include "model/base/number/verdict.hpp"
#include "model/judge/proof/lane_proof.hpp"
#include "model/plan/optimise/front.hpp"
#include "model/plan/optimise/optimise.hpp"
#include "model/plan/profile/trade.hpp"
#include "model/scene/summary.hpp"

/// The sections of the page that `mixcmp report` writes. A section with nothing to show names the
/// missing data and the command that makes them.
namespace mixcmp::report {

struct Missing {
  std::string why;
  std::string command;  ///< may be empty
};
template <class T>
using IfThere = std::variant<T, Missing>;

/// The request: the lines of `check`. `made_by`: names and versions of programs, the command.
page::Section request_section(const scene::Summary& summary, const table::Lines& made_by);

/// The proof of the error bound of one group of lanes.
struct ProvenLanes {
  std::string name;      ///< of the group
  std::string decision;  ///< when a lane decides, in words
  bool certified = false;
  proof::LaneProof proof;  ///< only of certified lanes
  std::string gappa;       ///< its version; empty: not installed
};
page::Section proof_section(const IfThere<std::vector<ProvenLanes>>& lanes);

/// Errors and rates. `beside_paper`: the scene is the paper's benchmark, and the paper's numbers
/// are also drawn.
page::Section profile_section(const IfThere<ProfileReport>& profile, bool beside_paper);

/// Area against recomputation rate. `plans` may be null; otherwise its lanes have measured areas.
page::Section trade_section(const std::vector<profile::Trade>& trades,
                            const optimise::Optimisation* plans);

/// The best systems in parts of the device, by share.
using Front = std::vector<optimise::FrontPoint>;

/// The best plan at each precision, how the best one shares the device, and the front, if it was
/// asked for.
page::Section plan_section(const scene::Scene& scene, const IfThere<optimise::Optimisation>& plans,
                           const std::optional<IfThere<Front>>& front,
                           const std::optional<optimise::PublishedFigures>& published);

/// A system as it would be generated.
struct BuiltSystem {
  design::Design design;
  emit::Signature signature;
  emit::ScheduledSystem scheduled;
  std::vector<std::string> notes;
};
page::Section system_section(const IfThere<BuiltSystem>& system);

/// The comparisons that went through one lane of a simulated system: at least one.
struct LaneTraffic {
  struct Transfer {
    std::uint64_t index = 0;  ///< of the comparison, in the scene's data
    std::uint64_t cycle_accepted = 0;
    std::uint64_t cycle_left = 0;
    ResultWord result = ResultWord::undecided();
  };

  std::string system;  ///< "one lane in s8e8 and one reference"
  std::string simulator;
  std::vector<Transfer> transfers;  ///< by cycle_accepted
};
page::Section wave_section(const IfThere<LaneTraffic>& traffic);

/// The paper's figures 3, 7, 8, 9 and tables III and IV, one device after the other; with the
/// paper's printed numbers if `beside_paper`.
page::Section exploration_section(const std::vector<optimise::Exploration>& explorations,
                                  const std::vector<SoftwareThroughput>& software,
                                  bool beside_paper);

}  // namespace mixcmp::report

#pragma once

#include <limits>
#include <map>
#include <set>

#include "model/plan/optimise/optimise.hpp"

namespace mixcmp::optimise {

/// Collects the rows of a characterisation into one allocation problem per precision.
class ProblemMaker {
public:
  /// `second_tier`: see second_tier_lane.
  ProblemMaker(const scene::Scene& scene, const measured::Characterisation& table,
               const Rates& rates, const OptimiseOptions& options,
               std::optional<measured::Lane> second_tier);

  /// The precisions for which the table has lanes with these options.
  std::vector<int> precisions() const;
  bool has_references() const { return !references_.empty(); }
  /// The parts of every system for which the table has no row, such as "a crossbar".
  const std::set<std::string>& missing() const { return missing_; }

  std::vector<ReferenceImplementation> references();

  /// The problem for one precision and its best plan; none if no lane has a known rate that holds
  /// for its exponent bits.
  std::optional<PrecisionPlan> plan(int precision, const devices::Device& device,
                                    const std::vector<ReferenceImplementation>& references);

  ClockBasis basis() const { return basis_; }
  std::vector<std::string> notes() const { return {notes_.begin(), notes_.end()}; }

private:
  using Rows = std::vector<const measured::Measurement*>;

  void sort_rows();
  bool is_lane(const measured::ComponentKey& key) const;
  bool is_wanted_reference(const measured::Reference& reference) const;
  bool is_wanted(const measured::Lane& lane) const;
  bool is_before_second_tier(int precision) const;
  bool is_trusted(const measured::Lane& lane) const;
  bool has_enough_exponents(const measured::Lane& lane);
  void leave_out_untimed();
  void erase_untimed(Rows& rows, const std::string& what);

  void add_crossbar();
  void note_largest_crossbar(const PrecisionPlan& plan);
  int slots_for(const Rows& lanes) const;
  /// Groups of lanes that may be in one plan. In a chain these have the same number of slots, with
  /// which they were measured. In streams with a second tier, a second lane serves the same number
  /// of them.
  std::vector<Rows> plannable_together(const Rows& lanes) const;
  PrecisionPlan plan_of(int precision, const Rows& rows, const devices::Device& device,
                        const std::vector<ReferenceImplementation>& references,
                        const std::optional<SecondLanes>& tier);
  /// The kinds of second lanes that may stand behind `rows`, one for each number of slots. Without
  /// a second tier of streams, only one empty element.
  std::vector<std::optional<SecondLanes>> second_lanes_of(const Rows& rows);
  int served_by_second_lane(const measured::Measurement& lane) const;
  devices::Area crossbar_port() const;
  void limit_engine(AllocationProblem& problem) const;
  const measured::Measurement* fifo_of(int slots) const;

  double clock_of(const measured::Measurement& row, const std::optional<double>& given,
                  const std::optional<double>& streams_mhz);
  std::optional<Rate> known_rate(const RateKey& lane);
  std::optional<Rate> rate_of(const RateKey& lane);
  void add_lane(PrecisionPlan& plan, const measured::Measurement& row,
                const measured::Measurement* fifo);
  void add_references(PrecisionPlan& plan, const std::vector<ReferenceImplementation>& references);
  /// A lane with the streams around it, or its share of a segment.
  struct Surrounded {
    devices::Area area;                 ///< of a lane, rounded up
    devices::Area group;                ///< of the lanes that share it
    int lanes;                          ///< of a group
    std::optional<double> streams_mhz;  ///< the clock of the streams around it, if measured
  };
  std::optional<Surrounded> in_segment(PrecisionPlan& plan, const measured::Measurement& row);
  std::optional<Surrounded> with_fifo(const measured::Measurement& lane,
                                      const measured::Measurement* fifo) const;
  double cycles_per_word(double recomputation_rate) const;
  std::optional<devices::Area> area_alone(const measured::Lane& lane) const;
  devices::Area area_with_port(const measured::Measurement& row);

  scene::EngineKind engine() const { return scene_.system.engine.kind; }
  bool has_engine() const { return engine() != scene::EngineKind::none; }
  bool has_second_lanes() const { return second_tier_ && !has_engine(); }

  const scene::Scene& scene_;
  const measured::Characterisation& table_;
  const Rates& rates_;
  const OptimiseOptions& options_;
  const std::optional<measured::Lane> second_tier_;
  std::map<int, Rows> lanes_;
  Rows references_;
  Communication communication_;
  double crossbar_mhz_ = std::numeric_limits<double>::infinity();
  ClockBasis basis_ = ClockBasis::given;
  std::set<std::string> notes_;
  std::set<std::string> missing_;
  std::string left_out_;  ///< why the current precision has no usable lane, for the user
};

}  // namespace mixcmp::optimise

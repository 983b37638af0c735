#pragma once

#include <limits>
#include <map>
#include <set>

#include "model/optimise/optimise.hpp"

namespace mixcmp::model {

/// Collects the rows of a characterisation into one allocation problem per precision.
class ProblemMaker {
public:
  ProblemMaker(const Scene& scene, const Characterisation& table, const Rates& rates,
               const OptimiseOptions& options);

  /// The precisions for which the table has lanes, with the options at hand.
  std::vector<int> precisions() const;
  bool has_references() const { return !references_.empty(); }

  std::vector<ReferenceImplementation> references();

  /// The problem for one precision and its best plan; none where no lane has a known rate that
  /// holds for its exponent bits.
  std::optional<PrecisionPlan> plan(int precision, const Device& device,
                                    const std::vector<ReferenceImplementation>& references);

  ClockBasis basis() const { return basis_; }
  std::vector<std::string> notes() const { return {notes_.begin(), notes_.end()}; }

private:
  using Rows = std::vector<const Measurement*>;

  void sort_rows();
  bool is_wanted(const Measurement& lane) const;
  bool is_trusted(const Measurement& lane) const;
  bool has_enough_exponents(const Measurement& lane);
  void leave_out_untimed();
  void erase_untimed(Rows& rows, const std::string& what);

  void add_crossbar();
  void note_largest_crossbar(const PrecisionPlan& plan);
  const Measurement* fifo_for(const Rows& lanes);

  double clock_of(const Measurement& row, const std::optional<double>& given,
                  const Measurement* fifo);
  void add_lane(PrecisionPlan& plan, const Measurement& row, const Measurement* fifo);

  const Scene& scene_;
  const Characterisation& table_;
  const Rates& rates_;
  const OptimiseOptions& options_;
  std::map<int, Rows> lanes_;
  Rows references_;
  Communication communication_;
  double crossbar_mhz_ = std::numeric_limits<double>::infinity();
  ClockBasis basis_ = ClockBasis::given;
  std::set<std::string> notes_;
  std::string left_out_;  ///< why the current precision has no lane worth using, for the user
};

}  // namespace mixcmp::model

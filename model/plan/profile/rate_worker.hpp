#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/base/common/workers.hpp"
#include "model/plan/profile/precision_band.hpp"
#include "model/plan/profile/unsettled_comparisons.hpp"

namespace mixcmp::profile {

/// The data that all comparisons share: built once, read by all threads.
struct RateJob {
  const scene::Scene& scene;
  const data::OperandSource& source;
  ProfileMethod method;
  std::vector<SchemeLanes> schemes;
  std::vector<PrecisionBand> bands;  ///< the next() of each is the anchor() of the next one
  emulator::Emulator reference;
  /// Decides only what it decides as the real numbers do. None: each verdict in doubt is computed
  /// by MPFR.
  std::optional<emulator::Emulator> certified_reference = {};
  /// The operands of one input that lanes do not take. Bit k of of_row[row] is set if the value in
  /// that row of the input's table fails a range check of scheme k, or lies outside its fixed-point
  /// format. Inputs that never fail are left out.
  struct Failing {
    data::Item item;
    std::vector<std::uint32_t> of_row;
  };
  std::vector<Failing> failing;
  /// Null if reported pairs are not marked. If it is set, `stretch` is 1, so that no two blocks
  /// write to the same element.
  performance::PairwiseData* pairs = nullptr;
  /// One random comparison is counted from each stretch of so many consecutive ones.
  std::uint64_t stretch = 1;

  std::uint64_t counted() const { return (source.data().size() + stretch - 1) / stretch; }
  /// The comparison that is counted as number `k`.
  std::uint64_t comparison(std::uint64_t k) const;
};

/// Counts over comparisons. They are integers, so the order of addition does not matter.
struct RateTally {
  /// counts[scheme][precision - first precision].
  std::vector<std::vector<SchemeCounts>> counts;
  std::uint64_t reference_wrong = 0, true_verdicts = 0, undetermined = 0, emulated = 0;

  explicit RateTally(const RateJob& job);
  void add(const RateTally& other);
};

/// One thread's share of the counts. Comparisons go through the bands and are dropped as soon as
/// every scheme is settled on them.
class RateWorker {
public:
  /// With this size, some operands of a block fit the second-level cache.
  static constexpr std::size_t block = 4096;

  explicit RateWorker(const RateJob& job);
  void run(const BlockSource& next);
  const RateTally& tally() const { return tally_; }

private:
  /// A band is processed once its queue holds `block` comparisons, or earlier if the previous band
  /// could fill the queue beyond this capacity.
  static constexpr std::size_t capacity = 2 * block;

  void start(std::uint64_t first, std::size_t count);
  void fetch(std::uint64_t first, std::size_t count, data::OperandBlock& operands);
  void process(std::size_t band);
  void make_room(std::size_t band, std::size_t count);
  void classify(const PrecisionBand& band, UnsettledComparisons& unsettled, bool is_first);
  void find_true_verdicts(UnsettledComparisons& unsettled);
  std::vector<Decision> certified_verdicts(std::size_t count);
  void mark_reported(const UnsettledComparisons& unsettled);
  void settle_finished(const PrecisionBand& band, const UnsettledComparisons& unsettled);
  void run_scheme(const PrecisionBand& band, std::size_t scheme,
                  const UnsettledComparisons& unsettled);
  void count_open(const PrecisionBand& band, std::size_t scheme, std::size_t count);
  void pick(const PrecisionBand& band, std::size_t scheme, int precision,
            const UnsettledComparisons& unsettled);
  void run_lane(const LaneRunner& runner, std::size_t scheme, int precision,
                const UnsettledComparisons& unsettled, std::size_t count);
  void pass_on(const PrecisionBand& band, const UnsettledComparisons& from,
               UnsettledComparisons& to);

  const RateJob& job_;
  RateTally tally_;
  EnvelopeBlock envelope_;
  std::vector<UnsettledComparisons> pending_;  ///< one per band
  std::vector<LastOpen> last_;                 ///< [scheme * capacity + row of the unsettled]
  std::vector<std::uint8_t> doubtful_;
  std::vector<std::uint64_t> fetched_;  ///< the comparisons of the newest block
  std::vector<std::uint32_t> left_;     ///< schemes that the next band has to settle
  std::vector<std::uint32_t> order_;    ///< rows of the unsettled, longest open first
  std::vector<std::size_t> open_at_;    ///< [L - anchor]: number of unsettled open at L
  UnsettledComparisons picked_;  ///< the open unsettled of one scheme, in the order of order_
  std::vector<Decision> decisions_;
};

}  // namespace mixcmp::profile

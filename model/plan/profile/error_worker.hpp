#pragma once

#include <cstdint>
#include <vector>

#include "model/base/common/workers.hpp"
#include "model/comparison/data/operand_source.hpp"
#include "model/comparison/data/permutation.hpp"
#include "model/judge/emulator/emulator.hpp"
#include "model/judge/golden/true_values.hpp"
#include "model/plan/profile/profile.hpp"

namespace mixcmp::profile {

/// The largest error so far, in double, the first sample with it, and the number of samples without
/// a relative error.
struct LargestError {
  double error = 0;
  std::uint64_t sample = 0;
  std::uint64_t unbounded = 0;

  void raise_to(double other, std::uint64_t other_sample);
  void add(const LargestError& other);
};

struct ErrorPart {
  TypedGraph graph;
  emulator::Emulator emulator;
};

/// One element per part of the comparison.
using ErrorLane = std::vector<ErrorPart>;

/// The data that all samples share: built once, read by all threads.
struct ErrorJob {
  const scene::Scene& scene;
  const data::OperandSource& source;
  data::Permutation permutation;  ///< sample n is comparison permutation(n)
  std::vector<ErrorLane> lanes;
};

struct ErrorTally {
  std::vector<LargestError> f, g;  ///< one per lane
  std::uint64_t comparisons = 0;

  void add(const ErrorTally& other);
};

/// The relative errors of f and g on one sample, the largest over all parts, computed only by MPFR.
struct JudgedError {
  mpq_class f = 0, g = 0;
  bool f_unbounded = false, g_unbounded = false;  ///< some part has no relative error
};
JudgedError judge_error(const ErrorJob& job, const ErrorLane& lane, std::uint64_t sample);

/// One thread's share of figure 4. Errors are measured in double, from true values stored as sums
/// of two doubles. The relative error of these is 2^-48, small enough to find the largest error.
class ErrorWorker {
public:
  static constexpr std::size_t block = 2048;

  explicit ErrorWorker(const ErrorJob& job);
  void run(const BlockSource& next);
  const ErrorTally& tally() const { return tally_; }

private:
  /// True values of one function, high + low. `scale` is 1 / |high|, or 0 if nothing is measured. A
  /// true zero has an infinite scale.
  struct Truth {
    std::vector<double> high, low, scale;
  };
  /// The true values of one part on a block of samples.
  struct PartTruth {
    golden::TrueValues values;
    Truth f, g;
    std::vector<std::uint64_t> extreme;  ///< samples of the block left to MPFR
  };

  void find_truth(std::uint64_t first, std::size_t count);
  /// Finds the truth of one sample; false if f or g is no real number.
  bool find_truth(PartTruth& part, std::span<const Bits> operands, std::uint64_t first,
                  std::size_t k);
  /// Stores a true value as row k of `truth`; false if its exponent is too small or too large for
  /// double.
  static bool keep(Truth& truth, golden::BigFloat& scratch, const golden::BigFloat& value,
                   std::size_t k);
  void measure_lane(std::size_t lane, std::uint64_t first, std::size_t count);
  /// Raises `largest` to the errors of a block, and sets `unbounded` where there is no error.
  static void measure(const Truth& truth, const std::vector<double>& computed, std::uint64_t first,
                      std::size_t count, LargestError& largest,
                      std::vector<std::uint8_t>& unbounded);

  const ErrorJob& job_;
  ErrorTally tally_;
  data::OperandBlock operands_;
  std::vector<PartTruth> truths_;
  golden::BigFloat scratch_;
  std::vector<double> f_, g_;
  std::vector<std::uint8_t> exceptional_;
  std::vector<std::uint8_t> f_unbounded_, g_unbounded_;
};

}  // namespace mixcmp::profile

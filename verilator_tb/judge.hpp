#pragma once

#include <cstdint>
#include <deque>

#include "verilator_tb/verify.hpp"

namespace mixcmp::tb {

/// Holds results against the golden model, in whatever order and from whichever simulator they
/// come. Keeps only the comparisons between the oldest missing result and the newest expected one.
class Judge {
public:
  Judge(const gen::Signature& signature, const model::Design& design,
        const model::Comparisons& comparisons, const Selection& selection,
        const VerifyOptions& options);

  /// Computes what the next `count` positions must give.
  void expect(std::uint64_t count);
  /// Only for positions that are expected.
  void take(const Answer& answer);

  VerifyReport& report() { return report_; }
  /// The first comparison that no lane decided, for a marker in the waves.
  const std::optional<wire::Result>& first_undecided() const { return first_undecided_; }

private:
  struct Expectation {
    bool decided;
    model::golden::Verdict verdict;
    bool has_left = false;
    bool lost = false;
    std::uint32_t tdata = 0;  ///< as it came
  };

  Expectation evaluate(std::span<const model::Bits> operands) const;
  std::uint32_t expected_tdata(const Expectation& expectation) const;
  void take_result(const wire::Result& result);
  void take_violation(const wire::Violation& violation);
  void take_counters(const std::vector<wire::LaneEnd>& lanes);
  void report_wrong_counter(const char* name, std::uint32_t lane, std::uint64_t counted,
                            std::uint64_t observed);
  Mismatch describe(std::uint64_t position, const Expectation& expectation,
                    const wire::Result& result) const;
  void retire();
  void check_truth(std::uint64_t index, const Expectation& expectation);

  const gen::Signature& signature_;
  const model::Design& design_;
  const model::Comparisons& comparisons_;
  const Selection& selection_;
  const VerifyOptions& options_;
  std::deque<Expectation> window_;
  std::uint64_t window_start_ = 0;  ///< position of window_.front()
  std::optional<wire::Result> first_undecided_;
  VerifyReport report_;
};

}  // namespace mixcmp::tb

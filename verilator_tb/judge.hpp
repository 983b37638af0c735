#pragma once

#include <cstdint>
#include <deque>

#include "verilator_tb/expected_words.hpp"
#include "verilator_tb/verify.hpp"

namespace mixcmp::verilator_tb {

/// Compares results with the answers that lanes must give, in whatever order and from whichever
/// simulator they come. The answers come from `emulator` if it is given and computes the lane
/// itself, otherwise from the golden model. The golden model also judges one comparison in 64, all
/// comparisons that the lane must leave undecided, and all mismatches. The judge remembers only the
/// comparisons from the oldest missing result to the newest announced.
class Judge {
public:
  Judge(const emit::Signature& signature, const design::Design& design,
        const data::Comparisons& comparisons, const Selection& selection,
        const VerifyOptions& options, const ExpectedWords* emulator);

  /// Announces that the next `count` positions are on their way.
  void announce(std::uint64_t count);
  /// Judges an answer, whose positions must have been announced.
  void take(const Answer& answer);

  VerifyReport& report() { return report_; }
  /// The first comparison that no lane decided, for a marker in the waves.
  const std::optional<harness::wire::Result>& first_undecided() const { return first_undecided_; }

private:
  struct Fate {
    bool has_left = false;
    bool lost = false;
    std::uint32_t lane = 0;
    ResultWord word = ResultWord::undecided();  ///< as received
    std::uint64_t cycle_accepted = 0;
    std::uint64_t cycle_left = 0;
  };

  GroupReport& group_of(std::uint32_t lane) { return report_.groups[group_of_lane_[lane]]; }
  void take_result(const harness::wire::Result& result);
  void judge(const std::vector<harness::wire::Result>& results);
  std::vector<std::optional<ResultWord>> emulate(
      const std::vector<harness::wire::Result>& results) const;
  bool needs_golden_model(const harness::wire::Result& result, ResultWord emulated) const;
  ResultWord expected(const harness::wire::Result& result, std::optional<ResultWord> emulated);
  void add_emulator_error(const harness::wire::Result& result, ResultWord golden,
                          ResultWord emulated);
  void fetch(const harness::wire::Result& result);
  void check_truth(const harness::wire::Result& result);
  void add_mismatch(const harness::wire::Result& result, ResultWord expected);
  void take_violation(const harness::wire::Violation& violation);
  void take_counters(const std::vector<harness::wire::CounterValues>& groups);
  void take_answers(const Answer& answer);
  void take_answers_behind_second_tier(const Answer& answer);
  void report_wrong_counter(const char* name, std::uint32_t lane, std::uint64_t counted,
                            std::uint64_t observed);
  Mismatch mismatch_of(const harness::wire::Result& result, ResultWord expected) const;
  void retire();
  void count(std::uint64_t index, const Fate& fate);

  const emit::Signature& signature_;
  const design::Design& design_;
  const data::Comparisons& comparisons_;
  const Selection& selection_;
  const VerifyOptions& options_;
  std::vector<std::size_t> group_of_lane_;
  const ExpectedWords* emulator_;  ///< may be null
  std::vector<Bits> operands_;     ///< of one comparison
  std::deque<Fate> window_;
  std::uint64_t window_start_ = 0;  ///< position of window_.front()
  std::optional<harness::wire::Result> first_undecided_;
  std::uint64_t references_asked_ = 0;  ///< of a second tier: the comparisons it did not decide
  VerifyReport report_;
};

}  // namespace mixcmp::verilator_tb

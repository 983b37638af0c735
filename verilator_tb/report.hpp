#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/base/number/verdict.hpp"
#include "model/comparison/data/input_sources.hpp"

namespace mixcmp::verilator_tb {

/// A result that differs from the golden model's.
struct Mismatch {
  struct Operand {
    std::string input;
    std::string hex;
    std::string value;
  };

  std::uint64_t index = 0;
  std::string items;  ///< "12, 40: A 151 MET CA, ..." of a pair; empty for a row
  std::vector<Operand> operands;
  std::string expected;  ///< "less, decided by the lane"
  std::string got;
  std::uint32_t lane = 0;
  std::uint64_t cycle = 0;       ///< of its simulation, in which the result left
  std::uint64_t simulation = 0;  ///< its number in the run
  std::string repeat;            ///< the command that repeats only this comparison
};

/// One violation of the streams' contract by the system.
struct ProtocolViolation {
  std::string fault;
  std::uint32_t lane = 0;
  std::uint64_t cycle = 0;  ///< of its simulation
  std::string details;
  std::uint64_t simulation = 0;
};

/// Cycles from a comparison's acceptance to its result's departure.
struct Latency {
  std::uint64_t count = 0;
  std::uint64_t minimum_cycles = 0;
  std::uint64_t maximum_cycles = 0;
  std::uint64_t total_cycles = 0;

  void add(std::uint64_t cycles);
  void add(const Latency& other);
  double mean_cycles() const;
};

/// Latencies, for each outcome of a comparison by itself.
struct Latencies {
  Latency decided;
  Latency recomputed;
  Latency undecided;  ///< of systems without references

  void add(const Latencies& other);
};

/// One of the hardware's counters, summed over the lanes, since the last reset; and over
/// simulations. Groups of lanes in lock step count comparisons in words of one for each lane.
struct CounterTotal {
  std::string name;
  std::uint64_t counted = 0;
  std::uint64_t observed = 0;
};

/// Counts of verdicts compared with the order of the real numbers f and g. Every comparison is
/// either checked or counted under the reason why it was not.
struct TruthCount {
  std::uint64_t checked = 0;
  std::uint64_t wrong_by_lane = 0;
  std::uint64_t wrong_by_reference = 0;
  /// Of those: a reference ordered f and g as numbers, but f or g has no value. It has rounded what
  /// would be the root or the logarithm of a negative number.
  std::uint64_t ordered_without_value = 0;
  /// Verdicts of the golden reference on checked comparisons, whether or not it decided them in
  /// hardware. Comparisons without a true order are left out; none are counted in a system without
  /// references.
  std::uint64_t reference_alone_checked = 0;
  std::uint64_t reference_alone_wrong = 0;
  /// Not checked: a reference answered "unordered", or by infinities and NaN, and f or g has no
  /// value (an infinite or NaN operand, a division by zero, the root of a negative number). If a
  /// lane decides such a comparison, it is wrong.
  std::uint64_t undefined = 0;
  std::uint64_t undetermined = 0;     ///< not checked: golden::true_verdict has no answer
  std::uint64_t undecided = 0;        ///< not checked: no lane decided and there is no reference
  std::uint64_t decided_by_lane = 0;  ///< not checked: TruthScope::recomputed asks for references

  void add(const TruthCount& other);
  std::uint64_t not_checked() const {
    return undefined + undetermined + undecided + decided_by_lane;
  }
};

/// Counts and latencies of all lanes of one kind.
struct GroupReport {
  std::string name;  ///< design::lane_group_names
  int lanes = 0;
  bool certified = false;
  std::uint64_t comparisons = 0;
  std::uint64_t recomputations = 0;
  std::uint64_t undecided = 0;
  std::uint64_t mismatches = 0;
  std::uint64_t wrong_by_lane = 0;  ///< counted only where the truth was asked for
  Latencies latencies;

  void add(const GroupReport& other);
};

/// The figures of a pairwise engine on all of the scene's items as one set.
struct PairwiseFigures {
  std::string top;
  std::uint64_t items = 0;           ///< of both tables, where there are two
  std::uint64_t others = 0;          ///< those of the second table
  std::uint64_t item_bytes = 0;      ///< bytes of an item on its stream
  std::uint64_t pair_bytes = 0;      ///< bytes of a comparison on a stream without an engine
  std::uint64_t reported = 0;        ///< pairs reported
  std::uint64_t stalled_cycles = 0;  ///< cycles with a ready item not taken; 0 without counters
  std::uint64_t sets = 0;            ///< sets simulated, small and interrupted ones included
  std::optional<double> expected_cycles;  ///< expected_pairwise_cycles, at full rate
};

/// The figures of an arg-min engine, whose rows meet all of the scene's candidates.
struct ArgMinFigures {
  std::string top;
  std::uint64_t candidates = 0;
  std::uint64_t rows = 0;
  /// Rows for which the reference, without lanes, finds another candidate.
  std::uint64_t rows_unlike_reference = 0;
  std::uint64_t loading_cycles = 0;  ///< from the first candidate to the first row
  std::uint64_t stalled_cycles = 0;  ///< cycles with an offered row not taken; 0 without counters
  std::uint64_t loads = 0;           ///< loads simulated, short and interrupted ones included
  Latency latency;                   ///< cycles from a row's acceptance to its departure
  std::optional<double> expected_cycles;  ///< expected_arg_min_cycles, at full rate
};

/// The shortest failing run that was found after a failure, by its first finding.
struct LeastCounterexample {
  std::string comparisons;  ///< "only comparison 12", "the first 40 comparisons"
  std::optional<Mismatch> mismatch;
  std::optional<ProtocolViolation> violation;  ///< where there is no mismatch
  std::string waves;  ///< the command that shows it as waves; empty where no command repeats it
};

inline constexpr const char* verilator_name = "Verilator";
inline constexpr const char* icarus_name = "Icarus Verilog";

struct VerifyReport {
  static constexpr std::size_t kept = 20;  ///< the most mismatches and violations in the lists

  std::string system;
  std::string simulator;  ///< verilator_name or icarus_name
  int lanes = 0;
  int lanes_per_group = 1;
  int references = 0;
  bool certified = false;                      ///< all lanes are
  std::vector<data::InputSource> inputs;       ///< which column of the data feeds which input
  std::vector<GroupReport> groups;             ///< lanes are numbered through them, in order
  std::uint64_t requested = 0;                 ///< comparisons to be made
  std::uint64_t comparisons = 0;               ///< results judged
  std::array<std::uint64_t, 4> verdicts = {};  ///< counts by Verdict; undecided ones left out
  std::uint64_t recomputations = 0;
  std::uint64_t undecided = 0;
  std::uint64_t resets = 0;
  std::uint64_t cycles = 0;
  Latencies latencies;
  std::vector<CounterTotal> counters;
  std::uint64_t judged_by_emulator = 0;  ///< results judged only by the emulator
  std::uint64_t emulator_errors = 0;     ///< comparisons on which it and the golden model differ
  std::uint64_t mismatch_count = 0;
  std::vector<Mismatch> mismatches;  ///< the first ones
  std::uint64_t violation_count = 0;
  std::vector<ProtocolViolation> violations;  ///< the first ones
  std::optional<LeastCounterexample> counterexample;
  std::optional<TruthCount> truth;
  std::optional<PairwiseFigures> engine;
  std::optional<ArgMinFigures> arg_min;
  double build_seconds = 0;
  double run_seconds = 0;

  /// Adds the findings of simulation number `simulation` of the same system.
  void add(VerifyReport share, std::uint64_t simulation);
  /// Adds the report of later simulations of the same run, whose findings have their numbers.
  void append(const VerifyReport& share);

  /// Tells whether every requested comparison came back once, with the golden model's result and
  /// without a protocol violation, and no error of the emulator was found. If the truth was asked
  /// for, no certified lane may be wrong.
  bool passed() const;
  double recomputation_rate() const;
  double comparisons_per_cycle() const;
  /// Bytes of items that a pairwise engine was sent for each pair compared; 0 without one.
  double item_bytes_per_pair() const;
};

/// The report of a run from those of its portions (RunPortion), in their order and at least one. It
/// equals the report of the run in one piece, up to and with the first simulation that a fault
/// ended early.
VerifyReport join_portions(const std::vector<VerifyReport>& portions);

/// Remarks on a run that may have passed, such as on lanes that decided nothing; a sentence each.
std::vector<std::string> notes_on(const VerifyReport& report);

std::string to_text(const VerifyReport& report);
nlohmann::ordered_json to_json(const VerifyReport& report);
/// The report that `to_json` has written, without engines and counterexamples. Throws
/// nlohmann::json::exception if the JSON is no such report.
VerifyReport report_in(const nlohmann::ordered_json& json);

}  // namespace mixcmp::verilator_tb

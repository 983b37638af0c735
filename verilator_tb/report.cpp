#include "verilator_tb/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "model/base/number/verdict.hpp"

namespace mixcmp::verilator_tb {

namespace {

double ratio(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

std::string line(const char* name, const std::string& value) {
  return fmt::format("  {:<22} {}\n", name, value);
}

std::string latency_line(const char* name, const Latency& latency) {
  if (latency.count == 0) return {};
  return line(name, fmt::format("{} .. {}, mean {:.1f} cycles", latency.minimum_cycles,
                                latency.maximum_cycles, latency.mean_cycles()));
}

/// " of simulation 3"; nothing of the first, which is often the only one.
std::string of_simulation(std::uint64_t simulation) {
  return simulation == 0 ? "" : fmt::format(" of simulation {}", simulation);
}

std::string to_text(const Mismatch& m) {
  std::string text = fmt::format("  comparison {}", m.index);
  if (!m.items.empty()) text += fmt::format(" ({})", m.items);
  text += fmt::format(": expected {}; got {}; lane {}, cycle {}{}\n", m.expected, m.got, m.lane,
                      m.cycle, of_simulation(m.simulation));
  for (const Mismatch::Operand& operand : m.operands) {
    text += fmt::format("    {} = 0x{} = {}\n", operand.input, operand.hex, operand.value);
  }
  if (!m.repeat.empty()) text += fmt::format("    repeat: {}\n", m.repeat);
  return text;
}

std::string to_text(const ProtocolViolation& violation) {
  return fmt::format("  cycle {}{}, lane {}: {}{}\n", violation.cycle,
                     of_simulation(violation.simulation), violation.lane, violation.fault,
                     violation.details.empty() ? "" : " (" + violation.details + ")");
}

std::string to_text(const LeastCounterexample& least) {
  std::string text = line("least counterexample", least.comparisons);
  if (least.mismatch) text += to_text(*least.mismatch);
  if (least.violation) text += to_text(*least.violation);
  if (!least.waves.empty()) text += fmt::format("    waves: {}\n", least.waves);
  return text;
}

/// "3: 2 where f or g has no value, 1 undetermined"
std::string not_checked(const TruthCount& truth) {
  std::string text = std::to_string(truth.not_checked());
  const char* separator = ": ";
  const auto add = [&](std::uint64_t count, const char* why) {
    if (count == 0) return;
    text += fmt::format("{}{} {}", std::exchange(separator, ", "), count, why);
  };
  add(truth.decided_by_lane, "decided by a lane");
  add(truth.undefined, "where f or g has no value");
  add(truth.undetermined, "whose truth is undetermined");
  add(truth.undecided, "undecided");
  return text;
}

std::string truth_lines(const VerifyReport& r) {
  if (!r.truth) return {};
  const TruthCount& truth = *r.truth;
  std::string text =
      line("against the truth",
           fmt::format("{} checked, {} wrong by a lane, {} by a reference", truth.checked,
                       truth.wrong_by_lane, truth.wrong_by_reference));
  text += line("not checked", not_checked(truth));
  if (r.references == 0) return text;
  return text + line("reference by itself",
                     fmt::format("wrong on {} of {} checked", truth.reference_alone_wrong,
                                 truth.reference_alone_checked));
}

/// "48 (observed 48)"; comparisons of lanes in groups are "12 words of 4 (observed 12)".
std::string counts_of(const CounterTotal& counter, int lanes_per_group) {
  const bool in_words = counter.name == "comparisons" && lanes_per_group > 1;
  return fmt::format("{}{} (observed {})", counter.counted,
                     in_words ? fmt::format(" words of {}", lanes_per_group) : "",
                     counter.observed);
}

std::string totals(const VerifyReport& r) {
  std::string text;
  text += line("comparisons", fmt::format("{} of {}", r.comparisons, r.requested));
  for (const Verdict verdict : all_verdicts) {
    const std::string name(to_string(verdict));
    text += line(name.c_str(), std::to_string(r.verdicts[static_cast<std::size_t>(verdict)]));
  }
  if (r.references == 0) text += line("undecided", std::to_string(r.undecided));
  text +=
      line("recomputations", fmt::format("{} ({:.3e})", r.recomputations, r.recomputation_rate()));
  text += line("cycles", fmt::format("{} ({:.3f} comparisons per cycle)", r.cycles,
                                     r.comparisons_per_cycle()));
  text += latency_line("latency, decided", r.latencies.decided);
  text += r.references == 0 ? latency_line("latency, undecided", r.latencies.undecided)
                            : latency_line("latency, recomputed", r.latencies.recomputed);
  if (r.resets > 0) text += line("resets in mid-stream", std::to_string(r.resets));
  for (const CounterTotal& counter : r.counters) {
    text +=
        line(("counter " + counter.name).c_str(),
             counts_of(counter, r.lanes_per_group) + (r.resets > 0 ? " since the last reset" : ""));
  }
  return text + truth_lines(r);
}

std::string expectation_line(const std::optional<double>& cycles) {
  return cycles ? line("cycles by the model", fmt::format("{:.0f}", *cycles)) : "";
}

std::string engine_lines(const VerifyReport& r) {
  if (!r.engine) return {};
  const PairwiseFigures& engine = *r.engine;
  std::string text = line("engine", fmt::format("{}, {} sets, one of all {} items", engine.top,
                                                engine.sets, engine.items));
  text += line("reported pairs", std::to_string(engine.reported));
  text += line("cycles per pair", fmt::format("{:.5f}", ratio(r.cycles, r.comparisons)));
  text += expectation_line(engine.expected_cycles);
  text += line("stalled cycles", fmt::format("{} ({:.3f} %)", engine.stalled_cycles,
                                             100 * ratio(engine.stalled_cycles, r.cycles)));
  return text + line("bytes in per pair", fmt::format("{:.4f} (streamed as pairs: {})",
                                                      r.item_bytes_per_pair(), engine.pair_bytes));
}

std::string arg_min_lines(const VerifyReport& r) {
  if (!r.arg_min) return {};
  const ArgMinFigures& engine = *r.arg_min;
  std::string text = line("engine", fmt::format("{}, {} loads, one of all {} candidates",
                                                engine.top, engine.loads, engine.candidates));
  text +=
      line("rows", fmt::format("{} ({:.3f} per cycle)", engine.rows, ratio(engine.rows, r.cycles)));
  text += line("unlike the reference", fmt::format("{} rows", engine.rows_unlike_reference));
  text += latency_line("latency of a row", engine.latency);
  text += expectation_line(engine.expected_cycles);
  text += line("loading", fmt::format("{} cycles", engine.loading_cycles));
  return text + line("stalled cycles", std::to_string(engine.stalled_cycles));
}

/// Adds findings to the first ones that are kept.
template <class Finding>
void add_findings(std::vector<Finding>& all, const std::vector<Finding>& more) {
  for (const Finding& finding : more) {
    if (all.size() >= VerifyReport::kept) return;
    all.push_back(finding);
  }
}

std::string judge_lines(const VerifyReport& r) {
  std::string text =
      line("judged by", r.judged_by_emulator == 0
                            ? "the golden model (MPFR, GMP)"
                            : fmt::format("the emulator; the golden model for {} of them",
                                          r.comparisons - r.judged_by_emulator));
  if (r.emulator_errors > 0) text += line("emulator's errors", std::to_string(r.emulator_errors));
  return text;
}

std::string latency_range(const Latency& latency) {
  if (latency.count == 0) return "none";
  return fmt::format("{} .. {} cycles", latency.minimum_cycles, latency.maximum_cycles);
}

/// The lines with the results of each kind of lane; empty where there is one kind.
std::string group_lines(const VerifyReport& r) {
  if (r.groups.size() < 2) return {};
  std::string text;
  for (const GroupReport& group : r.groups) {
    text += fmt::format("  {} {} {}, {}\n", group.lanes, group.lanes == 1 ? "lane" : "lanes",
                        group.name, group.certified ? "certified" : "not certified");
    const auto add = [&text](const char* name, const std::string& value) {
      text += fmt::format("    {:<20} {}\n", name, value);
    };
    add("comparisons", std::to_string(group.comparisons));
    if (r.references == 0) add("undecided", std::to_string(group.undecided));
    add("recomputations", fmt::format("{} ({:.3e})", group.recomputations,
                                      ratio(group.recomputations, group.comparisons)));
    add("latency, decided", latency_range(group.latencies.decided));
    if (r.references == 0) add("latency, undecided", latency_range(group.latencies.undecided));
    if (r.references > 0) add("latency, recomputed", latency_range(group.latencies.recomputed));
    if (r.truth) add("wrong by a lane", std::to_string(group.wrong_by_lane));
    add("mismatches", std::to_string(group.mismatches));
  }
  return text;
}

/// Adds remarks on lanes of one kind that no count of mismatches shows.
void add_notes(std::vector<std::string>& notes, const GroupReport& group) {
  if (group.comparisons == 0) {
    notes.push_back(fmt::format("no comparison went through the lanes {}", group.name));
  } else if (group.recomputations + group.undecided == group.comparisons) {
    notes.push_back(fmt::format("the lanes {} decided nothing: all of {} comparisons {}",
                                group.name, group.comparisons,
                                group.undecided == 0 ? "were recomputed" : "were left undecided"));
  }
  if (!group.certified && group.wrong_by_lane > 0) {
    notes.push_back(
        fmt::format("the lanes {} decided {} of {} comparisons wrongly, which does not "
                    "fail since they are not certified",
                    group.name, group.wrong_by_lane, group.comparisons));
  }
}

std::string input_lines(const VerifyReport& r) {
  std::string text;
  for (const data::InputSource& input : r.inputs) {
    text += line(input.input.c_str(), "<- " + input.shown());
  }
  return text;
}

}  // namespace

void Latency::add(std::uint64_t cycles) {
  minimum_cycles = count == 0 ? cycles : std::min(minimum_cycles, cycles);
  maximum_cycles = std::max(maximum_cycles, cycles);
  total_cycles += cycles;
  ++count;
}

void Latency::add(const Latency& other) {
  if (other.count == 0) return;
  minimum_cycles =
      count == 0 ? other.minimum_cycles : std::min(minimum_cycles, other.minimum_cycles);
  maximum_cycles = std::max(maximum_cycles, other.maximum_cycles);
  count += other.count;
  total_cycles += other.total_cycles;
}

double Latency::mean_cycles() const {
  return ratio(total_cycles, count);
}

void Latencies::add(const Latencies& other) {
  decided.add(other.decided);
  recomputed.add(other.recomputed);
  undecided.add(other.undecided);
}

void TruthCount::add(const TruthCount& other) {
  checked += other.checked;
  wrong_by_lane += other.wrong_by_lane;
  wrong_by_reference += other.wrong_by_reference;
  reference_alone_checked += other.reference_alone_checked;
  reference_alone_wrong += other.reference_alone_wrong;
  undefined += other.undefined;
  undetermined += other.undetermined;
  undecided += other.undecided;
  decided_by_lane += other.decided_by_lane;
}

void GroupReport::add(const GroupReport& other) {
  comparisons += other.comparisons;
  recomputations += other.recomputations;
  undecided += other.undecided;
  mismatches += other.mismatches;
  wrong_by_lane += other.wrong_by_lane;
  latencies.add(other.latencies);
}

void VerifyReport::add(VerifyReport share, std::uint64_t simulation) {
  for (Mismatch& mismatch : share.mismatches) mismatch.simulation = simulation;
  for (ProtocolViolation& violation : share.violations) violation.simulation = simulation;
  append(share);
}

void VerifyReport::append(const VerifyReport& share) {
  requested += share.requested;
  comparisons += share.comparisons;
  for (std::size_t k = 0; k < verdicts.size(); ++k) verdicts[k] += share.verdicts[k];
  recomputations += share.recomputations;
  undecided += share.undecided;
  cycles += share.cycles;
  latencies.add(share.latencies);
  for (std::size_t k = 0; k < groups.size(); ++k) groups[k].add(share.groups[k]);
  if (counters.empty()) {
    counters = share.counters;
  } else {
    for (std::size_t k = 0; k < share.counters.size(); ++k) {
      counters[k].counted += share.counters[k].counted;
      counters[k].observed += share.counters[k].observed;
    }
  }
  judged_by_emulator += share.judged_by_emulator;
  emulator_errors += share.emulator_errors;
  mismatch_count += share.mismatch_count;
  add_findings(mismatches, share.mismatches);
  violation_count += share.violation_count;
  add_findings(violations, share.violations);
  if (truth) truth->add(*share.truth);
}

VerifyReport join_portions(const std::vector<VerifyReport>& portions) {
  VerifyReport whole = portions.at(0);
  for (std::size_t k = 1; k < portions.size(); ++k) {
    const std::uint64_t requested = whole.requested + portions[k].requested;
    if (whole.comparisons == whole.requested) whole.append(portions[k]);
    whole.requested = requested;
    whole.build_seconds += portions[k].build_seconds;
    whole.run_seconds += portions[k].run_seconds;
  }
  return whole;
}

bool VerifyReport::passed() const {
  const bool proof_holds = std::all_of(groups.begin(), groups.end(), [](const GroupReport& group) {
    return !group.certified || group.wrong_by_lane == 0;
  });
  return comparisons == requested && mismatch_count == 0 && violation_count == 0 &&
         emulator_errors == 0 && proof_holds;
}

double VerifyReport::recomputation_rate() const {
  return ratio(recomputations, comparisons);
}
double VerifyReport::comparisons_per_cycle() const {
  return ratio(comparisons, cycles);
}

double VerifyReport::item_bytes_per_pair() const {
  return engine ? ratio(engine->items * engine->item_bytes, comparisons) : 0;
}

std::vector<std::string> notes_on(const VerifyReport& r) {
  if (r.comparisons == 0) return {"no comparison was made, so nothing was verified"};
  std::vector<std::string> notes;
  for (const GroupReport& group : r.groups) add_notes(notes, group);
  if (r.references > 0 && r.recomputations == 0) {
    notes.push_back("none of these comparisons was recomputed: they put no reference to the test");
  }
  if (r.verdicts[static_cast<std::size_t>(Verdict::unordered)] == r.comparisons) {
    notes.push_back("every verdict is unordered");
  }
  if (r.truth && r.truth->checked == 0) {
    notes.push_back("no verdict was held against the truth");
  }
  return notes;
}

std::string to_text(const VerifyReport& r) {
  const std::string groups =
      r.lanes_per_group == 1 ? "" : fmt::format(" in groups of {}", r.lanes_per_group);
  std::string text = fmt::format(
      "{}: {}, p_L = {}{}, p_H = {}, {}, {}\n", r.passed() ? "passed" : "FAILED", r.system, r.lanes,
      groups, r.references, r.certified ? "certified" : "not certified", r.simulator);
  text += input_lines(r);
  text += totals(r);
  text += engine_lines(r);
  text += arg_min_lines(r);
  text += group_lines(r);
  text += judge_lines(r);
  text += line("mismatches", std::to_string(r.mismatch_count));
  for (const Mismatch& mismatch : r.mismatches) text += to_text(mismatch);
  text += line("protocol violations", std::to_string(r.violation_count));
  for (const ProtocolViolation& violation : r.violations) text += to_text(violation);
  if (r.counterexample) text += to_text(*r.counterexample);
  for (const std::string& note : notes_on(r)) text += line("note", note);
  return text;
}

}  // namespace mixcmp::verilator_tb

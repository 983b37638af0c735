#include "verilator_tb/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

#include "model/base/number/verdict.hpp"

namespace mixcmp::verilator_tb {

namespace {

double ratio(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

/// Adds findings to the first ones that are kept.
template <class Finding>
void add_findings(std::vector<Finding>& all, const std::vector<Finding>& more) {
  for (const Finding& finding : more) {
    if (all.size() >= VerifyReport::kept) return;
    all.push_back(finding);
  }
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
  ordered_without_value += other.ordered_without_value;
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

}  // namespace mixcmp::verilator_tb

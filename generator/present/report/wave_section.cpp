#include <fmt/format.h>

#include <algorithm>

#include "generator/present/page/waveform.hpp"
#include "generator/present/report/report_sections.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::report {
namespace {

using Transfer = LaneTraffic::Transfer;

constexpr int decided_color = 0, left_color = 1;

std::string_view sign_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::less: return "<";
    case Verdict::equal: return "=";
    case Verdict::greater: return ">";
    case Verdict::unordered: return "?";
  }
  MIXCMP_CHECK(false);
}

std::string result_text(const Transfer& transfer) {
  const ResultWord& result = transfer.result;
  if (result.is_undecided()) return "undecided";
  return fmt::format("{}, {}", to_string(result.verdict()),
                     result.is_recomputed() ? "recomputed by a reference" : "decided by the lane");
}

std::uint64_t latency(const Transfer& transfer) {
  return transfer.cycle_left - transfer.cycle_accepted;
}

/// The two comparisons that the picture follows.
struct Followed {
  const Transfer* left = nullptr;     ///< the first that the lane left undecided
  const Transfer* decided = nullptr;  ///< accepted soon after the other
};

Followed follow(const LaneTraffic& traffic) {
  Followed followed;
  for (const Transfer& transfer : traffic.transfers) {
    if (!transfer.result.is_decided_by_lane() && followed.left == nullptr) {
      followed.left = &transfer;
    }
    const bool later =
        followed.left != nullptr && transfer.cycle_accepted > followed.left->cycle_accepted;
    if (later && followed.decided == nullptr && transfer.result.is_decided_by_lane()) {
      followed.decided = &transfer;
    }
  }
  for (const Transfer& transfer : traffic.transfers) {
    if (followed.decided != nullptr) break;
    if (transfer.result.is_decided_by_lane()) followed.decided = &transfer;
  }
  return followed;
}

/// Cycles around `cycles`, joined where they are near each other.
std::vector<page::WaveWindow> windows_around(std::vector<std::uint64_t> cycles) {
  constexpr std::uint64_t before = 3, behind = 3, near = 2;
  std::sort(cycles.begin(), cycles.end());
  std::vector<page::WaveWindow> windows;
  for (const std::uint64_t cycle : cycles) {
    const std::uint64_t first = cycle < before ? 0 : cycle - before;
    if (!windows.empty() && first <= windows.back().last + near) {
      windows.back().last = std::max(windows.back().last, cycle + behind);
    } else {
      windows.push_back({first, cycle + behind});
    }
  }
  return windows;
}

page::WaveBeat beat(const Transfer& transfer, const Followed& followed, std::string text) {
  int color = -1;
  if (&transfer == followed.left) color = left_color;
  if (&transfer == followed.decided) color = decided_color;
  return {std::move(text), color,
          fmt::format("comparison {}\n{}\naccepted in cycle {}, left in cycle {}", transfer.index,
                      result_text(transfer), transfer.cycle_accepted, transfer.cycle_left)};
}

std::vector<page::WaveRow> rows_of(const LaneTraffic& traffic, const Followed& followed) {
  page::WaveBit accepted, left;
  page::WaveBus entering, leaving, verdicts;
  std::uint64_t number = 0;
  for (const Transfer& transfer : traffic.transfers) {
    const std::string name = fmt::format("{}", number++);
    accepted.high.insert(transfer.cycle_accepted);
    left.high.insert(transfer.cycle_left);
    entering.beats[transfer.cycle_accepted] = beat(transfer, followed, name);
    leaving.beats[transfer.cycle_left] = beat(transfer, followed, name);
    std::string verdict(transfer.result.is_undecided() ? "-" : sign_of(transfer.result.verdict()));
    if (transfer.result.is_recomputed()) verdict += " R";
    verdicts.beats[transfer.cycle_left] = beat(transfer, followed, std::move(verdict));
  }
  return {{"aclk", page::WaveClock{}},           {"s_axis: accepted", std::move(accepted)},
          {"comparison", std::move(entering)},   {"m_axis: result leaves", std::move(left)},
          {"of comparison", std::move(leaving)}, {"verdict", std::move(verdicts)}};
}

page::Waveform waveform_of(const LaneTraffic& traffic, const Followed& followed) {
  const Transfer& first = followed.left != nullptr ? *followed.left : *followed.decided;
  std::vector<std::uint64_t> cycles;
  for (const Transfer* transfer : {followed.left, followed.decided}) {
    if (transfer == nullptr) continue;
    cycles.push_back(transfer->cycle_accepted);
    cycles.push_back(transfer->cycle_left);
  }
  return {.title = "Comparisons in the streams of a lane",
          .cycle_zero = first.cycle_accepted,
          .windows = windows_around(std::move(cycles)),
          .rows = rows_of(traffic, followed)};
}

/// Tells the fate of the comparison that the lane left undecided, if there is one.
std::string fate_of_left(const LaneTraffic& traffic, const Followed& followed) {
  const auto count =
      std::count_if(traffic.transfers.begin(), traffic.transfers.end(),
                    [](const Transfer& transfer) { return !transfer.result.is_decided_by_lane(); });
  if (count == 0) {
    return fmt::format(" The lane decided all {} that were simulated.", traffic.transfers.size());
  }
  const std::string of_all =
      fmt::format(" The lane left {} of {} undecided.", count, traffic.transfers.size());
  if (!followed.left->result.is_recomputed()) {
    return of_all + fmt::format(
                        " Comparison {} of the data is the first; nothing decides it, since "
                        "the system has no reference.",
                        followed.left->index);
  }
  return of_all + fmt::format(
                      " Comparison {} of the data is the first; it came back from a "
                      "reference after {} cycles: {} (R).",
                      followed.left->index, latency(*followed.left),
                      to_string(followed.left->result.verdict()));
}

std::string caption(const LaneTraffic& traffic, const Followed& followed) {
  std::string text = fmt::format(
      "Transfers on the streams of one lane, numbered as it accepted them ({}, simulated with {}).",
      traffic.system, traffic.simulator);
  text += fate_of_left(traffic, followed);
  if (followed.decided != nullptr) {
    text += fmt::format(" Comparison {} was decided by the lane in {} cycles: {}.",
                        followed.decided->index, latency(*followed.decided),
                        to_string(followed.decided->result.verdict()));
  }
  return text;
}

}  // namespace

page::Section wave_section(const IfThere<LaneTraffic>& there) {
  page::Section section{"waves", "Waves", {}};
  if (const auto* missing = std::get_if<Missing>(&there)) {
    section.content.push_back(page::missing(missing->why, missing->command));
    return section;
  }
  const auto& traffic = std::get<LaneTraffic>(there);
  const Followed followed = follow(traffic);
  MIXCMP_CHECK(followed.left != nullptr || followed.decided != nullptr);
  section.content.push_back(
      page::figure(draw(waveform_of(traffic, followed)), caption(traffic, followed)));
  return section;
}

}  // namespace mixcmp::report

#include "tests/rtl_templates/engine/pairwise_run.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "tests/rtl_templates/engine/mix.hpp"

namespace mixcmp::test {
namespace {

constexpr std::uint32_t recomputed_flag = 4;
constexpr std::uint32_t undecided_flag = 8;
constexpr std::uint32_t overrun_flag = 0x40;
constexpr std::uint32_t closing_flag = 0x80;

/// The function of the same name in pairwise_bench.
std::uint32_t hash(std::uint32_t item_i, std::uint32_t item_j) {
  std::uint32_t mixed = (item_i << 12) ^ (item_j * 0x9e3779b1u);
  mixed = (mixed ^ (mixed >> 15)) * 0x85ebca77u;
  return mixed ^ (mixed >> 13);
}

int bytes_of(int bits) {
  return (bits + 7) / 8;
}

}  // namespace

EngineRun::EngineRun(const EngineSpec& spec, std::uint64_t seed)
    : spec_(spec),
      dut_(spec.make()),
      random_(seed),
      streams_(static_cast<std::size_t>(spec.streams)) {
  reset();
  resets_ = 0;
}

void EngineRun::fail(const std::string& what) {
  if (failed()) return;
  failure_ = fmt::format("{}: {} (cycle {}, set {} of {} items, {} targets)", spec_.name, what,
                         cycles_, set_number_, set_.items, set_.targets);
}

void EngineRun::edge() {
  dut_->aclk.set_bit(0, true);
  dut_->eval();
  dut_->aclk.set_bit(0, false);
  dut_->eval();
}

void EngineRun::reset() {
  for (harness::Port* port : {&dut_->s_axis_tvalid, &dut_->aclk, &dut_->aresetn}) {
    port->set_bit(0, false);
  }
  for (std::size_t s = 0; s < streams_.size(); ++s) {
    dut_->m_axis_tready.set_bit(s, false);
    streams_[s] = {};
  }
  dut_->eval();
  edge();
  dut_->aresetn.set_bit(0, true);
  dut_->eval();
  offering_ = false;
  counted_recomputations_ = busy_cycles_ = 0;
  ++resets_;
}

std::uint32_t EngineRun::item(std::uint32_t index) const {
  return mix(set_number_, set_.equal ? 0 : index + 1) & ((1u << item_bits) - 1);
}

bool EngineRun::is_target(std::uint32_t index) const {
  return index < static_cast<std::uint32_t>(set_.targets);
}

std::uint32_t EngineRun::kept() const {
  return static_cast<std::uint32_t>(std::min(set_.items, spec_.capacity));
}

void EngineRun::start_set(const ItemSet& set) {
  ++set_number_;
  set_ = set;
  loaded_ = 0;
  open_ = true;
  due_.clear();
  reports_.clear();
  asked_ = 0;
  for (Stream& stream : streams_) {
    stream.closed = false;
    stream.pairs = stream.set_beats = 0;
  }
  for (std::uint32_t j = 0; j < kept(); ++j) {
    for (std::uint32_t i = 0; i < j; ++i) {
      if (set.targets == 0 || is_target(i) != is_target(j)) expect_pair(i, j);
    }
  }
}

void EngineRun::expect_pair(std::uint32_t i, std::uint32_t j) {
  const std::uint32_t mixed = hash(item(i), item(j));
  std::uint32_t verdict = mixed & 3;
  bool undecided = (mixed >> 4 & 15) < spec_.undecided;
  if (undecided && spec_.tiered && (mixed >> 8 & 15) >= spec_.tier_undecided) {
    undecided = false;
    verdict = mixed >> 12 & 3;
  }
  const bool reported = (spec_.report >> verdict & 1) != 0;
  if (undecided && spec_.references == 0) {
    due_[{i, j}] = undecided_flag;
    return;
  }
  if (undecided) ++asked_;
  if (reported) due_[{i, j}] = verdict | (undecided ? recomputed_flag : 0);
}

void EngineRun::run_set(const ItemSet& set, const EngineTraffic& traffic) {
  start_set(set);
  EngineTraffic now = traffic;
  const std::uint64_t start = cycles_;
  for (int limit = 400'000; open_ && !failed(); --limit) {
    if (limit == 0) return fail("the set never ends");
    if (random_.chance(now.reset)) {
      reset();
      start_set(set);
      now.reset = 0;
    }
    if (cycles_ - start >= now.slow_cycles) now.accept = 1;
    cycle(now);
  }
  set_cycles_ = cycles_ - start;
}

void EngineRun::idle(int cycles) {
  for (int k = 0; k < cycles && !failed(); ++k) cycle({.name = "Idle", .offer = 0});
}

void EngineRun::cycle(const EngineTraffic& traffic) {
  drive(traffic);
  dut_->eval();
  if (loaded_ > 0 && open_) ++busy_cycles_;
  for (std::size_t s = 0; s < streams_.size(); ++s) take_beat(s);
  take_item();
  edge();
  ++cycles_;
  const bool all_closed = std::all_of(streams_.begin(), streams_.end(),
                                      [](const Stream& stream) { return stream.closed; });
  if (open_ && all_closed) close();
}

void EngineRun::drive(const EngineTraffic& traffic) {
  if (!offering_ && loaded_ < static_cast<std::uint32_t>(set_.items) && open_) {
    offering_ = random_.chance(traffic.offer);
  }
  const bool last = loaded_ + 1 == static_cast<std::uint32_t>(set_.items);
  dut_->s_axis_tvalid.set_bit(0, offering_);
  dut_->s_axis_tdata.set_field(0, item_bits, offering_ ? item(loaded_) : random_.word() >> 12);
  dut_->s_axis_tuser.set_bit(0, offering_ ? is_target(loaded_) : random_.chance(0.5));
  dut_->s_axis_tlast.set_bit(0, offering_ ? last : random_.chance(0.5));
  for (int r = 0; r < spec_.references; ++r) {
    dut_->reference_ready.set_bit(static_cast<std::size_t>(r), random_.chance(traffic.answer));
  }
  for (std::size_t s = 0; s < streams_.size(); ++s) {
    const bool may = streams_[s].held || !traffic.wary;
    dut_->m_axis_tready.set_bit(s, may && random_.chance(traffic.accept));
  }
}

void EngineRun::take_item() {
  if (!offering_ || !dut_->s_axis_tready.bit(0)) return;
  ++loaded_;
  offering_ = false;
}

void EngineRun::take_beat(std::size_t s) {
  Stream& stream = streams_[s];
  const int index_field = 8 * bytes_of(spec_.index_bits);
  const int flag_bits = spec_.form == ReportForm::bitmap ? spec_.lanes_per_segment : 0;
  const int width = 2 * index_field + 8 * bytes_of(flag_bits);
  const std::size_t low = s * static_cast<std::size_t>(width);
  const bool valid = dut_->m_axis_tvalid.bit(s);
  const bool ready = dut_->m_axis_tready.bit(s);
  const bool last = dut_->m_axis_tlast.bit(s);
  const std::uint64_t tags = dut_->m_axis_tdata.field(low, 2 * index_field);
  const std::uint64_t flags =
      flag_bits > 0 ? dut_->m_axis_tdata.field(low + 2 * index_field, width - 2 * index_field) : 1;
  const auto user = static_cast<std::uint32_t>(dut_->m_axis_tuser.field(8 * s, 8));
  const std::vector<std::uint64_t> beat = {tags, flags, user, last ? 1u : 0u};
  if (stream.held && (!valid || beat != stream.held_beat)) fail("a beat changed on offer");
  stream.held = valid && !ready;
  stream.held_beat = beat;
  if (!valid || !ready) return;
  if (!open_ || stream.closed) return fail(fmt::format("stream {} gave a beat too many", s));
  if (last) return take_closing_beat(stream, tags, user);
  ++stream.beats;
  ++stream.set_beats;
  const auto i = static_cast<std::uint32_t>(tags & ((1u << index_field) - 1));
  take_report(stream, i, static_cast<std::uint32_t>(tags >> index_field), flags, user);
}

void EngineRun::take_report(Stream& stream, std::uint32_t i, std::uint32_t j, std::uint64_t flags,
                            std::uint32_t user) {
  if (flags == 0) fail("a report without a pair");
  for (std::uint32_t k = 0; flags >> k != 0; ++k) {
    if ((flags >> k & 1) == 0) continue;
    if (!reports_.emplace(Tag{i + k, j}, user).second) {
      fail(fmt::format("{} and {} were reported twice", i + k, j));
    }
    ++stream.pairs;
    ++reported_;
    if ((user & recomputed_flag) != 0) ++recomputed_;
  }
}

void EngineRun::take_closing_beat(Stream& stream, std::uint64_t count, std::uint32_t user) {
  if (loaded_ != static_cast<std::uint32_t>(set_.items)) fail("closed before the last item");
  const bool overrun = static_cast<std::uint32_t>(set_.items) > kept();
  if (user != (closing_flag | (overrun ? overrun_flag : 0))) {
    fail(fmt::format("a closing beat with tuser {:02x}", user));
  }
  stream.closed = true;
  if (spec_.form == ReportForm::count) {
    stream.pairs = count;
  } else if (count != stream.set_beats) {
    fail(fmt::format("the closing beat counts {} of {}", count, stream.set_beats));
  }
}

void EngineRun::close() {
  open_ = false;
  counted_recomputations_ += static_cast<std::uint32_t>(asked_);
  if (spec_.form == ReportForm::count) {
    std::uint64_t counted = 0;
    for (const Stream& stream : streams_) counted += stream.pairs;
    if (counted != due_.size()) fail(fmt::format("counted {} of {}", counted, due_.size()));
    if (!reports_.empty()) fail("a report left");
    reported_ += counted;
    return;
  }
  if (reports_ != due_) {
    fail(fmt::format("{} reports where {} were due", reports_.size(), due_.size()));
  }
}

void EngineRun::check_counters() {
  for (std::size_t s = 0; s < streams_.size(); ++s) {
    if (dut_->reports.field(32 * s, 32) != streams_[s].beats) {
      fail("the counter of reports is wrong");
    }
  }
  if (dut_->recomputations.field(0, 32) != counted_recomputations_) {
    fail("the counter of recomputations is wrong");
  }
  if (dut_->busy_cycles.field(0, 32) != busy_cycles_) {
    fail(fmt::format("busy for {} cycles, counted {}", busy_cycles_,
                     dut_->busy_cycles.field(0, 32)));
  }
}

}  // namespace mixcmp::test

#include "tests/rtl_templates/engine/pairwise_run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>

#include "tests/rtl_templates/engine/mix.hpp"

namespace mixcmp::test {
namespace {

constexpr std::uint32_t recomputed_flag = 4;
constexpr std::uint32_t undecided_flag = 8;

}  // namespace

EngineRun::EngineRun(const EngineSpec& spec, std::uint64_t seed)
    : spec_(spec),
      dut_(spec.make()),
      random_(seed),
      lanes_(static_cast<std::size_t>(spec.lanes)),
      references_(static_cast<std::size_t>(spec.references)) {
  reset();
  resets_ = 0;
}

void EngineRun::fail(const std::string& what) {
  if (!failed()) {
    failure_ = fmt::format("{}: {} (cycle {}, set {} of {} items)", spec_.name, what, cycles_, set_,
                           items_);
  }
}

void EngineRun::edge() {
  dut_->aclk.set_bit(0, true);
  dut_->eval();
  dut_->aclk.set_bit(0, false);
  dut_->eval();
}

void EngineRun::reset() {
  for (harness::Port* valid : {&dut_->s_axis_tvalid, &dut_->m_axis_tready, &dut_->aclk}) {
    valid->set_bit(0, false);
  }
  for (std::size_t k = 0; k < lanes_.size(); ++k) {
    dut_->pair_tready.set_bit(k, false);
    dut_->result_tvalid.set_bit(k, false);
    lanes_[k] = {};
  }
  for (std::size_t r = 0; r < references_.size(); ++r) {
    dut_->s_refetch_tvalid.set_bit(r, false);
    dut_->m_answer_tready.set_bit(r, false);
    references_[r] = {};
  }
  dut_->aresetn.set_bit(0, false);
  dut_->eval();
  edge();
  dut_->aresetn.set_bit(0, true);
  dut_->eval();
  offering_ = held_report_ = false;
  counted_reports_ = busy_cycles_ = 0;
  ++resets_;
}

std::uint32_t EngineRun::item(std::uint32_t index) const {
  return mix(set_, equal_ ? 0 : index + 1) & ((1u << item_bits) - 1);
}

std::uint32_t EngineRun::verdict(Tag tag, const EngineTraffic& traffic) const {
  if (traffic.quiet) return static_cast<std::uint32_t>(std::countr_one(spec_.report));
  return mix(item(tag.first), item(tag.second)) % 4;
}

std::uint32_t EngineRun::kept() const {
  return std::min(items_, static_cast<std::uint32_t>(spec_.capacity));
}

void EngineRun::start_set(int items, bool equal) {
  ++set_;
  items_ = static_cast<std::uint32_t>(items);
  equal_ = equal;
  loaded_ = 0;
  open_ = true;
  met_.clear();
  reports_.clear();
}

void EngineRun::run_set(int items, const EngineTraffic& traffic, bool equal) {
  start_set(items, equal);
  EngineTraffic now = traffic;
  const std::uint64_t start = cycles_;
  for (int limit = 400'000; open_ && !failed(); --limit) {
    if (limit == 0) return fail("the set never ends");
    if (random_.chance(now.reset)) {
      reset();
      start_set(items, equal);
      now.reset = 0;
    }
    if (cycles_ - start >= now.slow_cycles) now.take = now.give = 1;
    cycle(now);
  }
  set_cycles_ = cycles_ - start;
}

void EngineRun::idle(int cycles) {
  const std::uint32_t before = counted_reports_;
  for (int k = 0; k < cycles && !failed(); ++k) cycle({.name = "Idle", .offer = 0});
  if (counted_reports_ != before) fail("a report after the closing beat");
}

void EngineRun::cycle(const EngineTraffic& traffic) {
  drive(traffic);
  dut_->eval();
  const bool busy = loaded_ > 0 && open_;
  take_report();
  take_item();
  for (std::size_t k = 0; k < lanes_.size(); ++k) {
    take_pair(k, traffic);
    give_result(k);
  }
  for (std::size_t r = 0; r < references_.size(); ++r) serve_reference(r);
  if (busy) ++busy_cycles_;
  edge();
  ++cycles_;
}

void EngineRun::drive(const EngineTraffic& traffic) {
  if (!offering_ && loaded_ < items_ && open_) offering_ = random_.chance(traffic.offer);
  dut_->s_axis_tvalid.set_bit(0, offering_);
  dut_->s_axis_tdata.set_field(0, item_bits, offering_ ? item(loaded_) : random_.word() >> 12);
  dut_->s_axis_tlast.set_bit(0, offering_ ? loaded_ + 1 == items_ : random_.chance(0.5));
  dut_->m_axis_tready.set_bit(0, (held_report_ || !traffic.wary) && random_.chance(traffic.accept));
  const int tag_bits = 2 * spec_.index_bits;
  for (std::size_t k = 0; k < lanes_.size(); ++k) {
    Lane& lane = lanes_[k];
    dut_->pair_tready.set_bit(k, lane.inside < slots && random_.chance(traffic.take));
    if (!lane.giving) lane.giving = !lane.results.empty() && random_.chance(traffic.give);
    dut_->result_tvalid.set_bit(k, lane.giving);
    if (!lane.giving) continue;
    const Result& result = lane.results.front();
    dut_->result_tdata.set_field(8 * k, 8, result.flags);
    const std::uint32_t tag = result.tag.second << spec_.index_bits | result.tag.first;
    dut_->result_tag.set_field(k * static_cast<std::size_t>(tag_bits), tag_bits, tag);
  }
  for (std::size_t r = 0; r < references_.size(); ++r) {
    Reference& reference = references_[r];
    reference.offering |= !reference.asked.empty() && random_.chance(traffic.take);
    dut_->s_refetch_tvalid.set_bit(r, reference.offering);
    dut_->m_answer_tready.set_bit(r, !reference.awaited.empty() && random_.chance(traffic.give));
    if (!reference.offering) continue;
    const auto [i, j] = reference.asked.front().second;
    dut_->s_refetch_tdata.set_field(r * static_cast<std::size_t>(tag_bits), tag_bits,
                                    j << spec_.index_bits | i);
  }
}

void EngineRun::take_item() {
  if (!offering_ || !dut_->s_axis_tready.bit(0)) return;
  ++loaded_;
  offering_ = false;
}

void EngineRun::take_pair(std::size_t k, const EngineTraffic& traffic) {
  Lane& lane = lanes_[k];
  const bool valid = dut_->pair_tvalid.bit(k);
  const int tag_bits = 2 * spec_.index_bits;
  const std::uint64_t tag = dut_->pair_tag.field(k * static_cast<std::size_t>(tag_bits), tag_bits);
  const std::uint64_t items = dut_->pair_items.field(k * 2 * item_bits, 2 * item_bits);
  if (lane.held && (!valid || lane.held_pair != std::vector{tag, items})) {
    fail(fmt::format("lane {} saw an offer change", k));
  }
  const bool ready = dut_->pair_tready.bit(k);
  lane.held = valid && !ready;
  lane.held_pair = {tag, items};
  if (!valid || !ready) return;
  const Tag pair(tag & ((1u << spec_.index_bits) - 1), tag >> spec_.index_bits);
  const auto [i, j] = pair;
  if (i >= j || j >= kept()) return fail(fmt::format("lane {} met {} and {}", k, i, j));
  if (i % lanes_.size() != k) return fail(fmt::format("lane {} met item {}", k, i));
  if (items != (std::uint64_t{item(j)} << item_bits | item(i))) {
    return fail(fmt::format("items {} and {} are not what was loaded", i, j));
  }
  const bool undecided = random_.chance(traffic.undecided);
  const bool recomputes = undecided && !references_.empty();
  const std::uint32_t flags = verdict(pair, traffic) | (recomputes  ? recomputed_flag
                                                        : undecided ? undecided_flag
                                                                    : 0);
  if (!met_.emplace(pair, flags).second) return fail(fmt::format("{} met {} twice", i, j));
  ++lane.inside;
  if (recomputes) {
    references_[k % references_.size()].asked.emplace_back(k, pair);
  } else {
    lane.results.push_back({pair, flags});
  }
}

void EngineRun::give_result(std::size_t k) {
  Lane& lane = lanes_[k];
  if (!lane.giving || !dut_->result_tready.bit(k)) return;
  lane.results.pop_front();
  lane.giving = false;
  --lane.inside;
}

void EngineRun::serve_reference(std::size_t r) {
  Reference& reference = references_[r];
  if (dut_->m_answer_tvalid.bit(r) && dut_->m_answer_tready.bit(r)) {
    const auto [k, tag] = reference.awaited.front();
    reference.awaited.pop_front();
    const std::uint64_t expected = std::uint64_t{item(tag.second)} << item_bits | item(tag.first);
    if (dut_->m_answer_tdata.field(0, 2 * item_bits) != expected) {
      fail(fmt::format("reference {} got the wrong items for {} and {}", r, tag.first, tag.second));
    }
    lanes_[k].results.push_back({tag, met_.at(tag)});
    ++refetched_;
  }
  if (reference.offering && dut_->s_refetch_tready.bit(r)) {
    reference.awaited.push_back(reference.asked.front());
    reference.asked.pop_front();
    reference.offering = false;
  }
}

void EngineRun::take_report() {
  const int field_bits = (spec_.index_bits + 7) / 8 * 8;
  const bool valid = dut_->m_axis_tvalid.bit(0);
  const bool last = dut_->m_axis_tlast.bit(0);
  const std::uint64_t tdata = dut_->m_axis_tdata.field(0, 2 * field_bits);
  const auto tuser = static_cast<std::uint32_t>(dut_->m_axis_tuser.field(0, 8));
  const std::uint64_t data = tdata << 16 | tuser << 1 | (last ? 1 : 0);
  if (held_report_ && (!valid || data != held_data_)) fail("a report changed before it was taken");
  const bool ready = dut_->m_axis_tready.bit(0);
  held_report_ = valid && !ready;
  held_data_ = data;
  if (!valid || !ready) return;
  if (last) {
    if ((tuser & 0xbf) != 0x80) fail(fmt::format("a closing beat with tuser {:02x}", tuser));
    return close(tdata, (tuser & 0x40) != 0);
  }
  const Tag tag(tdata & ((1u << field_bits) - 1), tdata >> field_bits);
  if (!reports_.emplace(tag, tuser).second) {
    fail(fmt::format("{} and {} were reported twice", tag.first, tag.second));
  }
  ++counted_reports_;
  ++reported_;
  if ((tuser & recomputed_flag) != 0) ++recomputed_;
}

void EngineRun::close(std::uint64_t count, bool overrun) {
  if (!open_) return fail("a closing beat too many");
  open_ = false;
  if (loaded_ != items_) fail(fmt::format("closed after {} items", loaded_));
  if (overrun != (items_ > kept())) fail("overrun is wrong");
  const std::uint64_t pairs = std::uint64_t{kept()} * (kept() - 1) / 2;
  if (met_.size() != pairs) fail(fmt::format("{} of {} pairs met", met_.size(), pairs));
  std::map<Tag, std::uint32_t> expected;
  for (const auto& [tag, flags] : met_) {
    const bool leaves = (spec_.report >> (flags & 3) & 1) != 0 || (flags & undecided_flag) != 0;
    if (leaves) expected.emplace(tag, flags);
  }
  if (reports_ != expected) {
    fail(fmt::format("{} reports where {} were due", reports_.size(), expected.size()));
  }
  if (count != expected.size()) fail(fmt::format("the closing beat counts {}", count));
}

void EngineRun::check_counters() {
  if (dut_->reports.field(0, 32) != counted_reports_) fail("the counter of reports is wrong");
  if (dut_->busy_cycles.field(0, 32) != busy_cycles_) {
    fail(fmt::format("busy for {} cycles, counted {}", busy_cycles_,
                     dut_->busy_cycles.field(0, 32)));
  }
}

}  // namespace mixcmp::test

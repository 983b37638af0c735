#include "tests/rtl_templates/stream/stream_system_run.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>

namespace mixcmp::test {
namespace {

bool bit(std::uint32_t word, int i) {
  return ((word >> i) & 1) != 0;
}

template <class Port>
void set_bit(Port& port, int i, bool value) {
  const std::uint32_t mask = 1u << i;
  port = static_cast<Port>(value ? (port | mask) : (port & ~mask));
}

std::string hex(std::uint32_t value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08x", value);
  return text;
}

/// The tag of comparison n. An odd multiplier permutes the 32-bit numbers, so every tag is new and
/// all its bits are used. The lanes of a group have consecutive numbers from the group's tag on.
/// That tag is odd, so that the sum carries.
std::uint32_t tag_number(std::uint32_t n, int group) {
  const std::uint32_t number = n * 2654435761u;
  return group == 1 ? number : number * 4 + 1;
}

/// The word of one lane of a group, as stream_system_bench makes it.
std::uint32_t word_of_lane(std::uint32_t word, int k) {
  const auto number = static_cast<std::uint32_t>(k);
  const std::uint32_t decided = bit(word, k == 0 ? 2 : 23 + k) ? 4u : 0u;
  return ((word & ~4u) | decided) ^ number ^ (number << 8);
}

bool is_decided(std::uint32_t word) {
  return bit(word, 2);
}

}  // namespace

SystemRun::SystemRun(const SystemSpec& spec, std::uint64_t seed)
    : spec_(spec),
      seed_(seed),
      dut_(spec.make()),
      random_(seed),
      lanes_(spec.lanes),
      memories_(spec.references),
      received_of_lane_(spec.lanes) {
  reset();
}

void SystemRun::fail(const std::string& what) {
  if (failed()) return;
  failure_ = what + "; system " + spec_.name + ", cycle " + std::to_string(cycles_) + ", seed " +
             std::to_string(seed_);
}

/// The tdata of the result that the operands must have.
std::uint8_t SystemRun::expected_result(std::uint32_t word) const {
  const std::uint32_t lane_verdict = (word ^ (word >> 10)) & 3;
  const std::uint32_t reference_verdict = ((word >> 8) ^ (word >> 16)) & 3;
  if (is_decided(word)) return static_cast<std::uint8_t>(lane_verdict);
  if (spec_.references == 0) return static_cast<std::uint8_t>(8 | lane_verdict);
  return static_cast<std::uint8_t>(4 | reference_verdict);
}

/// The results of a group's lanes, a byte each.
std::uint32_t SystemRun::expected_results(std::uint32_t word) const {
  std::uint32_t results = 0;
  for (int k = 0; k < spec_.group; ++k) {
    results |= static_cast<std::uint32_t>(expected_result(word_of_lane(word, k))) << (8 * k);
  }
  return results;
}

std::uint32_t SystemRun::undecided_lanes(std::uint32_t word) const {
  std::uint32_t lanes = 0;
  for (int k = 0; k < spec_.group; ++k) lanes += is_decided(word_of_lane(word, k)) ? 0 : 1;
  return lanes;
}

/// A word in which each lane is undecided with this chance.
std::uint32_t SystemRun::random_word(double undecided) {
  std::uint32_t word = random_.word();
  for (int k = 0; k < spec_.group; ++k) {
    set_bit(word, k == 0 ? 2 : 23 + k, !random_.chance(undecided));
  }
  return word;
}

void SystemRun::edge() {
  *dut_->aclk = 0;
  dut_->eval();
  *dut_->aclk = 1;
  dut_->eval();
}

void SystemRun::reset() {
  *dut_->aresetn = 0;
  *dut_->s_valid = 0;
  *dut_->m_ready = 0;
  *dut_->m_refetch_ready = 0;
  *dut_->s_refetch_valid = 0;
  const std::uint32_t cycles = 1 + random_.below(3);
  for (std::uint32_t cycle = 0; cycle < cycles; ++cycle) edge();
  *dut_->aresetn = 1;
  std::fill(lanes_.begin(), lanes_.end(), Lane{});
  std::fill(memories_.begin(), memories_.end(), Memory{});
  word_of_tag_.clear();
  operands_of_tag_.clear();
}

void SystemRun::drive(const SystemTraffic& traffic) {
  for (int i = 0; i < spec_.lanes; ++i) {
    Lane& lane = lanes_[i];
    if (!lane.offering && random_.chance(traffic.offer)) {
      lane.offer = {tag_number(issued_++, spec_.group), random_word(traffic.undecided)};
      lane.offering = true;
    }
    (*dut_->s_operands)[i] = lane.offering ? lane.offer.word : random_.word();
    (*dut_->s_tags)[i] = lane.offering ? lane.offer.tag : random_.word();
    set_bit(*dut_->s_valid, i, lane.offering);
    set_bit(*dut_->m_ready, i, random_.chance(traffic.accept));
  }
}

void SystemRun::drive_memories(const SystemTraffic& traffic) {
  for (int r = 0; r < spec_.references; ++r) {
    Memory& memory = memories_[r];
    const bool ready = random_.chance(traffic.refetch);
    set_bit(*dut_->m_refetch_ready, r, ready);
    // A memory may answer in the cycle in which it is asked, even before the sender is known.
    const bool asked = ready && bit(*dut_->m_refetch_valid, r);
    if (asked) memory.asked.push_back((*dut_->m_refetch_tags)[r]);
    const bool at_once = asked && memory.asked.size() == 1;
    memory.giving = memory.giving || (!memory.asked.empty() && random_.chance(traffic.refetch) &&
                                      (!at_once || random_.chance(0.5)));
    const bool known = memory.giving && operands_of_tag_.count(memory.asked.front()) != 0;
    (*dut_->s_refetch_operands)[r] =
        known ? operands_of_tag_.at(memory.asked.front()) : random_.word();
    set_bit(*dut_->s_refetch_valid, r, memory.giving);
  }
}

void SystemRun::check_that_valid_ignores_ready() {
  const IData ready = *dut_->m_ready;
  const SData refetch_ready = *dut_->m_refetch_ready;
  const IData valid = *dut_->m_valid;
  const SData refetch_valid = *dut_->m_refetch_valid;
  *dut_->m_ready = ~ready;
  *dut_->m_refetch_ready = static_cast<SData>(~refetch_ready);
  dut_->eval();
  if (*dut_->m_valid != valid) fail("m_axis_tvalid follows m_axis_tready");
  if (*dut_->m_refetch_valid != refetch_valid) fail("m_refetch_tvalid follows m_refetch_tready");
  *dut_->m_ready = ready;
  *dut_->m_refetch_ready = refetch_ready;
  dut_->eval();
}

void SystemRun::take_input(int i) {
  Lane& lane = lanes_[i];
  if (!lane.offering) return;
  if (!bit(*dut_->s_ready, i)) {
    ++lane.stalls;
    return;
  }
  lane.offering = false;
  lane.order.push_back(lane.offer.tag);
  word_of_tag_[lane.offer.tag] = lane.offer.word;
  for (int k = 0; k < spec_.group; ++k) {
    operands_of_tag_[lane.offer.tag + static_cast<std::uint32_t>(k)] =
        word_of_lane(lane.offer.word, k);
  }
  ++lane.comparisons;
  ++accepted_;
  lane.undecided += undecided_lanes(lane.offer.word);
}

void SystemRun::check_that_result_holds(int i) {
  Lane& lane = lanes_[i];
  const bool valid = bit(*dut_->m_valid, i);
  const std::uint32_t result = (*dut_->m_results)[i];
  const std::uint32_t tag = (*dut_->m_tags)[i];
  if (lane.held && !valid) fail("a result fell before it was taken");
  if (lane.held && (result != lane.held_result || tag != lane.held_tag)) {
    fail("a result changed before it was taken");
  }
  lane.held = valid && !bit(*dut_->m_ready, i);
  lane.held_result = result;
  lane.held_tag = tag;
}

void SystemRun::take_result(int i) {
  if (!bit(*dut_->m_valid, i) || !bit(*dut_->m_ready, i)) return;
  Lane& lane = lanes_[i];
  const std::uint32_t tag = (*dut_->m_tags)[i];
  const std::uint32_t result = (*dut_->m_results)[i];
  const auto position = std::find(lane.order.begin(), lane.order.end(), tag);
  const std::string where = "lane " + std::to_string(i) + ", tag " + hex(tag);
  if (position == lane.order.end()) return fail(where + " is not outstanding in this lane");
  if (position != lane.order.begin()) ++overtaken_;
  if (spec_.in_order && position != lane.order.begin()) return fail(where + " left out of order");
  const std::uint32_t word = word_of_tag_.at(tag);
  if (result != expected_results(word)) {
    return fail(where + ", operands " + hex(word) + ": expected " + hex(expected_results(word)) +
                ", got " + hex(result));
  }
  lane.order.erase(position);
  word_of_tag_.erase(tag);
  for (int k = 0; k < spec_.group; ++k) {
    operands_of_tag_.erase(tag + static_cast<std::uint32_t>(k));
  }
  ++received_;
  ++received_of_lane_[i];
  recomputed_ += undecided_lanes(word);
}

void SystemRun::serve_memory(int r) {
  Memory& memory = memories_[r];
  const std::uint32_t tag = (*dut_->m_refetch_tags)[r];
  const bool valid = bit(*dut_->m_refetch_valid, r);
  if (memory.giving && bit(*dut_->s_refetch_ready, r)) {
    memory.asked.pop_front();
    memory.giving = false;
  }
  if (memory.held && (!valid || tag != memory.held_tag)) fail("a refetch changed before ready");
  memory.held = valid && !bit(*dut_->m_refetch_ready, r);
  memory.held_tag = tag;
  if (!valid || memory.held) return;
  if (operands_of_tag_.count(tag) == 0) fail("refetch of " + hex(tag) + ", not outstanding");
}

void SystemRun::cycle(const SystemTraffic& traffic) {
  if (random_.chance(traffic.reset)) return reset();
  drive(traffic);
  drive_memories(traffic);
  *dut_->aclk = 0;
  dut_->eval();
  check_that_valid_ignores_ready();
  for (int r = 0; r < spec_.references; ++r) serve_memory(r);
  for (int i = 0; i < spec_.lanes; ++i) {
    check_that_result_holds(i);
    take_result(i);
    take_input(i);
  }
  *dut_->aclk = 1;
  dut_->eval();
  ++cycles_;
}

int SystemRun::drain(int limit) {
  const auto is_offering = [](const Lane& lane) { return lane.offering; };
  const auto is_busy = [&] {
    return outstanding() != 0 || std::any_of(lanes_.begin(), lanes_.end(), is_offering);
  };
  int cycles = 0;
  while (is_busy() && cycles < limit && !failed()) {
    cycle({.offer = 0.0});
    ++cycles;
  }
  if (is_busy()) fail(std::to_string(outstanding()) + " comparisons never left");
  return cycles;
}

std::uint64_t SystemRun::outstanding() const {
  return word_of_tag_.size();
}

void SystemRun::check_counters() {
  cycle({.offer = 0.0});  // several events of one cycle are counted a cycle later
  for (int i = 0; i < spec_.lanes; ++i) {
    const Lane& lane = lanes_[i];
    const auto check = [&](const char* name, std::uint32_t got, std::uint32_t expected) {
      if (got == expected) return;
      fail(std::string(name) + " of lane " + std::to_string(i) + ": expected " +
           std::to_string(expected) + ", got " + std::to_string(got));
    };
    check("comparisons", (*dut_->comparisons)[i], lane.comparisons);
    check("recomputations", (*dut_->recomputations)[i], lane.undecided);
    check("stalls", (*dut_->stalls)[i], lane.stalls);
  }
}

}  // namespace mixcmp::test

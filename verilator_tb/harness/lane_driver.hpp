#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

#include "feed.hpp"
#include "hold_checker.hpp"
#include "in_flight.hpp"
#include "ports.hpp"
#include "recorder.hpp"
#include "system.hpp"
#include "traffic.hpp"
#include "verdict.hpp"

namespace mixcmp::harness {

/// The testbench of the two streams of a lane, or of a group of lanes in lock step: it offers
/// comparisons, takes results and records both.
class LaneDriver {
public:
  LaneDriver(int index, Ports& ports, Recorder& recorder)
      : index_(static_cast<std::uint32_t>(index)),
        ports_(ports),
        recorder_(recorder),
        in_flight_(system::tag_bits, lane_bits(), base(index), tags_of_a_lane(), ring_size()) {}

  void drive(Feed& feed, const Traffic& traffic, std::uint64_t cycle) {
    if (offered_ == nullptr && feed.size() > 0 && traffic.willing(index_, cycle)) {
      offer(feed, cycle);
    }
    ports_.s_axis_tvalid.set_bit(index_, offered_ != nullptr);
    ready_ = traffic.willing(system::lanes + index_, cycle);
    ports_.m_axis_tready.set_bit(index_, ready_);
  }

  void sample(std::uint64_t cycle) {
    if (offered_ != nullptr) sample_offer(cycle);
    const bool valid = ports_.m_axis_tvalid.bit(index_);
    const std::uint8_t* const bytes = ports_.m_axis_tdata.bytes(first_lane());
    results_.assign(bytes, bytes + system::lanes_per_group);
    const std::uint64_t tag =
        ports_.m_axis_tuser.field(std::size_t{index_} * system::tag_bits, system::tag_bits);
    if (const auto fault = hold_.observe(valid, ready_, results_, tag)) {
      report(*fault, wire::no_position, tag, cycle);
    }
    if (valid && ready_) deliver(tag, cycle);
  }

  /// Gives the comparisons that were offered or inside back to `feed`: the system is held in reset
  /// and has lost them.
  void discard(Feed& feed) {
    for (Entry& entry : in_flight_.entries()) {
      if (!entry.busy()) continue;
      feed.give_back(entry);
      entry.state = Entry::State::discarded;
    }
    offered_ = nullptr;
    inside_ = 0;
    observed_ = {};
    hold_.reset();
    ports_.s_axis_tvalid.set_bit(index_, false);
    ports_.m_axis_tready.set_bit(index_, false);
  }

  void check_silent_in_reset(std::uint64_t cycle) {
    if (!ports_.m_axis_tvalid.bit(index_)) return;
    report(wire::Fault::valid_in_reset, wire::no_position, 0, cycle);
  }

  /// Reports comparisons that have waited for more than `limit` cycles; true if the lane hangs.
  bool check_overdue(std::uint64_t cycle, std::uint64_t limit) {
    bool hung = false;
    for (Entry& entry : in_flight_.entries()) {
      if (!entry.busy() || cycle - entry.cycle <= limit) continue;
      const bool lane_goes_on = entry.state == Entry::State::inside &&
                                (last_left_ > entry.sequence || ports_.s_axis_tready.bit(index_));
      for (const std::uint64_t position : entry.positions) {
        report(lane_goes_on ? wire::Fault::lost : wire::Fault::hung, position,
               in_flight_.tag(entry), cycle);
      }
      if (lane_goes_on) {
        entry.state = Entry::State::left;
        --inside_;
      }
      hung |= !lane_goes_on;
    }
    return hung;
  }

  bool busy() const { return offered_ != nullptr || inside_ > 0; }

  /// The operands of the comparison inside that has `tag`; null if there is none.
  const std::uint8_t* operands_of(std::uint64_t tag) {
    const Entry* entry = in_flight_.find_word(tag);
    const std::uint64_t lane = in_flight_.lane_of(tag);
    const bool inside = entry != nullptr && entry->state == Entry::State::inside &&
                        lane < static_cast<std::uint64_t>(system::lanes_per_group);
    return inside ? &entry->operands[lane * system::tdata_bytes] : nullptr;
  }

  wire::CounterValues counters() const {
    wire::CounterValues end{{},
                            {observed_.comparisons, observed_.recomputations, observed_.stalls}};
    if (system::counter_bits == 0) return end;
    const Port* const counters[] = {&ports_.comparisons, &ports_.recomputations, &ports_.stalls};
    for (int k = 0; k < 3; ++k) {
      end.counted[k] =
          counters[k]->field(std::size_t{index_} * system::counter_bits, system::counter_bits);
    }
    return end;
  }

private:
  using Results = std::vector<std::uint8_t>;  ///< of each lane of the group

  struct Observed {
    std::uint64_t comparisons = 0;
    std::uint64_t recomputations = 0;
    std::uint64_t stalls = 0;
  };

  /// Room for the comparisons inside and, for a while, for those that have left, so that duplicate
  /// results are recognised.
  static std::size_t ring_size() { return 4 * static_cast<std::size_t>(system::slots); }

  /// A memory finds refetched operands only by their tag: with refetched operands, lanes share no
  /// tags.
  static bool refetched() { return system::refetch_streams > 0; }
  static int lane_bits() {
    return refetched() ? std::bit_width(static_cast<unsigned>(system::lanes_per_group - 1)) : 0;
  }
  static std::uint64_t tag_space() {
    return std::uint64_t{1} << std::min(system::tag_bits - lane_bits(), 63);
  }
  static std::uint64_t tags_of_a_lane() {
    return refetched() ? tag_space() / system::groups : tag_space();
  }
  static std::uint64_t base(int index) {
    return tag_space() / system::groups * static_cast<std::uint64_t>(index);
  }
  std::uint32_t first_lane() const { return index_ * system::lanes_per_group; }

  void offer(Feed& feed, std::uint64_t cycle) {
    offered_ = in_flight_.allocate();
    if (offered_ == nullptr) return;
    feed.take(*offered_, system::lanes_per_group);
    offered_->state = Entry::State::offered;
    offered_->cycle = cycle;
    std::memcpy(ports_.s_axis_tdata.bytes(std::size_t{first_lane()} * system::tdata_bytes),
                offered_->operands.data(), offered_->operands.size());
    ports_.s_axis_tuser.set_field(std::size_t{index_} * system::tag_bits, system::tag_bits,
                                  in_flight_.tag(*offered_));
  }

  void sample_offer(std::uint64_t cycle) {
    if (!ports_.s_axis_tready.bit(index_)) {
      ++observed_.stalls;
      return;
    }
    offered_->state = Entry::State::inside;
    offered_->cycle = cycle;
    offered_->sequence = ++accepted_;
    offered_ = nullptr;
    ++inside_;
    ++observed_.comparisons;
  }

  void deliver(std::uint64_t tag, std::uint64_t cycle) {
    Entry* const entry = in_flight_.find(tag);
    if (entry == nullptr || entry->state != Entry::State::inside) {
      report(fault_of(entry), entry == nullptr ? wire::no_position : entry->positions[0], tag,
             cycle);
      return;
    }
    if (system::in_order && has_earlier(*entry)) {
      report(wire::Fault::order_broken, entry->positions[0], tag, cycle);
    }
    entry->state = Entry::State::left;
    last_left_ = std::max(last_left_, entry->sequence);
    --inside_;
    for (std::uint32_t k = 0; k < results_.size(); ++k) {
      if (!ResultWord(results_[k]).is_decided_by_lane()) ++observed_.recomputations;
      if (k >= entry->positions.size()) continue;
      recorder_.result({entry->positions[k], entry->cycle, cycle, first_lane() + k, results_[k]});
    }
  }

  static wire::Fault fault_of(const Entry* entry) {
    if (entry == nullptr || entry->state == Entry::State::offered) return wire::Fault::unknown_tag;
    return entry->state == Entry::State::left ? wire::Fault::duplicate_tag
                                              : wire::Fault::stale_after_reset;
  }

  bool has_earlier(const Entry& entry) {
    for (const Entry& other : in_flight_.entries()) {
      if (other.state == Entry::State::inside && other.sequence < entry.sequence) return true;
    }
    return false;
  }

  void report(wire::Fault fault, std::uint64_t position, std::uint64_t tag, std::uint64_t cycle) {
    recorder_.violation({fault, first_lane(), position, tag, cycle});
  }

  std::uint32_t index_;
  Ports& ports_;
  Recorder& recorder_;
  InFlight in_flight_;
  HoldChecker<Results> hold_;
  Results results_;  ///< on the port in this cycle
  Observed observed_;
  Entry* offered_ = nullptr;
  bool ready_ = false;
  std::uint64_t inside_ = 0;
  std::uint64_t accepted_ = 0;
  std::uint64_t last_left_ = 0;
};

}  // namespace mixcmp::harness

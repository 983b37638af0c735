#pragma once

#include <cstdint>
#include <cstring>
#include <deque>
#include <vector>

#include "lane_driver.hpp"

namespace mixcmp::harness {

/// The user's memory behind one reference: takes tags, answers with operands, in order.
class RefetchMemory {
public:
  RefetchMemory(int index, Ports& ports, Recorder& recorder)
      : index_(static_cast<std::uint32_t>(index)), ports_(ports), recorder_(recorder) {}

  void drive(const Traffic& traffic, std::uint64_t cycle) {
    ready_ = traffic.willing(2 * system::lanes + index_, cycle);
    ports_.m_refetch_tready.set_bit(index_, ready_);
    const bool valid = !answers_.empty() && answers_.front().cycle <= cycle;
    ports_.s_refetch_tvalid.set_bit(index_, valid);
    if (valid) {
      std::memcpy(ports_.s_refetch_tdata.bytes(std::size_t{index_} * system::tdata_bytes),
                  answers_.front().operands.data(), system::tdata_bytes);
    }
    latency_ = traffic.memory_latency(2 * system::lanes + index_, cycle);
  }

  void sample(std::vector<LaneDriver>& lanes, std::uint64_t cycle) {
    if (ports_.s_refetch_tvalid.bit(index_) && ports_.s_refetch_tready.bit(index_)) {
      answers_.pop_front();
    }
    const bool valid = ports_.m_refetch_tvalid.bit(index_);
    const std::uint64_t tag =
        ports_.m_refetch_tdata.field(std::size_t{index_} * tag_field_bits(), system::tag_bits);
    if (const auto fault = hold_.observe(valid, ready_, tag, 0)) {
      recorder_.violation({*fault, index_, wire::no_position, tag, cycle});
    }
    if (valid && ready_) answer(lanes, tag, cycle);
  }

  void discard() {
    answers_.clear();
    hold_.reset();
    ports_.m_refetch_tready.set_bit(index_, false);
    ports_.s_refetch_tvalid.set_bit(index_, false);
  }

private:
  struct Answer {
    std::uint64_t cycle;  ///< earliest cycle in which it is offered
    std::vector<std::uint8_t> operands;
  };

  static std::size_t tag_field_bits() { return (system::tag_bits + 7) / 8 * 8; }

  void answer(std::vector<LaneDriver>& lanes, std::uint64_t tag, std::uint64_t cycle) {
    for (LaneDriver& lane : lanes) {
      if (const std::uint8_t* operands = lane.operands_of(tag)) {
        answers_.push_back({cycle + latency_, {operands, operands + system::tdata_bytes}});
        return;
      }
    }
    recorder_.violation({wire::Fault::unknown_refetch, index_, wire::no_position, tag, cycle});
    answers_.push_back({cycle, std::vector<std::uint8_t>(system::tdata_bytes)});
  }

  std::uint32_t index_;
  Ports& ports_;
  Recorder& recorder_;
  HoldChecker<> hold_;
  std::deque<Answer> answers_;
  bool ready_ = false;
  std::uint64_t latency_ = 0;
};

}  // namespace mixcmp::harness

// Drives one verilated pairwise engine on sets of items that a host sends; see
// pairwise_protocol.hpp. It computes nothing about them: which pairs must be reported is the host's
// to judge.

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "channel.hpp"
#include "engine_simulator.hpp"
#include "pairwise_protocol.hpp"

namespace mixcmp::harness {

namespace {

class PairwiseSimulator : EngineSimulator {
public:
  PairwiseSimulator(int count, char** words) : EngineSimulator(count, words) { reset(); }

  void serve(Channel& channel) {
    for (bool last = false; !last && !stopped_;) {
      wire::SetRequest request;
      channel.read(&request, 1);
      items_.resize(request.items * system::item_bytes);
      channel.read(items_.data(), items_.size());
      run(request);
      respond(channel);
      last = request.last != 0;
    }
  }

private:
  /// Cycles simulated after a set, so that a report behind its closing beat shows itself.
  static constexpr int quiet_cycles = 64 + 4 * system::lanes;
  /// Stream numbers for Traffic.
  static constexpr std::uint64_t item_stream = 0;
  static constexpr std::uint64_t report_stream = 1;

  std::uint64_t item_count() const { return items_.size() / system::item_bytes; }

  void run(const wire::SetRequest& request) {
    state_ = wire::SetState::closed;
    next_ = 0;
    open_ = true;
    response_ = {};
    const std::uint64_t start = cycle_;
    progress_ = cycle_;
    // Every pair may have to be fetched again, and all traffic may stand still for a while.
    const std::uint64_t limit = settings_.hang_cycles + 4 * item_count() * item_count();
    while (open_ && !stopped_) {
      if (request.reset_after != 0 && cycle_ - start >= request.reset_after) return interrupt();
      step();
      if (cycle_ - progress_ > limit) hang();
    }
    for (int k = 0; k < quiet_cycles && !stopped_; ++k) step();
  }

  void interrupt() {
    reset();
    open_ = false;
    state_ = wire::SetState::interrupted;
  }

  void step() {
    drive();
    settle();
    if (busy_) ++observed_busy_;
    sample_reports();
    sample_items();
    rise();
  }

  void drive() {
    if (!offering_ && next_ < item_count()) offering_ = traffic_.willing(item_stream, cycle_);
    ports_.s_axis_tvalid.set_bit(0, offering_);
    if (offering_) {
      std::memcpy(ports_.s_axis_tdata.bytes(0), items_.data() + next_ * system::item_bytes,
                  system::item_bytes);
      ports_.s_axis_tlast.set_bit(0, next_ + 1 == item_count());
    }
    ready_ = traffic_.willing(report_stream, cycle_);
    ports_.m_axis_tready.set_bit(0, ready_);
  }

  void sample_items() {
    if (!offering_ || !ports_.s_axis_tready.bit(0)) return;
    if (next_ == 0) first_cycle_ = cycle_;
    ++next_;
    offering_ = false;
    busy_ = true;
    progress_ = cycle_;
  }

  void sample_reports() {
    const bool valid = ports_.m_axis_tvalid.bit(0);
    const bool last = ports_.m_axis_tlast.bit(0);
    const std::uint64_t tdata = ports_.m_axis_tdata.field(0, 2 * index_field_bits);
    const std::uint64_t tuser = ports_.m_axis_tuser.field(0, 8);
    if (const auto fault = hold_.observe(valid, ready_, tdata, tuser << 1 | (last ? 1 : 0))) {
      violate(*fault, tdata);
    }
    if (!valid || !ready_) return;
    progress_ = cycle_;
    if (!open_) return violate(wire::Fault::after_the_end, tdata);
    if (last) return close(tdata, tuser);
    ++observed_reports_;
    reports_.push_back({cycle_, static_cast<std::uint32_t>(tdata & index_mask),
                        static_cast<std::uint32_t>(tdata >> index_field_bits), tuser});
  }

  void close(std::uint64_t tdata, std::uint64_t tuser) {
    open_ = false;
    busy_ = false;
    if (next_ != item_count()) violate(wire::Fault::closed_early, tdata);
    response_.closing_tdata = tdata;
    response_.closing_tuser = tuser;
    response_.cycles = cycle_ + 1 - first_cycle_;
  }

  void reset() {
    offering_ = busy_ = false;
    observed_reports_ = observed_busy_ = 0;
    reset_engine({&ports_.s_axis_tvalid});
  }

  void respond(Channel& channel) {
    response_.reports = reports_.size();
    response_.violations = violations_.size();
    response_.state = stopped_ ? wire::SetState::stopped : state_;
    read_counters(response_.counters,
                  {&ports_.reports, &ports_.busy_cycles, &ports_.stalled_cycles});
    response_.counters.observed[0] = observed_reports_;
    response_.counters.observed[1] = observed_busy_;
    const std::vector<wire::CounterValues> ends = lane_counters();
    channel.write(&response_, 1);
    channel.write(reports_.data(), reports_.size());
    channel.write(violations_.data(), violations_.size());
    channel.write(ends.data(), ends.size());
    reports_.clear();
    violations_.clear();
  }

  static constexpr std::uint64_t index_mask = (std::uint64_t{1} << index_field_bits) - 1;

  std::vector<std::uint8_t> items_;
  std::uint64_t next_ = 0;  ///< the item to be offered next
  bool offering_ = false;
  bool ready_ = false;
  bool open_ = false;  ///< the closing beat is still to come
  bool busy_ = false;  ///< an item was accepted and the closing beat was not
  std::uint64_t first_cycle_ = 0;
  std::uint64_t progress_ = 0;
  std::uint64_t observed_reports_ = 0;  ///< reports since reset
  std::uint64_t observed_busy_ = 0;
  std::vector<wire::ReportedPair> reports_;
  wire::SetResponse response_ = {};
  wire::SetState state_ = wire::SetState::closed;
};

}  // namespace

}  // namespace mixcmp::harness

int main(int argc, char** argv) {
  mixcmp::harness::Channel channel;
  mixcmp::harness::PairwiseSimulator simulator(argc, argv);
  simulator.serve(channel);
  return 0;
}

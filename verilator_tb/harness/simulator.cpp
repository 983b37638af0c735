// Drives one verilated system on comparisons that a host sends; see protocol.hpp. It computes
// nothing about them: the host judges the verdicts.

#include <algorithm>
#include <cstdint>
#include <deque>

#include "channel.hpp"
#include "clocked_model.hpp"
#include "counter_reader.hpp"
#include "lane_driver.hpp"
#include "refetch_memory.hpp"
#include "settings.hpp"
#include "system.hpp"

namespace mixcmp::harness {

namespace {

class Simulator {
public:
  Simulator(int count, char** words)
      : settings_(read_settings(count, words)),
        traffic_(settings_.traffic, settings_.seed),
        clocked_(settings_, count, words),
        ports_(clocked_.ports<Ports>()) {
    for (int k = 0; k < system::groups; ++k) lanes_.emplace_back(k, ports_, recorder_);
    for (int k = 0; k < system::refetch_streams; ++k) {
      memories_.emplace_back(k, ports_, recorder_);
    }
    clocked_.open_trace(settings_.trace);
    reset();
  }

  void serve(Channel& channel) {
    while (state_ == wire::State::running) {
      wire::Request request;
      channel.read(&request, 1);
      std::vector<std::uint64_t> resets(request.resets);
      channel.read(resets.data(), resets.size());
      std::vector<std::uint8_t> operands(request.comparisons * system::tdata_bytes);
      channel.read(operands.data(), operands.size());
      resets_.insert(resets_.end(), resets.begin(), resets.end());
      feed_.add(operands);
      run(request.last != 0);
      respond(channel);
    }
  }

private:
  /// Runs until the feed holds fewer comparisons than there are lanes or, after the last request,
  /// until all results have left.
  void run(bool last) {
    const auto enough = static_cast<std::size_t>(last ? 1 : system::lanes);
    while (!stopped() && feed_.size() >= enough) step();
    if (!last) return;
    while (!stopped() && (feed_.size() > 0 || is_busy())) step();
    // Long enough for a duplicate of the last result to show itself.
    for (int k = 0; !stopped() && k < 4 * system::slots; ++k) step();
    if (!stopped()) read_counters();
    if (!stopped()) state_ = wire::State::drained;
  }

  void read_counters() {
    const auto fault = counters_.read([this] { step(); });
    if (fault) recorder_.violation({*fault, 0, wire::no_position, 0, cycle_});
  }

  bool is_busy() const {
    return std::any_of(lanes_.begin(), lanes_.end(),
                       [](const LaneDriver& lane) { return lane.busy(); });
  }

  bool stopped() {
    if (recorder_.full()) state_ = wire::State::stopped;
    return state_ == wire::State::stopped;
  }

  void step() {
    if (!resets_.empty() && feed_.taken() >= resets_.front()) {
      resets_.pop_front();
      reset();
    }
    for (LaneDriver& lane : lanes_) lane.drive(feed_, traffic_, cycle_);
    for (RefetchMemory& memory : memories_) memory.drive(traffic_, cycle_);
    clocked_.settle(cycle_);
    report_unknown();
    for (LaneDriver& lane : lanes_) lane.sample(cycle_);
    for (RefetchMemory& memory : memories_) memory.sample(lanes_, cycle_);
    clocked_.rise(cycle_);
    ++cycle_;
    if (cycle_ % 1024 == 0) check_overdue();
  }

  void report_unknown() {
    for (const std::uint32_t stream : clocked_.unknown_streams()) {
      const auto lane = stream * static_cast<std::uint32_t>(system::lanes_per_group);
      recorder_.violation({wire::Fault::unknown_value, lane, wire::no_position, 0, cycle_});
    }
  }

  void reset() {
    for (LaneDriver& lane : lanes_) lane.discard(feed_);
    for (RefetchMemory& memory : memories_) memory.discard();
    feed_.sort_returned();
    ports_.aresetn.set_bit(0, false);
    for (int k = 0; k < reset_cycles; ++k) {
      clocked_.settle(cycle_);
      clocked_.rise(cycle_);
      ++cycle_;
    }
    for (LaneDriver& lane : lanes_) lane.check_silent_in_reset(cycle_);
    ports_.aresetn.set_bit(0, true);
    if (feed_.taken() == 0) first_cycle_ = cycle_;
  }

  void check_overdue() {
    bool hung = false;
    for (LaneDriver& lane : lanes_) hung |= lane.check_overdue(cycle_, settings_.hang_cycles);
    if (hung) state_ = wire::State::stopped;
  }

  void respond(Channel& channel) {
    std::vector<wire::CounterValues> ends;
    std::vector<std::uint64_t> answers;
    if (state_ == wire::State::drained) {
      for (const LaneDriver& lane : lanes_) ends.push_back(lane.counters());
      answers = counted_answers(ports_.answers);
    }
    const std::vector<wire::Result> results = recorder_.take_results();
    const std::vector<wire::Violation> violations = recorder_.take_violations();
    const std::uint64_t last_cycle = recorder_.last_result_cycle();
    const wire::Response response{results.size(), violations.size(),
                                  last_cycle < first_cycle_ ? 0 : last_cycle + 1 - first_cycle_,
                                  state_};
    channel.write(&response, 1);
    channel.write(results.data(), results.size());
    channel.write(violations.data(), violations.size());
    channel.write(ends.data(), ends.size());
    channel.write(answers.data(), answers.size());
  }

  static constexpr int reset_cycles = 2;

  Settings settings_;
  Traffic traffic_;
  ClockedModel clocked_;
  Ports ports_;
  CounterReader counters_{ports_.bus};
  Recorder recorder_;
  Feed feed_{static_cast<std::size_t>(system::tdata_bytes)};
  std::vector<LaneDriver> lanes_;
  std::vector<RefetchMemory> memories_;
  std::deque<std::uint64_t> resets_;
  std::uint64_t cycle_ = 0;
  std::uint64_t first_cycle_ = 0;
  wire::State state_ = wire::State::running;
};

}  // namespace

}  // namespace mixcmp::harness

int main(int argc, char** argv) {
  mixcmp::harness::Channel channel;
  mixcmp::harness::Simulator simulator(argc, argv);
  simulator.serve(channel);
  return 0;
}

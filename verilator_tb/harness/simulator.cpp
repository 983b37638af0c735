// Drives one verilated system on comparisons that a host sends; see protocol.hpp. It computes
// nothing about them: verdicts are the host's to judge.

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <memory>
#include <string>
#include <string_view>

#include "lane.hpp"
#include "refetch_memory.hpp"
#include "system_ports.hpp"
#include "verilated.h"

#if VM_TRACE
#include "verilated_fst_c.h"
#endif

namespace mixcmp::tb {

namespace {

struct Settings {
  Traffic::Kind traffic = Traffic::Kind::full_rate;
  std::uint64_t seed = 1;
  std::uint64_t hang_cycles = 50'000;
  std::string trace;
};

/// "name=value" words, written by the host alone.
Settings read_settings(int count, char** words) {
  Settings settings;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    const std::string name = word.substr(0, word.find('='));
    const std::string value = word.substr(word.find('=') + 1);
    if (name == "traffic" && value == "stressed") settings.traffic = Traffic::Kind::stressed;
    if (name == "seed") settings.seed = std::stoull(value);
    if (name == "hang_cycles") settings.hang_cycles = std::stoull(value);
    if (name == "trace") settings.trace = value;
  }
  return settings;
}

/// The host's end of the socket. It going away ends the simulator.
class Channel {
public:
  explicit Channel(int descriptor) : descriptor_(descriptor) {}

  template <class T>
  void read(T* items, std::size_t count) {
    transfer(reinterpret_cast<char*>(items), count * sizeof(T), ::read);
  }
  template <class T>
  void write(const T* items, std::size_t count) {
    transfer(reinterpret_cast<const char*>(items), count * sizeof(T), ::write);
  }

private:
  template <class Bytes, class Call>
  void transfer(Bytes* bytes, std::size_t size, Call call) {
    while (size > 0) {
      const ssize_t done = call(descriptor_, bytes, size);
      if (done <= 0) std::exit(EXIT_FAILURE);
      bytes += done;
      size -= static_cast<std::size_t>(done);
    }
  }

  int descriptor_;
};

class Simulator {
public:
  Simulator(int count, char** words)
      : settings_(read_settings(count, words)), traffic_(settings_.traffic, settings_.seed) {
    context_.commandArgs(count, words);
    context_.randReset(2);
    context_.randSeed(static_cast<int>(settings_.seed % 0x7fffffff + 1));
    model_ = std::make_unique<system::Model>(&context_);
    ports_ = system::bind(*model_);
    for (int k = 0; k < system::lanes; ++k) lanes_.emplace_back(k, ports_, recorder_);
    for (int k = 0; k < (system::refetched ? system::references : 0); ++k) {
      memories_.emplace_back(k, ports_, recorder_);
    }
    open_trace();
    reset();
  }

  ~Simulator() {
    model_->final();
#if VM_TRACE
    if (trace_) trace_->close();
#endif
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
  /// Until the feed would run dry or, after the last request, until all has left.
  void run(bool last) {
    const std::size_t enough = last ? 1 : system::lanes;
    while (!stopped() && feed_.size() >= enough) step();
    if (!last) return;
    while (!stopped() && (feed_.size() > 0 || is_busy())) step();
    // Long enough for a double of the last result to show itself.
    for (int k = 0; !stopped() && k < 4 * system::slots; ++k) step();
    if (!stopped()) state_ = wire::State::drained;
  }

  bool is_busy() const {
    return std::any_of(lanes_.begin(), lanes_.end(), [](const Lane& lane) { return lane.busy(); });
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
    for (Lane& lane : lanes_) lane.drive(feed_, traffic_, cycle_);
    for (RefetchMemory& memory : memories_) memory.drive(traffic_, cycle_);
    set_clock(false);
    for (Lane& lane : lanes_) lane.sample(cycle_);
    for (RefetchMemory& memory : memories_) memory.sample(lanes_, cycle_);
    set_clock(true);
    ++cycle_;
    if (cycle_ % 1024 == 0) check_overdue();
  }

  void reset() {
    for (Lane& lane : lanes_) lane.discard(feed_);
    for (RefetchMemory& memory : memories_) memory.discard();
    feed_.sort_returned();
    ports_.aresetn.set_bit(0, false);
    for (int k = 0; k < reset_cycles; ++k) {
      set_clock(false);
      set_clock(true);
      ++cycle_;
    }
    for (Lane& lane : lanes_) lane.check_silent_in_reset(cycle_);
    ports_.aresetn.set_bit(0, true);
    if (feed_.taken() == 0) first_cycle_ = cycle_;
  }

  void check_overdue() {
    bool hung = false;
    for (Lane& lane : lanes_) hung |= lane.check_overdue(cycle_, settings_.hang_cycles);
    if (hung) state_ = wire::State::stopped;
  }

  void respond(Channel& channel) {
    std::vector<wire::LaneEnd> ends;
    if (state_ == wire::State::drained) {
      for (const Lane& lane : lanes_) ends.push_back(lane.end());
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
  }

  /// Inputs have changed while the clock was high; outputs are to be read while it is low.
  void set_clock(bool high) {
    ports_.aclk.set_bit(0, high);
    model_->eval();
#if VM_TRACE
    if (trace_) trace_->dump(2 * cycle_ + (high ? 1 : 0));
#endif
  }

  void open_trace() {
#if VM_TRACE
    if (settings_.trace.empty()) return;
    context_.traceEverOn(true);
    model_->eval();  // hierarchical blocks are made in it, and trace() needs them
    trace_ = std::make_unique<VerilatedFstC>();
    model_->trace(trace_.get(), 99);
    trace_->open(settings_.trace.c_str());
#endif
  }

  static constexpr int reset_cycles = 2;

  Settings settings_;
  Traffic traffic_;
  VerilatedContext context_;
  std::unique_ptr<system::Model> model_;
#if VM_TRACE
  std::unique_ptr<VerilatedFstC> trace_;
#endif
  Ports ports_;
  Recorder recorder_;
  Feed feed_{system::tdata_bytes};
  std::vector<Lane> lanes_;
  std::vector<RefetchMemory> memories_;
  std::deque<std::uint64_t> resets_;
  std::uint64_t cycle_ = 0;
  std::uint64_t first_cycle_ = 0;
  wire::State state_ = wire::State::running;
};

}  // namespace

}  // namespace mixcmp::tb

int main(int argc, char** argv) {
  // What the model may print must not mix with the answers.
  mixcmp::tb::Channel channel(dup(STDIN_FILENO));
  dup2(STDERR_FILENO, STDOUT_FILENO);
  mixcmp::tb::Simulator simulator(argc, argv);
  simulator.serve(channel);
  return 0;
}

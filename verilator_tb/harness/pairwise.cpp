// Drives one verilated pairwise engine on sets of items that a host sends; see
// pairwise_protocol.hpp. It computes nothing about them: the host judges which pairs must be
// reported.

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

class PairwiseSimulator : EngineSimulator<PairwisePorts> {
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
  /// Cycles simulated after a set, so that a report behind its closing beats shows itself.
  static int quiet_cycles() { return 64 + 4 * system::lanes; }
  /// Stream numbers for Traffic; those of reports follow each other.
  static constexpr std::uint64_t item_stream = 0;
  static constexpr std::uint64_t report_stream = 1;

  /// One stream of reports.
  struct Stream {
    bool ready = false;
    bool open = false;  ///< the closing beat of this set is still to come
    wire::StreamEnd end = {};
  };

  std::uint64_t item_count() const { return items_.size() / system::item_bytes; }

  void run(const wire::SetRequest& request) {
    state_ = wire::SetState::closed;
    next_ = 0;
    targets_ = request.targets;
    open_ = true;
    response_ = {};
    for (Stream& stream : streams_) {
      stream.open = true;
      stream.end.closing_tdata = stream.end.closing_tuser = stream.end.beats = 0;
    }
    const std::uint64_t start = cycle_;
    progress_ = cycle_;
    // Every pair may have to be fetched again, and all traffic may stand still for a while.
    const std::uint64_t limit = settings_.hang_cycles + 4 * item_count() * item_count();
    while (open_ && !stopped_) {
      if (request.reset_after != 0 && cycle_ - start >= request.reset_after) return interrupt();
      step();
      if (cycle_ - progress_ > limit) hang();
    }
    for (int k = 0; k < quiet_cycles() && !stopped_; ++k) step();
    if (!stopped_) fetch_counters([this] { step(); });
  }

  void interrupt() {
    reset();
    open_ = false;
    state_ = wire::SetState::interrupted;
  }

  void step() {
    drive();
    settle();
    if (busy_) ++response_.counters.observed[1];
    for (std::size_t s = 0; s < streams_.size(); ++s) sample_report(s);
    sample_items();
    if (open_ && busy_ && all_closed()) end_set();
    rise();
  }

  void drive() {
    if (!offering_ && next_ < item_count()) offering_ = traffic_.willing(item_stream, cycle_);
    ports_.s_axis_tvalid.set_bit(0, offering_);
    if (offering_) {
      std::memcpy(ports_.s_axis_tdata.bytes(0), items_.data() + next_ * system::item_bytes,
                  system::item_bytes);
      ports_.s_axis_tuser.set_bit(0, next_ < targets_);
      ports_.s_axis_tlast.set_bit(0, next_ + 1 == item_count());
    }
    for (std::size_t s = 0; s < streams_.size(); ++s) {
      streams_[s].ready = traffic_.willing(report_stream + s, cycle_);
      ports_.m_axis_tready.set_bit(s, streams_[s].ready);
    }
  }

  void sample_items() {
    if (!offering_ || !ports_.s_axis_tready.bit(0)) return;
    if (next_ == 0) first_cycle_ = cycle_;
    ++next_;
    offering_ = false;
    busy_ = true;
    progress_ = cycle_;
  }

  /// Where stream `s` has its fields.
  static std::size_t low_bit(std::size_t s) { return s * 8 * system::report_bytes; }

  std::uint64_t flags_of(std::size_t s) const {
    if (system::flag_bits == 0) return 1;
    return ports_.m_axis_tdata.field(low_bit(s) + 2 * index_field_bits,
                                     8 * system::report_bytes - 2 * index_field_bits);
  }

  void sample_report(std::size_t s) {
    Stream& stream = streams_[s];
    const bool valid = ports_.m_axis_tvalid.bit(s);
    const bool last = ports_.m_axis_tlast.bit(s);
    const std::uint64_t tags = ports_.m_axis_tdata.field(low_bit(s), 2 * index_field_bits);
    const std::uint64_t flags = flags_of(s);
    const std::uint64_t tuser = ports_.m_axis_tuser.field(8 * s, 8);
    const std::uint64_t data = tags | tuser << 32 | (last ? std::uint64_t{1} << 40 : 0);
    if (const auto fault = hold_[s].observe(valid, stream.ready, data, flags)) {
      violate(*fault, tags);
    }
    if (!valid || !stream.ready) return;
    progress_ = cycle_;
    if (!stream.open) return violate(wire::Fault::after_the_end, tags);
    if (last) return close(stream, tags, tuser);
    ++stream.end.beats;
    ++stream.end.observed_beats;
    const auto i = static_cast<std::uint32_t>(tags & index_mask_);
    const auto j = static_cast<std::uint32_t>(tags >> index_field_bits);
    for (std::uint32_t k = 0; k < 64 && flags >> k != 0; ++k) {
      if ((flags >> k & 1) != 0) reports_.push_back({cycle_, i + k, j, tuser});
    }
  }

  void close(Stream& stream, std::uint64_t tdata, std::uint64_t tuser) {
    stream.open = false;
    if (next_ != item_count()) violate(wire::Fault::closed_early, tdata);
    stream.end.closing_tdata = tdata;
    stream.end.closing_tuser = tuser;
  }

  bool all_closed() const {
    return std::none_of(streams_.begin(), streams_.end(),
                        [](const Stream& stream) { return stream.open; });
  }

  void end_set() {
    open_ = busy_ = false;
    response_.cycles = cycle_ + 1 - first_cycle_;
    busy_before_ += response_.counters.observed[1];
  }

  void reset() {
    offering_ = busy_ = false;
    busy_before_ = 0;
    for (Stream& stream : streams_) stream.end.observed_beats = 0;
    reset_engine({&ports_.s_axis_tvalid});
  }

  void respond(Channel& channel) {
    response_.reports = reports_.size();
    response_.violations = violations_.size();
    response_.state = stopped_ ? wire::SetState::stopped : state_;
    read_counters(response_.counters,
                  {&ports_.recomputations, &ports_.busy_cycles, &ports_.stalled_cycles});
    response_.counters.observed[1] = busy_before_;
    channel.write(&response_, 1);
    channel.write(reports_.data(), reports_.size());
    channel.write(violations_.data(), violations_.size());
    for (std::size_t s = 0; s < streams_.size(); ++s) {
      wire::StreamEnd& end = streams_[s].end;
      if (system::counter_bits > 0) {
        end.counted_beats = ports_.reports.field(s * system::counter_bits, system::counter_bits);
      }
      channel.write(&end, 1);
    }
    const std::vector<std::uint64_t> answers = counted_answers(ports_.answers);
    channel.write(answers.data(), answers.size());
    reports_.clear();
    violations_.clear();
  }

  const std::uint64_t index_mask_ = (std::uint64_t{1} << index_field_bits) - 1;

  std::vector<std::uint8_t> items_;
  std::uint64_t next_ = 0;     ///< the item that is offered next
  std::uint64_t targets_ = 0;  ///< the first items, with tuser
  bool offering_ = false;
  bool open_ = false;  ///< a closing beat is still to come
  bool busy_ = false;  ///< an item was accepted and the last closing beat was not
  std::vector<Stream> streams_ = std::vector<Stream>(system::output_streams);
  std::uint64_t first_cycle_ = 0;
  std::uint64_t progress_ = 0;
  std::uint64_t busy_before_ = 0;  ///< busy cycles of the sets since reset
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

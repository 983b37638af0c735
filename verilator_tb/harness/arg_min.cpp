// Drives one verilated arg-min engine on candidates and rows that a host sends; see
// arg_min_protocol.hpp. It computes nothing about them: the host judges which candidate is the
// least. The harness judges that rows leave in order, each with its tag and tlast.

#include <cstdint>
#include <cstring>
#include <deque>
#include <vector>

#include "arg_min_protocol.hpp"
#include "channel.hpp"
#include "engine_simulator.hpp"

namespace mixcmp::harness {

namespace {

class ArgMinSimulator : EngineSimulator<ArgMinPorts> {
public:
  ArgMinSimulator(int count, char** words) : EngineSimulator(count, words) { reset(); }

  void serve(Channel& channel) {
    for (bool last = false; !last && !stopped_;) {
      channel.read(&request_, 1);
      candidates_.resize(request_.candidates * system::item_bytes);
      channel.read(candidates_.data(), candidates_.size());
      rows_.resize(request_.rows * system::row_bytes);
      channel.read(rows_.data(), rows_.size());
      run();
      respond(channel);
      last = request_.last != 0;
    }
  }

private:
  /// Cycles simulated after a load's last row, so that a surplus row shows itself.
  static constexpr int quiet_cycles = 64;
  /// Stream numbers for Traffic.
  static constexpr std::uint64_t candidate_stream = 0;
  static constexpr std::uint64_t row_stream = 1;
  static constexpr std::uint64_t result_stream = 2;

  struct Inside {
    std::uint64_t tag;
    bool last;
    std::uint64_t cycle;
  };

  void run() {
    state_ = wire::LoadState::complete;
    response_ = {};
    next_candidate_ = next_row_ = 0;
    reload_ = request_.reload_after;
    const std::uint64_t start = cycle_;
    progress_ = cycle_;
    while (next_candidate_ < request_.candidates || next_row_ < request_.rows || !inside_.empty()) {
      if (request_.reset_after != 0 && cycle_ - start >= request_.reset_after) {
        reset();
        state_ = wire::LoadState::interrupted;
        return;
      }
      step();
      if (cycle_ - progress_ > settings_.hang_cycles) hang();
      if (stopped_) return;
    }
    response_.overrun = ports_.overrun.bit(0) ? 1 : 0;
    for (int k = 0; k < quiet_cycles && !stopped_; ++k) step();
    if (!stopped_) fetch_counters([this] { step(); });
  }

  void step() {
    drive();
    settle();
    // Results come first: a row that leaves in this cycle came in before it.
    sample_results();
    sample_candidates();
    sample_rows();
    rise();
  }

  static std::uint64_t random_bits(std::uint64_t number) {
    number *= 0x9e3779b97f4a7c15u;
    return number ^ number >> 29;
  }

  void drive() {
    if (!loading_ && next_candidate_ < request_.candidates) {
      loading_ = traffic_.willing(candidate_stream, cycle_);
    }
    ports_.s_candidate_tvalid.set_bit(0, loading_);
    if (loading_) {
      std::memcpy(ports_.s_candidate_tdata.bytes(0),
                  candidates_.data() + next_candidate_ * system::item_bytes, system::item_bytes);
      ports_.s_candidate_tlast.set_bit(0, next_candidate_ + 1 == request_.candidates);
    }
    const bool loaded = next_candidate_ == request_.candidates;
    if (!offering_ && loaded && next_row_ < request_.rows) {
      offering_ = traffic_.willing(row_stream, cycle_);
    }
    ports_.s_axis_tvalid.set_bit(0, offering_);
    if (offering_) {
      std::memcpy(ports_.s_axis_tdata.bytes(0), rows_.data() + next_row_ * system::row_bytes,
                  system::row_bytes);
      const std::uint64_t bits = random_bits(accepted_ + 1);
      ports_.s_axis_tuser.set_field(0, system::tag_bits, bits & tag_mask_);
      ports_.s_axis_tlast.set_bit(0, bits >> 63 != 0);
    }
    ready_ = traffic_.willing(result_stream, cycle_);
    ports_.m_axis_tready.set_bit(0, ready_);
  }

  void sample_candidates() {
    if (!loading_ || !ports_.s_candidate_tready.bit(0)) return;
    // It is not defined with which candidates a row inside would be compared.
    if (!inside_.empty()) violate(wire::Fault::loaded_among_rows, next_candidate_);
    if (next_row_ == 0 && next_candidate_ == 0) load_cycle_ = cycle_;
    ++next_candidate_;
    loading_ = false;
    progress_ = cycle_;
  }

  void sample_rows() {
    if (!offering_) return;
    if (!ports_.s_axis_tready.bit(0)) return;
    const std::uint64_t bits = random_bits(accepted_ + 1);
    inside_.push_back({bits & tag_mask_, bits >> 63 != 0, cycle_});
    if (next_row_ == 0) {
      first_cycle_ = cycle_;
      response_.loading_cycles = cycle_ - load_cycle_;
    }
    ++next_row_;
    ++accepted_;
    offering_ = false;
    progress_ = cycle_;
    if (reload_ == 0 || next_row_ != reload_) return;
    next_candidate_ = 0;
    reload_ = 0;
  }

  void sample_results() {
    const bool valid = ports_.m_axis_tvalid.bit(0);
    const std::uint64_t index = ports_.m_axis_tdata.field(0, index_field_bits);
    const std::uint64_t tag = ports_.m_axis_tuser.field(0, system::tag_bits);
    const bool last = ports_.m_axis_tlast.bit(0);
    if (const auto fault = hold_[0].observe(valid, ready_, index << 1 | (last ? 1 : 0), tag)) {
      violate(*fault, tag);
    }
    if (!valid || !ready_) return;
    progress_ = cycle_;
    if (inside_.empty()) return violate(wire::Fault::unknown_tag, tag);
    const Inside row = inside_.front();
    inside_.pop_front();
    if (row.tag != tag || row.last != last) violate(wire::Fault::order_broken, tag);
    results_.push_back({index, row.cycle, cycle_});
    ++observed_rows_;
    response_.cycles = cycle_ + 1 - first_cycle_;
  }

  void reset() {
    loading_ = offering_ = false;
    observed_rows_ = 0;
    inside_.clear();
    reset_engine({&ports_.s_candidate_tvalid, &ports_.s_axis_tvalid});
  }

  std::vector<wire::CounterValues> lane_counters() const {
    std::vector<wire::CounterValues> ends(system::lanes);
    if (system::counter_bits == 0) return ends;
    const Port* const counters[] = {&ports_.comparisons, &ports_.recomputations, &ports_.stalls};
    for (std::size_t lane = 0; lane < ends.size(); ++lane) {
      for (int k = 0; k < 3; ++k) {
        ends[lane].counted[k] =
            counters[k]->field(lane * system::counter_bits, system::counter_bits);
      }
    }
    return ends;
  }

  void respond(Channel& channel) {
    response_.rows = results_.size();
    response_.violations = violations_.size();
    response_.state = stopped_ ? wire::LoadState::stopped : state_;
    read_counters(response_.counters, {&ports_.rows, &ports_.stalled_cycles});
    response_.counters.observed[0] = observed_rows_;
    const std::vector<wire::CounterValues> ends = lane_counters();
    channel.write(&response_, 1);
    channel.write(results_.data(), results_.size());
    channel.write(violations_.data(), violations_.size());
    channel.write(ends.data(), ends.size());
    const std::vector<std::uint64_t> answers = counted_answers(ports_.answers);
    channel.write(answers.data(), answers.size());
    results_.clear();
    violations_.clear();
  }

  const std::uint64_t tag_mask_ =
      system::tag_bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << system::tag_bits % 64) - 1;

  wire::LoadRequest request_ = {};
  std::vector<std::uint8_t> candidates_;
  std::vector<std::uint8_t> rows_;
  std::uint64_t next_candidate_ = 0;  ///< the candidate that is offered next
  std::uint64_t next_row_ = 0;
  std::uint64_t reload_ = 0;  ///< the request's reload_after, until it is done
  bool loading_ = false;      ///< a candidate is on offer
  bool offering_ = false;     ///< a row is on offer
  bool ready_ = false;
  std::deque<Inside> inside_;
  std::uint64_t accepted_ = 0;  ///< rows accepted in the whole run; tags follow from it
  std::uint64_t load_cycle_ = 0;
  std::uint64_t first_cycle_ = 0;
  std::uint64_t progress_ = 0;
  std::uint64_t observed_rows_ = 0;  ///< rows that left since reset
  std::vector<wire::RowResult> results_;
  wire::LoadResponse response_ = {};
  wire::LoadState state_ = wire::LoadState::complete;
};

}  // namespace

}  // namespace mixcmp::harness

int main(int argc, char** argv) {
  mixcmp::harness::Channel channel;
  mixcmp::harness::ArgMinSimulator simulator(argc, argv);
  simulator.serve(channel);
  return 0;
}

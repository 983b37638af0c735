#include "tests/rtl_templates/engine/arg_min_run.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "tests/rtl_templates/engine/mix.hpp"

namespace mixcmp::test {
namespace {

enum Verdict : std::uint32_t { less, equal, greater, unordered };

constexpr std::uint32_t nan_cost = ~0u;

/// A word encodes its operand in other bits, so that confusing a word with an operand is noticed.
class Words {
public:
  constexpr Words(int bits, int word_bits, std::uint32_t factor)
      : mask_((1u << bits) - 1), top_(word_bits - bits), factor_(factor), inverse_(1) {
    for (int k = 0; k < 5; ++k) inverse_ *= 2 - factor_ * inverse_;
  }
  constexpr std::uint32_t word_of(std::uint32_t full) const {
    return (full * factor_ & mask_) << top_ | (full & 1);
  }
  constexpr std::uint32_t full_of(std::uint32_t word) const {
    return (word >> top_) * inverse_ & mask_;
  }

private:
  std::uint32_t mask_;
  int top_;
  std::uint32_t factor_, inverse_;
};

constexpr Words candidate_words(ArgMinRun::candidate_bits, ArgMinRun::word_bits, 0x9e3779b1u);
constexpr Words row_words(ArgMinRun::row_bits, ArgMinRun::row_word_bits, 0x85ebca6bu);
static_assert(row_words.full_of(row_words.word_of(4711)) == 4711);

/// The traffic of an engine without references, whose lanes decide all pairs.
ArgMinTraffic without_undecided(ArgMinTraffic traffic) {
  traffic.undecided = 0;
  return traffic;
}

}  // namespace

ArgMinRun::ArgMinRun(const ArgMinSpec& spec, std::uint64_t seed, ArgMinTraffic traffic)
    : spec_(spec),
      traffic_(spec.references > 0 ? traffic : without_undecided(traffic)),
      dut_(spec.make()),
      random_(seed),
      lanes_(spec.candidates - 1),
      references_(static_cast<std::size_t>(spec.references)),
      chosen_(spec.candidates) {
  reset();
  resets_ = 0;
}

void ArgMinRun::fail(const std::string& what) {
  if (failed()) return;
  failure_ = fmt::format("{}: {} (cycle {}, {} of {} candidates, {} rows to come)", spec_.name,
                         what, cycles_, loaded_, candidates_.size(), rows_left_);
}

void ArgMinRun::edge() {
  dut_->aclk.set_bit(0, true);
  dut_->eval();
  dut_->aclk.set_bit(0, false);
  dut_->eval();
}

void ArgMinRun::reset() {
  for (harness::Port* port :
       {&dut_->s_candidate_tvalid, &dut_->s_axis_tvalid, &dut_->m_axis_tready, &dut_->aclk}) {
    port->set_bit(0, false);
  }
  for (std::size_t k = 0; k < lanes_.size(); ++k) {
    dut_->pair_tready.set_bit(k, false);
    dut_->result_tvalid.set_bit(k, false);
    lanes_[k] = {};
  }
  for (std::size_t r = 0; r < references_.size(); ++r) {
    dut_->refetch_tvalid.set_bit(r, false);
    dut_->refetched_tready.set_bit(r, false);
    references_[r] = {};
  }
  dut_->aresetn.set_bit(0, false);
  dut_->eval();
  edge();
  dut_->aresetn.set_bit(0, true);
  dut_->eval();
  expected_.clear();
  held_.clear();
  loading_ = was_loading_ = offering_ = held_result_ = false;
  counted_ = stalled_ = rows_taken_ = 0;
  ++resets_;
}

/// There are few different costs, so that many are alike.
std::uint32_t ArgMinRun::cost(std::uint32_t row, std::uint32_t candidate) const {
  const std::uint32_t bits = mix(row, candidate);
  if ((bits >> 8) % 1024 < traffic_.nan * 1024) return nan_cost;
  return bits % 8;
}

std::uint32_t ArgMinRun::verdict(std::uint32_t row, std::uint32_t best, std::uint32_t own) const {
  const std::uint32_t f = cost(row, best), g = cost(row, own);
  if (f == nan_cost || g == nan_cost) return unordered;
  return f < g ? less : f == g ? equal : greater;
}

std::uint32_t ArgMinRun::least(std::uint32_t row) {
  std::uint32_t best = 0;
  const auto count = std::min<std::size_t>(held_.size(), spec_.candidates);
  for (std::uint32_t j = 1; j < count; ++j) {
    const std::uint32_t found = verdict(row, held_[best], held_[j]);
    if (found == greater) best = j;
    if (found == equal) ++ties_;
    if (found == unordered) ++incomparable_;
  }
  return best;
}

void ArgMinRun::start_load() {
  for (std::uint32_t& candidate : candidates_) candidate = random_.word() >> (32 - candidate_bits);
  loaded_ = 0;
}

void ArgMinRun::run_load(std::uint32_t candidates, std::uint32_t rows) {
  candidates_.assign(candidates, 0);
  start_load();
  rows_left_ = rows;
  may_reset_ = true;
  for (int limit = 400'000; !failed() && (loaded_ < candidates_.size() || rows_left_ > 0);) {
    if (--limit == 0) return fail("it stands still");
    if (may_reset_ && random_.chance(traffic_.reset)) {
      reset();
      start_load();
      rows_left_ = rows;
      may_reset_ = false;
    }
    cycle();
  }
}

void ArgMinRun::drain() {
  for (int limit = 400'000; !failed() && !expected_.empty(); --limit) {
    if (limit == 0) return fail("rows stay inside");
    cycle();
  }
  for (int k = 0; k < 200 && !failed(); ++k) cycle();
}

void ArgMinRun::check_counters() {
  const std::uint64_t counted = dut_->rows.field(0, 32);
  if (counted != counted_) fail(fmt::format("{} rows counted, {} seen", counted, counted_));
  if (stalled_cycles() != stalled_) {
    fail(fmt::format("{} stalled cycles counted, {} seen", stalled_cycles(), stalled_));
  }
}

void ArgMinRun::cycle() {
  drive();
  convert();
  dut_->eval();
  const bool loading = loading_;
  // Results are taken first: a row or candidate that leaves entered before this cycle.
  take_result();
  take_candidate();
  take_row();
  for (std::size_t r = 0; r < references_.size(); ++r) {
    recompute(r);
    ask(r);
  }
  for (std::size_t k = 0; k < lanes_.size(); ++k) {
    give_result(k);
    take_pair(k);
  }
  edge();
  was_loading_ = loading;
  ++cycles_;
}

void ArgMinRun::drive_streams() {
  if (!loading_ && loaded_ < candidates_.size()) loading_ = random_.chance(traffic_.load);
  dut_->s_candidate_tvalid.set_bit(0, loading_);
  dut_->s_candidate_tdata.set_field(0, candidate_bits,
                                    loading_ ? candidates_[loaded_] : random_.word() >> 11);
  dut_->s_candidate_tlast.set_bit(
      0, loading_ ? loaded_ + 1 == candidates_.size() : random_.chance(0.5));
  const bool may_offer = traffic_.impatient || loaded_ == candidates_.size();
  if (!offering_ && rows_left_ > 0 && may_offer && random_.chance(traffic_.offer)) {
    offering_ = true;
    row_ = random_.word() >> (32 - row_bits);
    tag_ = random_.word() >> (32 - tag_bits);
    row_last_ = random_.chance(0.3);
  }
  dut_->s_axis_tvalid.set_bit(0, offering_);
  dut_->s_axis_tdata.set_field(0, row_bits, offering_ ? row_ : random_.word() >> 19);
  dut_->s_axis_tuser.set_field(0, tag_bits, offering_ ? tag_ : random_.word() >> 23);
  dut_->s_axis_tlast.set_bit(0, offering_ ? row_last_ : random_.chance(0.5));
}

/// Hands the engine the words of the operands that were there `word_latency` cycles before.
void ArgMinRun::convert() {
  const auto latency = static_cast<std::size_t>(spec_.word_latency);
  const auto convert_one = [&](std::deque<std::uint32_t>& inside, std::uint32_t full) {
    inside.push_front(full);
    inside.resize(latency + 1);
    return inside.back();
  };
  dut_->eval();
  const auto candidate = static_cast<std::uint32_t>(dut_->candidate.field(0, candidate_bits));
  const auto row = static_cast<std::uint32_t>(dut_->s_axis_tdata.field(0, row_bits));
  dut_->candidate_word.set_field(
      0, word_bits, candidate_words.word_of(convert_one(converting_candidates_, candidate)));
  dut_->row_word.set_field(0, row_word_bits, row_words.word_of(convert_one(converting_rows_, row)));
}

/// The oldest pair of a lane that still waits for its reference.
ArgMinRun::Pair* ArgMinRun::undecided_pair(std::size_t lane) {
  std::deque<Pair>& inside = lanes_[lane].inside;
  const auto found =
      std::find_if(inside.begin(), inside.end(), [](const Pair& pair) { return pair.undecided; });
  return found == inside.end() ? nullptr : &*found;
}

void ArgMinRun::drive() {
  drive_streams();
  for (std::size_t r = 0; r < references_.size(); ++r) {
    const Reference& reference = references_[r];
    const bool asks = !reference.asking.empty();
    std::uint64_t tag = random_.word();
    if (asks) {
      const std::size_t lane = reference.asking.front();
      // The reference has already asked for this many of the lane's pairs.
      auto before = std::count(reference.waiting.begin(), reference.waiting.end(), lane);
      for (const Pair& pair : lanes_[lane].inside) {
        if (!pair.undecided || before-- > 0) continue;
        tag = pair.tag;
        break;
      }
    }
    dut_->refetch_tvalid.set_bit(r, asks);
    dut_->refetch_tdata.set_field(r * name_bits(), name_bits(),
                                  tag & ((std::uint64_t{1} << name_bits()) - 1));
    dut_->refetched_tready.set_bit(r, random_.chance(traffic_.recompute));
  }
  dut_->m_axis_tready.set_bit(0,
                              (held_result_ || !traffic_.wary) && random_.chance(traffic_.accept));
  for (std::size_t k = 0; k < lanes_.size(); ++k) {
    Lane& lane = lanes_[k];
    dut_->pair_tready.set_bit(k, lane.inside.size() < slots && random_.chance(traffic_.take));
    if (!lane.giving) {
      lane.giving = !lane.inside.empty() && !lane.inside.front().undecided &&
                    lane.inside.front().due <= cycles_ && random_.chance(traffic_.give);
    }
    dut_->result_tvalid.set_bit(k, lane.giving);
    std::uint32_t answer = random_.below(4);
    std::uint64_t tag = random_.word();
    if (lane.giving) {
      const Pair& pair = lane.inside.front();
      answer = verdict(pair.row, pair.best, pair.own);
      tag = pair.tag;
    }
    dut_->result_tdata.set_field(8 * k, 8, answer | random_.below(2) << 2);
    const int pair_bits = row_word_bits + name_bits();
    dut_->result_tag.set_field(k * pair_bits, pair_bits, tag);
  }
}

void ArgMinRun::take_candidate() {
  if (!loading_ || !dut_->s_candidate_tready.bit(0)) return;
  if (!expected_.empty()) fail("a candidate was taken while rows are inside");
  ++loaded_;
  loading_ = false;
  loaded_at_ = cycles_;
  rows_taken_ = 0;
  held_.clear();
  if (loaded_ == candidates_.size()) held_ = candidates_;
}

void ArgMinRun::take_row() {
  if (!offering_) return;
  if (!dut_->s_axis_tready.bit(0)) {
    // The first row of a load finds the chain empty: it waits for no room.
    if (rows_taken_ > 0 && !was_loading_) ++stalled_;
    return;
  }
  if (held_.empty() || loaded_at_ == cycles_) return fail("a row was taken without candidates");
  if (was_loading_) fail("a row was taken while a load is on offer");
  const bool too_many = held_.size() > spec_.candidates;
  if (dut_->overrun.bit(0) != too_many) fail("overrun is wrong");
  expected_.push_back({least(row_), tag_, row_last_, cycles_});
  offering_ = false;
  --rows_left_;
  ++rows_taken_;
  if (settling_ == 0) settling_ = cycles_ - loaded_at_;
}

void ArgMinRun::take_pair(std::size_t k) {
  Lane& lane = lanes_[k];
  const bool valid = dut_->pair_tvalid.bit(k), ready = dut_->pair_tready.bit(k);
  const int pair_bits = row_word_bits + name_bits();
  const std::uint64_t tag = dut_->pair_tag.field(k * pair_bits, pair_bits);
  const auto word = [&](const harness::Port& port) {
    return static_cast<std::uint32_t>(port.field(k * word_bits, word_bits));
  };
  const std::uint32_t best = word(dut_->pair_best), own = word(dut_->pair_own);
  if (lane.held && (!valid || lane.held_pair != std::vector<std::uint64_t>{tag, best, own})) {
    fail(fmt::format("lane {} saw an offer change", k));
  }
  lane.held = valid && !ready;
  lane.held_pair = {tag, best, own};
  if (!valid || !ready) return;
  const auto row = static_cast<std::uint32_t>(tag >> name_bits());
  lane.inside.push_back({row_words.full_of(row), candidate_words.full_of(best),
                         candidate_words.full_of(own), tag,
                         cycles_ + static_cast<std::uint64_t>(traffic_.lane_latency),
                         random_.chance(traffic_.undecided)});
  if (lane.inside.back().undecided) references_[k % references_.size()].asking.push_back(k);
}

void ArgMinRun::ask(std::size_t r) {
  Reference& reference = references_[r];
  if (!dut_->refetch_tvalid.bit(r) || !dut_->refetch_tready.bit(r)) return;
  reference.waiting.push_back(reference.asking.front());
  reference.asking.pop_front();
}

/// Compares the operands that a reference gets with the operands that its pair's words encode.
void ArgMinRun::recompute(std::size_t r) {
  Reference& reference = references_[r];
  const bool valid = dut_->refetched_tvalid.bit(r), ready = dut_->refetched_tready.bit(r);
  const auto first = r * static_cast<std::size_t>(2 * candidate_bits + row_bits);
  const auto field = [&](std::size_t low, int bits) {
    return dut_->refetched_tdata.field(first + low, bits);
  };
  const std::vector<std::uint64_t> operands = {field(0, row_bits), field(row_bits, candidate_bits),
                                               field(row_bits + candidate_bits, candidate_bits)};
  if (reference.held && (!valid || operands != reference.held_operands)) {
    fail(fmt::format("reference {} saw an offer change", r));
  }
  reference.held = valid && !ready;
  reference.held_operands = operands;
  if (!valid || !ready) return;
  if (reference.waiting.empty()) return fail(fmt::format("operands of no pair, reference {}", r));
  Pair& pair = *undecided_pair(reference.waiting.front());
  reference.waiting.pop_front();
  if (operands != std::vector<std::uint64_t>{pair.row, pair.best, pair.own}) {
    fail(fmt::format("reference {} got other operands than its lane", r));
  }
  pair.undecided = false;
  ++recomputed_;
}

void ArgMinRun::give_result(std::size_t k) {
  Lane& lane = lanes_[k];
  if (!lane.giving || !dut_->result_tready.bit(k)) return;
  lane.inside.pop_front();
  lane.giving = false;
}

void ArgMinRun::take_result() {
  const bool valid = dut_->m_axis_tvalid.bit(0), ready = dut_->m_axis_tready.bit(0);
  const auto index =
      static_cast<std::uint32_t>(dut_->m_axis_tdata.field(0, (spec_.index_bits + 7) / 8 * 8));
  const auto tag = static_cast<std::uint32_t>(dut_->m_axis_tuser.field(0, tag_bits));
  const bool last = dut_->m_axis_tlast.bit(0);
  const std::uint64_t data = std::uint64_t{index} << 32 | tag << 1 | (last ? 1u : 0u);
  if (held_result_ && (!valid || data != held_data_)) fail("a result changed before it was taken");
  held_result_ = valid && !ready;
  held_data_ = data;
  if (!valid || !ready) return;
  if (expected_.empty()) return fail("a result of no row");
  const Expected due = expected_.front();
  expected_.pop_front();
  if (index != due.index || tag != due.tag || last != due.last) {
    fail(fmt::format("index {}, tag {}, tlast {} instead of {}, {}, {}", index, tag, last,
                     due.index, due.tag, due.last));
  }
  ++left_;
  ++counted_;
  ++chosen_[due.index];
  latency_ = cycles_ - due.accepted;
  interval_ = cycles_ - left_at_;
  left_at_ = cycles_;
}

}  // namespace mixcmp::test

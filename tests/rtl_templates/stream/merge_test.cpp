// Tests FIFO, arbiter and tree against one model, which has a queue per input.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <iterator>
#include <memory>
#include <ostream>
#include <vector>

#include "VArbiter1.h"
#include "VArbiter4.h"
#include "VFifo16.h"
#include "VFifo2.h"
#include "VHalfArbiter5.h"
#include "VTree29.h"
#include "VTree9.h"
#include "tests/rtl_templates/stream/random_source.hpp"

namespace mixcmp::test::merge_test {
namespace {

class MergeDut {
public:
  virtual ~MergeDut() = default;
  virtual void eval() = 0;

  CData* aclk = nullptr;
  CData* aresetn = nullptr;
  IData* s_valid = nullptr;
  IData* s_ready = nullptr;
  VlWide<32>* s_data = nullptr;
  CData* m_valid = nullptr;
  CData* m_ready = nullptr;
  IData* m_data = nullptr;
};

template <class Model>
class VerilatedMerge : public MergeDut {
public:
  VerilatedMerge() {
    context_.randReset(2);
    context_.randSeed(7);
    model_ = std::make_unique<Model>(&context_);
    aclk = &model_->aclk;
    aresetn = &model_->aresetn;
    s_valid = &model_->s_valid;
    s_ready = &model_->s_ready;
    s_data = &model_->s_data;
    m_valid = &model_->m_valid;
    m_ready = &model_->m_ready;
    m_data = &model_->m_data;
  }
  void eval() override { model_->eval(); }

private:
  VerilatedContext context_;
  std::unique_ptr<Model> model_;
};

struct MergeSpec {
  const char* name;
  std::function<std::unique_ptr<MergeDut>()> make;
  std::uint32_t inputs;
  int latency_cycles;
  int one_input_interval;   ///< cycles per word when only one input is busy
  int all_inputs_interval;  ///< cycles per word when all inputs are busy
  int capacity;             ///< words held when nothing leaves; -1: not stated
  std::uint32_t round;      ///< words in which each busy input is served at least once
};

void PrintTo(const MergeSpec& spec, std::ostream* stream) {
  *stream << spec.name;
}

template <class Model>
std::unique_ptr<MergeDut> make() {
  return std::make_unique<VerilatedMerge<Model>>();
}

const std::vector<MergeSpec> specs = {
    {"FifoOf2", make<VFifo2>, 1, 2, 1, 1, 3, 1},
    {"FifoOf16", make<VFifo16>, 1, 2, 1, 1, 17, 1},
    {"ArbiterOf1", make<VArbiter1>, 1, 1, 1, 1, 1, 1},
    {"ArbiterOf4", make<VArbiter4>, 4, 1, 1, 1, 1, 4},
    {"HalfRateArbiterOf5", make<VHalfArbiter5>, 5, 1, 2, 2, 1, 5},
    {"TreeOf29", make<VTree29>, 29, 3, 2, 1, -1, 4 * 4 * 2},
    {"TreeOf9Radix2", make<VTree9>, 9, 4, 2, 1, -1, 2 * 2 * 2 * 2},
};

struct Traffic {
  const char* name;
  double offer;   ///< chance that an idle input offers a word
  double accept;  ///< chance that the sink is ready
  double reset;   ///< chance of a reset, per cycle
};

const std::vector<Traffic> traffics = {
    {"FullSpeed", 1.0, 1.0, 0.0},       {"Gaps", 0.3, 1.0, 0.0},
    {"Backpressure", 1.0, 0.4, 0.0},    {"GapsAndBackpressure", 0.4, 0.5, 0.0},
    {"ResetMidStream", 0.7, 0.7, 0.01},
};

/// Drives one device cycle by cycle and compares its output with a queue per input. A word is
/// {input, number of the word}, so a lost, doubled, stale or misplaced word is recognised.
class MergeRun {
public:
  MergeRun(const MergeSpec& spec, std::uint64_t seed)
      : spec_(spec), dut_(spec.make()), random_(seed), inputs_(spec.inputs) {
    reset();
  }

  void reset() {
    *dut_->aresetn = 0;
    *dut_->s_valid = 0;
    *dut_->m_ready = 0;
    for (int cycle = 0; cycle < 2; ++cycle) edge();
    *dut_->aresetn = 1;
    for (Input& input : inputs_) {
      input.queue.clear();
      input.offering = false;
    }
    output_held_ = false;
    ++cycles_;
  }

  /// Runs one cycle; inputs outside `mask` stay idle.
  void cycle(const Traffic& traffic, std::uint32_t mask = ~0u) {
    if (random_.chance(traffic.reset)) return reset();
    offer(traffic, mask);
    *dut_->m_ready = random_.chance(traffic.accept);
    settle();
    check_that_valid_ignores_ready();
    check_that_output_holds();
    take_output();
    take_inputs();
    edge();
    ++cycles_;
  }

  std::size_t waiting() const {
    std::size_t words = 0;
    for (const Input& input : inputs_) words += input.queue.size();
    return words;
  }

  std::uint64_t received = 0;
  std::uint64_t accepted = 0;
  std::vector<std::uint32_t> order;  ///< the input of each word that left
  std::uint32_t longest_wait = 0;    ///< words accepted from others while one was offered

private:
  struct Input {
    bool offering = false;
    std::uint32_t word = 0;
    std::uint32_t next = 0;
    std::uint32_t waited = 0;
    std::deque<std::uint32_t> queue;
  };

  void settle() {
    *dut_->aclk = 0;
    dut_->eval();
  }
  void edge() {
    settle();
    *dut_->aclk = 1;
    dut_->eval();
  }

  void offer(const Traffic& traffic, std::uint32_t mask) {
    for (std::uint32_t i = 0; i < spec_.inputs; ++i) {
      Input& input = inputs_[i];
      if (!input.offering && ((mask >> i) & 1) && random_.chance(traffic.offer)) {
        input.offering = true;
        input.word = (i << 24) | (input.next++ & 0xffffff);
        input.waited = 0;
      }
      (*dut_->s_data)[i] = input.offering ? input.word : random_.word();
      const std::uint32_t bit = 1u << i;
      *dut_->s_valid = input.offering ? (*dut_->s_valid | bit) : (*dut_->s_valid & ~bit);
    }
  }

  void check_that_valid_ignores_ready() {
    const CData valid = *dut_->m_valid;
    const CData ready = *dut_->m_ready;
    *dut_->m_ready = !ready;
    dut_->eval();
    ASSERT_EQ(*dut_->m_valid, valid) << "valid follows ready in cycle " << cycles_;
    *dut_->m_ready = ready;
    dut_->eval();
  }

  void check_that_output_holds() {
    if (output_held_) {
      ASSERT_TRUE(*dut_->m_valid) << "valid fell before ready in cycle " << cycles_;
      ASSERT_EQ(*dut_->m_data, held_word_) << "data changed before ready in cycle " << cycles_;
    }
    output_held_ = *dut_->m_valid && !*dut_->m_ready;
    held_word_ = *dut_->m_data;
  }

  void take_output() {
    if (!*dut_->m_valid || !*dut_->m_ready) return;
    const std::uint32_t word = *dut_->m_data;
    const std::uint32_t i = word >> 24;
    ASSERT_LT(i, spec_.inputs) << std::hex << word;
    ASSERT_FALSE(inputs_[i].queue.empty()) << "nobody sent " << std::hex << word;
    ASSERT_EQ(word, inputs_[i].queue.front()) << "lost, doubled or out of order";
    inputs_[i].queue.pop_front();
    order.push_back(i);
    ++received;
  }

  void take_inputs() {
    const std::uint32_t taken = *dut_->s_valid & *dut_->s_ready;
    for (std::uint32_t i = 0; i < spec_.inputs; ++i) {
      Input& input = inputs_[i];
      if ((taken >> i) & 1) {
        input.queue.push_back(input.word);
        input.offering = false;
        ++accepted;
      } else if (input.offering && taken != 0) {
        longest_wait = std::max(longest_wait, ++input.waited);
      }
    }
  }

  const MergeSpec& spec_;
  std::unique_ptr<MergeDut> dut_;
  RandomSource random_;
  std::vector<Input> inputs_;
  bool output_held_ = false;
  std::uint32_t held_word_ = 0;
  std::uint64_t cycles_ = 0;
};

std::vector<MergeSpec> specs_with(bool (*predicate)(const MergeSpec&)) {
  std::vector<MergeSpec> chosen;
  std::copy_if(specs.begin(), specs.end(), std::back_inserter(chosen), predicate);
  return chosen;
}

bool merges_at_full_rate(const MergeSpec& spec) {
  return spec.inputs > 1 && spec.all_inputs_interval == 1;
}
bool has_capacity(const MergeSpec& spec) {
  return spec.capacity >= 0;
}
bool is_arbiter(const MergeSpec& spec) {
  return spec.inputs > 1 && spec.capacity == 1;
}

class Merge : public ::testing::TestWithParam<MergeSpec> {};
class FullRateMerge : public Merge {};
class BoundedMerge : public Merge {};

TEST_P(Merge, LosesNothingAndKeepsTheOrderOfEachInput) {
  for (const Traffic& traffic : traffics) {
    SCOPED_TRACE(traffic.name);
    MergeRun run(GetParam(), 11);
    for (int cycle = 0; cycle < 20000 && !HasFatalFailure(); ++cycle) run.cycle(traffic);
    for (int cycle = 0; cycle < 1000; ++cycle) run.cycle({"Drain", 0.0, 1.0, 0.0});
    EXPECT_EQ(run.waiting(), 0u);
    EXPECT_GT(run.received, 1000u);
  }
}

TEST_P(Merge, HasTheStatedLatency) {
  MergeRun run(GetParam(), 12);
  run.cycle({"One", 1.0, 1.0, 0.0}, 1);
  ASSERT_EQ(run.accepted, 1u);
  const Traffic drain{"Drain", 0.0, 1.0, 0.0};
  for (int cycle = 1; cycle < GetParam().latency_cycles; ++cycle) run.cycle(drain);
  EXPECT_EQ(run.received, 0u);
  run.cycle(drain);
  EXPECT_EQ(run.received, 1u);
}

TEST_P(Merge, HasTheStatedThroughput) {
  const Traffic full{"FullSpeed", 1.0, 1.0, 0.0};
  const auto words_in = [&](std::uint32_t mask, std::uint64_t cycles) {
    MergeRun run(GetParam(), 13);
    for (int cycle = 0; cycle < 200; ++cycle) run.cycle(full, mask);
    const std::uint64_t before = run.received;
    for (std::uint64_t cycle = 0; cycle < cycles; ++cycle) run.cycle(full, mask);
    return run.received - before;
  };
  EXPECT_EQ(words_in(1, 1000), 1000u / GetParam().one_input_interval);
  EXPECT_EQ(words_in(~0u, 1000), 1000u / GetParam().all_inputs_interval);
}

TEST_P(FullRateMerge, TwoDistantInputsFillTheOutput) {
  const std::uint32_t first_and_last = 1u | (1u << (GetParam().inputs - 1));
  MergeRun run(GetParam(), 14);
  const Traffic full{"FullSpeed", 1.0, 1.0, 0.0};
  for (int cycle = 0; cycle < 200; ++cycle) run.cycle(full, first_and_last);
  const std::uint64_t before = run.received;
  for (int cycle = 0; cycle < 1000; ++cycle) run.cycle(full, first_and_last);
  EXPECT_EQ(run.received - before, 1000u);
}

TEST_P(BoundedMerge, HoldsItsCapacityAndNoMore) {
  MergeRun run(GetParam(), 15);
  for (int cycle = 0; cycle < 100; ++cycle) run.cycle({"Blocked", 1.0, 0.0, 0.0});
  EXPECT_EQ(run.accepted, static_cast<std::uint64_t>(GetParam().capacity));
}

TEST_P(Merge, ServesEachBusyInputOnceInARound) {
  for (const double accept : {1.0, 0.5}) {
    MergeRun run(GetParam(), 16);
    for (int cycle = 0; cycle < 8000; ++cycle) run.cycle({"Busy", 1.0, accept, 0.0});
    std::vector<std::size_t> last(GetParam().inputs, 0);
    std::size_t longest = 0;
    const std::size_t settled = 10 * GetParam().round;
    for (std::size_t word = 0; word < run.order.size(); ++word) {
      if (word > settled) longest = std::max(longest, word - last[run.order[word]]);
      last[run.order[word]] = word;
    }
    for (const std::size_t word : last) longest = std::max(longest, run.order.size() - word);
    EXPECT_LE(longest, GetParam().round);
    EXPECT_GE(longest, GetParam().inputs);
  }
}

TEST(Arbiter, NoInputWaitsForMoreThanOneWordOfEachOther) {
  for (const MergeSpec& spec : specs_with(is_arbiter)) {
    SCOPED_TRACE(spec.name);
    MergeRun busy(spec, 17);
    for (int cycle = 0; cycle < 8000; ++cycle) busy.cycle({"Busy", 1.0, 0.6, 0.0});
    EXPECT_EQ(busy.longest_wait, spec.inputs - 1);
    MergeRun random(spec, 18);
    for (int cycle = 0; cycle < 20000; ++cycle) random.cycle({"Random", 0.5, 0.6, 0.0});
    EXPECT_LE(random.longest_wait, spec.inputs - 1);
  }
}

std::string name_of(const ::testing::TestParamInfo<MergeSpec>& info) {
  return info.param.name;
}

using ::testing::ValuesIn;
INSTANTIATE_TEST_SUITE_P(Streams, Merge, ValuesIn(specs), name_of);
INSTANTIATE_TEST_SUITE_P(Streams, FullRateMerge, ValuesIn(specs_with(merges_at_full_rate)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Streams, BoundedMerge, ValuesIn(specs_with(has_capacity)), name_of);

}  // namespace
}  // namespace mixcmp::test::merge_test

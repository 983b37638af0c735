#include "model/cost/performance/pairwise_walk.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "model/base/common/counter_random.hpp"

namespace mixcmp::performance {
namespace {

/// Words times segments of a sample, or up to twice as many: about 10 ms of simulation for segments
/// of eight lanes.
constexpr std::uint64_t most_steps = std::uint64_t{1} << 18;
/// A sample consists of windows of so many consecutive words.
constexpr std::uint64_t window = 64;

class Walker {
public:
  Walker(const PairwiseData& data, int lanes, int lanes_per_segment)
      : data_(data), lanes_(lanes), lanes_per_segment_(lanes_per_segment) {
    walk_.segments = (lanes + lanes_per_segment - 1) / lanes_per_segment;
    walk_.all_words = pairwise_word_cycles(data.set.items, data.set.others, lanes) + 1;
  }

  PairwiseWalk walk() {
    const std::uint64_t budget =
        std::max(window, most_steps / static_cast<std::uint64_t>(walk_.segments));
    const std::uint64_t every = std::max<std::uint64_t>(1, walk_.all_words / budget);
    const auto lanes = static_cast<std::uint64_t>(lanes_);
    std::uint64_t entered = 0;  // words of the set so far
    // One window of each `every`, at a place that follows no period of the blocks.
    const auto is_in_sample = [&](std::uint64_t number) {
      return number % every == counter_random(0, number / every) % every;
    };
    for (std::uint64_t base = 0; base < data_.set.items; base += lanes) {
      const std::uint64_t held = std::min(lanes, data_.set.items - base);
      const std::uint64_t words =
          data_.set.others > 0 ? held + data_.set.others : data_.set.items - base;
      for (std::uint64_t first = 0; first < words;) {
        const std::uint64_t last = std::min(words, first + window - (entered + first) % window);
        if (is_in_sample((entered + first) / window)) add(base, held, first, last);
        first = last;
      }
      entered += words;
    }
    close();
    return std::move(walk_);
  }

private:
  /// Adds the words first .. last - 1 of the block that holds the items base .. base + held - 1.
  void add(std::uint64_t base, std::uint64_t held, std::uint64_t first, std::uint64_t last) {
    const std::uint64_t row = walk_.words.size();
    const std::uint64_t items = data_.set.items;
    for (std::uint64_t offset = first; offset < last; ++offset) {
      const bool stays = offset < held;
      const std::uint64_t item = data_.set.others == 0 ? base + offset
                                 : stays               ? items
                                                       : items + offset - held;
      walk_.words.push_back(
          {.needs = item + 1, .stays = stays ? static_cast<int>(offset) / lanes_per_segment_ : -1});
    }
    counts_.resize(walk_.words.size() * segments());
    for (std::uint64_t k = 0; k < held; ++k) {
      // Item base + k meets the words behind it, or all of the second table.
      const std::uint64_t meets = data_.set.others == 0 ? k + 1 : held;
      const std::uint64_t from = std::max(first, meets);
      if (from >= last) continue;
      count_reported(row + from - first, static_cast<int>(k) / lanes_per_segment_,
                     first_pair(base + k) + from - meets, last - from);
    }
  }

  /// Adds the word that closes the set. It forms no pair and passes all segments.
  void close() {
    walk_.words.emplace_back();
    counts_.resize(walk_.words.size() * segments());
    walk_.counts.resize(counts_.size());
    // By windows of words, so that what is read stays in the nearest cache.
    const std::uint64_t words = walk_.words.size();
    for (std::uint64_t first = 0; first < words; first += window) {
      const std::uint64_t last = std::min(words, first + window);
      for (std::uint64_t s = 0; s < segments(); ++s) {
        for (std::uint64_t word = first; word < last; ++word) {
          walk_.counts[s * words + word] = counts_[word * segments() + s];
        }
      }
    }
  }

  std::uint64_t segments() const { return static_cast<std::uint64_t>(walk_.segments); }

  /// The number of the first pair of item i.
  std::uint64_t first_pair(std::uint64_t i) const {
    return data_.set.others > 0 ? i * data_.set.others : i * data_.set.items - i * (i + 1) / 2;
  }

  void count_reported(std::uint64_t row, int segment, std::uint64_t pair, std::uint64_t pairs) {
    walk_.pairs += pairs;
    if (data_.reported.empty()) return;
    for (std::uint64_t k = 0; k < pairs;) {
      const std::uint64_t bit = (pair + k) % 64;
      const std::uint64_t bits = data_.reported[(pair + k) / 64] >> bit;
      if (bits == 0) {
        k += 64 - bit;
        continue;
      }
      k += static_cast<std::uint64_t>(std::countr_zero(bits));
      if (k >= pairs) break;
      ++counts_[(row + k) * segments() + static_cast<std::uint64_t>(segment)];
      ++walk_.reported;
      ++k;
    }
  }

  const PairwiseData& data_;
  int lanes_, lanes_per_segment_;
  PairwiseWalk walk_;
  std::vector<std::uint8_t> counts_;  ///< by word and segment
};

}  // namespace

std::uint64_t PairwiseData::pairs() const {
  return set.others > 0 ? set.items * set.others : set.items * (set.items - 1) / 2;
}

double PairwiseData::reported_share() const {
  std::uint64_t count = 0;
  for (const std::uint64_t bits : reported) {
    count += static_cast<std::uint64_t>(std::popcount(bits));
  }
  return pairs() == 0 ? 0 : static_cast<double>(count) / static_cast<double>(pairs());
}

std::uint64_t PairwiseWalk::passes() const {
  std::uint64_t sum = 0;
  for (const Word& word : words) {
    sum += static_cast<std::uint64_t>(word.stays < 0 ? segments : word.stays + 1);
  }
  return sum;
}

double PairwiseWalk::part() const {
  return static_cast<double>(words.size()) / static_cast<double>(all_words);
}

PairwiseWalk walk_pairs(const PairwiseData& data, int lanes, int lanes_per_segment) {
  return Walker(data, lanes, lanes_per_segment).walk();
}

}  // namespace mixcmp::performance

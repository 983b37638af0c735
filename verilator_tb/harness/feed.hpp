#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "in_flight.hpp"

namespace mixcmp::harness {

/// The queue of comparisons for the lanes. Those that a reset has discarded come first.
class Feed {
public:
  explicit Feed(std::size_t bytes_per_comparison) : bytes_(bytes_per_comparison) {}

  void add(std::span<const std::uint8_t> operands) {
    fresh_.erase(fresh_.begin(), fresh_.begin() + static_cast<std::ptrdiff_t>(cursor_));
    cursor_ = 0;
    fresh_.insert(fresh_.end(), operands.begin(), operands.end());
  }

  std::size_t size() const { return returned_.size() + (fresh_.size() - cursor_) / bytes_; }

  /// How many comparisons were taken so far; one that is offered again counts once.
  std::uint64_t taken() const { return next_position_; }

  void take(Entry& entry) {
    if (!returned_.empty()) {
      entry.position = returned_.front().first;
      entry.operands = std::move(returned_.front().second);
      returned_.pop_front();
      return;
    }
    entry.operands.resize(bytes_);
    std::memcpy(entry.operands.data(), &fresh_[cursor_], bytes_);
    entry.position = next_position_++;
    cursor_ += bytes_;
  }

  void give_back(const Entry& entry) { returned_.emplace_back(entry.position, entry.operands); }

  /// Sorts the comparisons given back after a reset by position, whichever lanes they were in.
  void sort_returned() {
    std::sort(returned_.begin(), returned_.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
  }

private:
  std::size_t bytes_;
  std::vector<std::uint8_t> fresh_;
  std::size_t cursor_ = 0;
  std::uint64_t next_position_ = 0;
  std::deque<std::pair<std::uint64_t, std::vector<std::uint8_t>>> returned_;
};

}  // namespace mixcmp::harness

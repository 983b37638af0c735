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

  /// Takes a comparison for each of `lanes`, while there are any: at least one.
  void take(Entry& entry, std::size_t lanes) {
    entry.positions.clear();
    entry.operands.resize(lanes * bytes_);
    for (std::size_t k = 0; k < lanes; ++k) {
      std::uint8_t* const operands = &entry.operands[k * bytes_];
      if (size() > 0) {
        entry.positions.push_back(take_one(operands));
      } else {
        std::memcpy(operands, entry.operands.data(), bytes_);
      }
    }
  }

  void give_back(const Entry& entry) {
    for (std::size_t k = 0; k < entry.positions.size(); ++k) {
      const auto operands = entry.operands.begin() + static_cast<std::ptrdiff_t>(k * bytes_);
      returned_.emplace_back(entry.positions[k],
                             std::vector(operands, operands + static_cast<std::ptrdiff_t>(bytes_)));
    }
  }

  /// Sorts the comparisons given back after a reset by position, across all lanes.
  void sort_returned() {
    std::sort(returned_.begin(), returned_.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
  }

private:
  /// Takes one comparison; returns its position.
  std::uint64_t take_one(std::uint8_t* operands) {
    if (!returned_.empty()) {
      const std::uint64_t position = returned_.front().first;
      std::memcpy(operands, returned_.front().second.data(), bytes_);
      returned_.pop_front();
      return position;
    }
    std::memcpy(operands, &fresh_[cursor_], bytes_);
    cursor_ += bytes_;
    return next_position_++;
  }

  std::size_t bytes_;
  std::vector<std::uint8_t> fresh_;
  std::size_t cursor_ = 0;
  std::uint64_t next_position_ = 0;
  std::deque<std::pair<std::uint64_t, std::vector<std::uint8_t>>> returned_;
};

}  // namespace mixcmp::harness

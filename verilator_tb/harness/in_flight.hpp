#pragma once

#include <cstdint>
#include <vector>

namespace mixcmp::harness {

/// One comparison that a lane was offered, or a word of one for each lane of a group.
struct Entry {
  enum class State { unused, offered, inside, left, discarded };

  State state = State::unused;
  std::uint64_t number = 0;  ///< the running number that became the tag
  /// Positions in the run, from lane 0 on. Further lanes repeat the operands of lane 0; their
  /// results belong to no comparison.
  std::vector<std::uint64_t> positions;
  std::uint64_t sequence = 0;          ///< order of acceptance in its lane
  std::uint64_t cycle = 0;             ///< of the offer; once accepted, of the acceptance
  std::vector<std::uint8_t> operands;  ///< of every lane

  bool busy() const { return state == State::offered || state == State::inside; }
};

/// The tags of one lane, or of a group of lanes, and the comparisons that they name. Tags come from
/// a running number, multiplied by an odd constant so that every bit of a wide tag moves. A number
/// is used again only when its comparison has left, so that at most `count` are inside.
class InFlight {
public:
  /// Entries are numbered 0 .. count - 1. The tags of this lane are made of base + number, modulo
  /// 2^tag_bits. With lane_bits > 0 they are 2^lane_bits apart, so that tag + k names lane k of the
  /// group, and odd, so that this sum carries.
  InFlight(int tag_bits, int lane_bits, std::uint64_t base, std::uint64_t count,
           std::size_t ring_size)
      : mask_(low_bits(tag_bits)),
        number_mask_(low_bits(tag_bits - lane_bits)),
        lane_bits_(lane_bits),
        first_(lane_bits > 0 ? 1 : 0),
        base_(base),
        count_(count),
        ring_(ring_size) {}

  /// Returns an entry with a fresh number, or null while all entries that it tries are in use.
  Entry* allocate() {
    for (std::size_t attempt = 0; attempt < ring_.size(); ++attempt) {
      const std::uint64_t number = next_;
      next_ = next_ + 1 == count_ ? 0 : next_ + 1;
      Entry& entry = ring_[number % ring_.size()];
      if (entry.busy()) continue;
      entry.number = number;
      return &entry;
    }
    return nullptr;
  }

  std::uint64_t tag(const Entry& entry) const {
    const std::uint64_t number = (base_ + entry.number) * scramble & number_mask_;
    return ((number << lane_bits_) + first_) & mask_;
  }

  /// The entry that carries, or last carried, this tag; null if no remembered entry did.
  Entry* find(std::uint64_t tag) { return lane_of(tag) == 0 ? find_word(tag) : nullptr; }

  /// The entry with this tag in one of its lanes; null if no remembered entry has it.
  Entry* find_word(std::uint64_t tag) {
    const std::uint64_t scrambled = ((tag - first_) & mask_) >> lane_bits_;
    const std::uint64_t number = (scrambled * unscramble() - base_) & number_mask_;
    Entry& entry = ring_[number % ring_.size()];
    return entry.state != Entry::State::unused && entry.number == number ? &entry : nullptr;
  }

  /// The lane of the group that has this tag.
  std::uint64_t lane_of(std::uint64_t tag) const { return (tag - first_) & low_bits(lane_bits_); }

  std::vector<Entry>& entries() { return ring_; }

private:
  static constexpr std::uint64_t scramble = 0x9e3779b97f4a7c15u;

  /// The inverse of `scramble` modulo 2^64, by Newton's iteration: each step doubles the bits.
  static constexpr std::uint64_t unscramble() {
    std::uint64_t inverse = scramble;
    for (int step = 0; step < 5; ++step) inverse *= 2 - scramble * inverse;
    return inverse;
  }

  static constexpr std::uint64_t low_bits(int count) {
    return count >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
  }

  std::uint64_t mask_;
  std::uint64_t number_mask_;
  int lane_bits_;
  std::uint64_t first_;
  std::uint64_t base_;
  std::uint64_t count_;
  std::uint64_t next_ = 0;
  std::vector<Entry> ring_;
};

}  // namespace mixcmp::harness

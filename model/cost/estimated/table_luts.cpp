#include "model/cost/estimated/table_luts.hpp"

#include <bit>
#include <cmath>
#include <numeric>
#include <set>
#include <string>
#include <utility>

namespace mixcmp::estimated {
namespace {

constexpr std::size_t lut_entries = 64;
/// The entries that look-up tables and two levels of multiplexers choose among.
constexpr std::size_t free_entries = 4 * lut_entries;
/// Multiplexers of two above those, in look-up tables. A multiplexer of four takes one.
constexpr double luts_of_choice = 0.35;

/// A function of some bits of the address: its values at all their combinations, "0110".
struct BitFunction {
  std::vector<int> bits;  ///< of the address, the lowest first
  std::string values;

  friend auto operator<=>(const BitFunction&, const BitFunction&) = default;
};

/// The function without a bit, where that is 0 or 1.
BitFunction restricted(const BitFunction& function, std::size_t bit, std::size_t to) {
  BitFunction rest{function.bits, {}};
  rest.bits.erase(rest.bits.begin() + static_cast<std::ptrdiff_t>(bit));
  for (std::size_t k = 0; k < function.values.size(); ++k) {
    if ((k >> bit & 1) == to) rest.values += function.values[k];
  }
  return rest;
}

/// The function of only those bits on which it depends.
BitFunction reduced(BitFunction function) {
  for (std::size_t bit = function.bits.size(); bit-- > 0;) {
    BitFunction low = restricted(function, bit, 0);
    if (low.values == restricted(function, bit, 1).values) function = std::move(low);
  }
  return function;
}

/// The different functions that tables need.
class LookUpTables {
public:
  void add(const BitFunction& whole) {
    BitFunction function = reduced(whole);
    const std::size_t top = function.bits.size();
    // A constant or a bit of the address is no look-up table.
    if (top < 2 || !known_.insert(function).second) return;
    if (function.values.size() <= lut_entries) {
      ++luts_;
      return;
    }
    add(restricted(function, top - 1, 0));
    add(restricted(function, top - 1, 1));
    ++choices_;
  }

  int luts_of_lower_bits() const { return luts_; }
  int choices() const { return choices_; }

private:
  std::set<BitFunction> known_;
  int luts_ = 0, choices_ = 0;
};

}  // namespace

int table_luts(const std::vector<Bits>& words, int width) {
  std::vector<int> address(static_cast<std::size_t>(std::countr_zero(words.size())));
  std::iota(address.begin(), address.end(), 0);
  LookUpTables tables;
  for (int bit = 0; bit < width; ++bit) {
    std::string values;
    for (const Bits& word : words) values += (word >> bit & 1) != 0 ? '1' : '0';
    tables.add({address, values});
  }
  const double choices = words.size() > free_entries ? luts_of_choice * tables.choices() : 0;
  return tables.luts_of_lower_bits() + static_cast<int>(std::lround(choices));
}

}  // namespace mixcmp::estimated

#include "model/cost/estimated/table_luts.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

namespace mixcmp::estimated {
namespace {

constexpr std::size_t lut_entries = 64;
/// The entries that look-up tables and two levels of multiplexers choose among.
constexpr std::size_t free_entries = 4 * lut_entries;
/// Multiplexers of two above those, in look-up tables. A multiplexer of four takes one.
constexpr double luts_of_choice = 0.35;

/// Functions of the address, as their values at all addresses: "0110".
class Functions {
public:
  void add(std::string_view values) {
    const bool is_constant =
        std::all_of(values.begin(), values.end(), [&](char value) { return value == values[0]; });
    if (is_constant || !known_.emplace(values).second) return;
    if (values.size() <= lut_entries) {
      ++luts_;
      return;
    }
    const std::string_view low = values.substr(0, values.size() / 2);
    const std::string_view high = values.substr(values.size() / 2);
    add(low);
    add(high);
    if (low != high) ++choices_;
  }

  int luts_of_lower_bits() const { return luts_; }
  int choices() const { return choices_; }

private:
  std::set<std::string> known_;
  int luts_ = 0, choices_ = 0;
};

}  // namespace

int table_luts(const std::vector<Bits>& words, int width) {
  Functions functions;
  for (int bit = 0; bit < width; ++bit) {
    std::string values;
    for (const Bits& word : words) values += (word >> bit & 1) != 0 ? '1' : '0';
    functions.add(values);
  }
  const double choices = words.size() > free_entries ? luts_of_choice * functions.choices() : 0;
  return functions.luts_of_lower_bits() + static_cast<int>(std::lround(choices));
}

}  // namespace mixcmp::estimated

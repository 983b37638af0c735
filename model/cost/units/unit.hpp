#pragma once

#include <compare>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/common/bits.hpp"

/// Areas of units: templates with values for their parameters, mapped one by one.
namespace mixcmp::units {

/// One parameter of a unit: an integer, or a literal of so many bits.
struct Parameter {
  std::string name;
  int literal_bits = 0;  ///< 0: an integer
  Bits bits = 0;         ///< of the literal, or of an integer of 64 bits in two's complement

  /// An integer's value; for a literal the number of its ones.
  double size() const;
  bool is_literal() const { return literal_bits > 0; }
  bool bit(int index) const { return (bits >> index & 1) != 0; }

  friend auto operator<=>(const Parameter&, const Parameter&) = default;
};
Parameter integer(std::string name, long long value);

/// The name of a parameter that no template has: the number of products that surely are in embedded
/// multipliers, where the device has any.
inline constexpr std::string_view embedded_products = "EMBEDDED_PRODUCTS";

/// The name of a parameter that stands for a table's words: its look-up tables. The area of such a
/// unit is these and a register for each bit that is cut; no library has it.
inline constexpr std::string_view table_luts = "TABLE_LUTS";

/// The name of a parameter that is no size: 2^TOP is a limit of numbers. Yosys finds 22 to 26 LUTs
/// in a fixed_operand for every TOP from -996 to 300.
inline constexpr std::string_view exponent_of_limit = "TOP";

/// A template with all of its parameters, in the template's order.
struct Unit {
  std::string module;
  std::vector<Parameter> parameters;

  friend auto operator<=>(const Unit&, const Unit&) = default;
};

}  // namespace mixcmp::units

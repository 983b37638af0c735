#pragma once

#include <vector>

#include "model/base/common/bits.hpp"

namespace mixcmp::estimated {

/// The look-up tables of six inputs that hold a table in logic. Each bit of a word is a function of
/// the address: its parts that depend on the six low bits are look-up tables, equal ones of all
/// bits shared, and multiplexers of four choose among them. Two levels of multiplexers are no
/// look-up tables in most families. The share of those above is
/// fitted to tables of exp, sin and log after Yosys' synth_xilinx. `words`: [address], a power of
/// two of them.
int table_luts(const std::vector<Bits>& words, int width);

}  // namespace mixcmp::estimated

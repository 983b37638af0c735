#pragma once

#include <cstdint>
#include <vector>

#include "generator/hardware/emit/signature.hpp"
#include "generator/hardware/emit/test_vector.hpp"
#include "model/comparison/data/comparisons.hpp"
#include "model/design/design.hpp"

namespace mixcmp::verilator_tb {

/// Indices of `count` of `available` comparisons, spread over all of them.
std::vector<std::uint64_t> spread(std::uint64_t available, std::uint64_t count);

/// Indices of at most `count` of the scene's comparisons, in rising order. Comparisons whose
/// results are rare are looked for: those of each word of a result get up to `quota` divided by
/// eight places, and at least one.
std::vector<std::uint64_t> choose_comparisons(const design::Design& design,
                                              const data::Comparisons& comparisons,
                                              std::uint64_t count, std::uint64_t quota);

/// Makes at most `count` comparisons for a test bench that runs without this program. Most are the
/// scene's, spread over all data. Results that are rare among these, such as recomputed ones, are
/// looked for, and get up to a quarter of the places. The last eighth of all are comparisons with
/// zeros, NaNs, infinities and ends of the format's range in the place of operands of the data, and
/// with ties in one part of several.
/// Vector k is for lane k modulo the number of lanes; the golden model computes the word that this
/// lane must return. With lanes in groups the last word of a group is filled up, so that there may
/// be more than `count`.
std::vector<emit::TestVector> test_vectors(const design::Design& design,
                                           const data::Comparisons& comparisons,
                                           const emit::Signature& signature, std::uint64_t count);

}  // namespace mixcmp::verilator_tb

#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "model/base/number/verdict.hpp"
#include "verilator_tb/harness/protocol.hpp"
#include "verilator_tb/verify.hpp"

/// Functions that all judges share: the expected result by the golden model, and findings as text.
namespace mixcmp::verilator_tb {

/// A report in which nothing has been judged yet.
VerifyReport empty_report(const emit::Signature& signature, const design::Design& design,
                          const VerifyOptions& options);

/// The word with which a lane of the design's group number `group` must answer to these operands,
/// by the golden model.
ResultWord expected_word(const design::Design& design, std::size_t group,
                         std::span<const Bits> operands);
/// The verdict of a reference of the design, by the golden model.
Verdict reference_verdict(const design::Design& design, std::span<const Bits> operands);
/// Whether a reference must answer for operands that a lane leaves undecided: unless a second tier
/// decides them.
bool reaches_reference(const design::Design& design, std::span<const Bits> operands);

/// Whether a reference computes f and g without an infinity or a NaN, by the golden model.
bool computes_numbers(const design::Design& design, std::span<const Bits> operands);

/// "less, decided by the lane"
std::string describe(ResultWord word);
std::string to_text(harness::wire::Fault fault);

/// A mismatch with the comparison's items and operands filled in; the caller fills in the rest.
Mismatch describe_comparison(const design::Design& design, const data::Comparisons& comparisons,
                             std::uint64_t index);

/// Compares a result with the order of the real numbers f and g. Counts it in `truth`, as checked
/// or under the reason why it is not. Counts a wrong verdict of a lane also in `group`.
void check_against_truth(const TruthCheck& check, const design::Design& design,
                         std::span<const Bits> operands, ResultWord word, TruthCount& truth,
                         GroupReport& group);

}  // namespace mixcmp::verilator_tb

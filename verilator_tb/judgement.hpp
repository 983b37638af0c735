#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "model/number/verdict.hpp"
#include "verilator_tb/harness/protocol.hpp"
#include "verilator_tb/verify.hpp"

/// Functions that all judges share: the expected result by the golden model, and findings as text.
namespace mixcmp::tb {

/// A report in which nothing has been judged yet.
VerifyReport empty_report(const gen::Signature& signature, const model::Design& design,
                          const VerifyOptions& options);

/// The word with which a lane of the design's group number `group` must answer to these operands,
/// by the golden model.
model::ResultWord expected_word(const model::Design& design, std::size_t group,
                                std::span<const model::Bits> operands);

/// "less, decided by the lane"
std::string describe(model::ResultWord word);
std::string to_text(wire::Fault fault);

/// A mismatch with the comparison's items and operands filled in; the caller fills in the rest.
Mismatch describe_comparison(const model::Design& design, const model::Comparisons& comparisons,
                             std::uint64_t index);

/// Compares a result with the order of the real numbers f and g. Counts it in `truth`, as checked
/// or under the reason why it is not; counts a wrong verdict of a lane in `group`, too.
void check_against_truth(const TruthCheck& check, const model::Design& design,
                         std::span<const model::Bits> operands, model::ResultWord word,
                         TruthCount& truth, GroupReport& group);

}  // namespace mixcmp::tb

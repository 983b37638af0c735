#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "verilator_tb/harness/protocol.hpp"
#include "verilator_tb/verify.hpp"

/// Functions that all judges share: the expected result by the golden model, and findings as text.
namespace mixcmp::tb {

/// Flags of a result, at their places in m_axis_tdata.
inline constexpr std::uint32_t recomputed_flag = 4;
inline constexpr std::uint32_t undecided_flag = 8;

/// A report in which nothing has been judged yet.
VerifyReport empty_report(const gen::Signature& signature, const model::Design& design,
                          const VerifyOptions& options);

/// The m_axis_tdata with which a lane of the design's group number `group` must answer to these
/// operands, by the golden model.
std::uint32_t expected_tdata(const model::Design& design, std::size_t group,
                             std::span<const model::Bits> operands);

/// The bits of m_axis_tdata that have a meaning: the verdict of an undecided comparison has none.
std::uint32_t verdict_bits(std::uint32_t tdata);

/// "less, decided by the lane"
std::string describe_tdata(std::uint32_t tdata);
std::string to_text(wire::Fault fault);

/// A mismatch with the comparison's items and operands filled in; the caller fills in the rest.
Mismatch describe_comparison(const model::Design& design, const model::Comparisons& comparisons,
                             std::uint64_t index);

/// Compares a result with the order of the real numbers f and g. Counts it in `truth`, as checked
/// or under the reason why it is not; counts a wrong verdict of a lane in `group`, too.
void check_against_truth(const TruthCheck& check, const model::Design& design,
                         std::span<const model::Bits> operands, std::uint32_t tdata,
                         TruthCount& truth, GroupReport& group);

}  // namespace mixcmp::tb

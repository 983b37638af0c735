#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "model/base/number/verdict.hpp"
#include "model/base/settings/limits.hpp"

namespace mixcmp::scene {

/// The engine around a generated system. It forms the comparisons on the chip from items that are
/// loaded once.
enum class EngineKind {
  none,      ///< nothing: comparisons come as streams
  pairwise,  ///< every pair i < j of a set of items
  arg_min,   ///< the best of at most p_L + 1 candidates for each row of a stream
};
std::string_view to_string(EngineKind kind);

/// How the pairs that a pairwise engine reports leave it.
enum class ReportForm {
  pairs,   ///< one by one
  bitmap,  ///< the pairs of an item with the lanes of a group together, as flags
  count,   ///< not at all: the closing beat has their number
};
std::string_view to_string(ReportForm form);

struct EngineSpec {
  static constexpr int max_capacity = settings::limits::engine_capacity.most;

  EngineKind kind = EngineKind::none;
  int capacity = 1024;    ///< for pairwise: items that the memory holds, 2..max_capacity
  int row_tag_bits = 16;  ///< width of the tag that goes with an arg_min engine's row, 1..64
  /// Which verdicts leave a pairwise engine, indexed by Verdict. By default all except `greater`,
  /// that is, all pairs that are not certainly apart.
  VerdictSet report = {Verdict::less, Verdict::equal, Verdict::unordered};
  ReportForm report_as = ReportForm::pairs;
  int report_streams = 1;   ///< parallel streams of reports
  int lanes_per_group = 8;  ///< lanes of a pairwise engine that work in lock step

  /// Width in bits of a comparison's tag inside the system. The tag of a pair is {j, i}. An arg_min
  /// engine stores the row's tag (row_tag_bits) itself. Its comparisons' tags depend on the lanes'
  /// latencies; this returns 1 for them.
  int tag_bits() const;

  /// Lanes that an engine has in one piece with their shared logic, and that a plan counts
  /// together: a group of a pairwise engine, one lane of a chain.
  int lanes_per_segment() const;
};

/// The width in bits of the index, from 0, of one of `count` items.
int index_bits_for(int count);

/// The names of the verdicts that an engine reports.
std::vector<std::string_view> reported_verdicts(const EngineSpec& engine);

}  // namespace mixcmp::scene

#pragma once

#include <array>
#include <string_view>
#include <vector>

namespace mixcmp::model {

/// What stands around a generated system and makes its comparisons itself, out of items that are
/// loaded once.
enum class EngineKind {
  none,      ///< nothing: comparisons come as streams
  pairwise,  ///< every pair i < j of a set of items
};
std::string_view to_string(EngineKind kind);

struct EngineSpec {
  static constexpr int max_capacity = 65'536;

  EngineKind kind = EngineKind::none;
  int capacity = 1024;  ///< items that the memory holds, 2..max_capacity
  /// By golden::Verdict: which ones leave. All but `greater`: whatever is not certainly apart.
  std::array<bool, 4> report = {true, true, false, true};

  /// To number the items.
  int index_bits() const;
  /// Of the tag {j, i} of a pair.
  int tag_bits() const { return 2 * index_bits(); }
};

/// The words for what an engine reports.
std::vector<std::string_view> reported_verdicts(const EngineSpec& engine);

}  // namespace mixcmp::model

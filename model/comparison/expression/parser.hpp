#pragma once

#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "model/base/common/result.hpp"
#include "model/comparison/expression/graph.hpp"

namespace mixcmp::inline expression {

struct LetDefinition {
  std::string name;
  std::string text;
};

/// An integer variable and its value.
struct IndexValue {
  std::string name;
  long value;
};

/// Reads the points of table("FILE", x, degree). The error names the file.
using ReadPoints = std::function<Result<Interpolation>(const std::string& file, int degree)>;

/// Parses `text` into `graph`; docs/scene_file.md has the grammar. Names that are neither an index
/// nor a let are inputs; lets do not see `indices`. Operations on constants are done exactly and
/// add no node, except square roots.
///
/// Columns in errors are 1-based positions in `text`, or in the text of a let: then the error's
/// field is "let.NAME". The order of `lets` does not matter; a cycle is an error. The names of the
/// lets that `text` needs, directly or through others, are added to `used_lets` if it is given.
Result<NodeId> parse_expression(Graph& graph, const std::string& text,
                                std::span<const LetDefinition> lets,
                                std::set<std::string>* used_lets = nullptr,
                                std::span<const IndexValue> indices = {},
                                const ReadPoints& read_points = {});

/// An index and its values first..last, at least one.
struct IndexRange {
  std::string name;
  long first;
  long last;
};

/// Parses "k in 0..D-1". Errors are as for parse_expression.
Result<IndexRange> parse_index_range(const std::string& text, std::span<const LetDefinition> lets);

/// Whether a name is that of a function in expressions.
bool is_function_name(const std::string& name);

}  // namespace mixcmp::inline expression

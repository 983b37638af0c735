#pragma once

#include <string>
#include <vector>

#include "model/comparison/expression/typed_graph.hpp"

namespace mixcmp::inline expression {

/// An exact decimal if there is a short one, else "3/7", else "about 1.234e-500".
std::string to_text(const mpq_class& value);

/// "1.234e-500": at most `digits` significant digits, whatever the magnitude.
std::string rounded_text(const mpq_class& value, int digits);

/// The expression under `node` as a user would write it, without conversions. A text longer than
/// `max_length` characters is cut and ends in "...".
std::string to_text(const std::vector<TypedNode>& nodes, const std::vector<std::string>& inputs,
                    NodeId node, std::size_t max_length);
std::string to_text(const std::vector<Node>& nodes, const std::vector<std::string>& inputs,
                    NodeId node, std::size_t max_length);
std::string to_text(const Graph& graph, NodeId node, std::size_t max_length);

}  // namespace mixcmp::inline expression

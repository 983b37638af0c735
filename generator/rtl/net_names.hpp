#pragma once

#include <set>
#include <string>
#include <vector>

#include "model/expression/typed_graph.hpp"

namespace mixcmp::gen {

/// Hands out each name once; a name already taken gets "_2", "_3", ...
class NamePool {
public:
  explicit NamePool(std::set<std::string> taken) : taken_(std::move(taken)) {}
  std::string unique(const std::string& wanted);

private:
  std::set<std::string> taken_;
};

/// A role word for every node: inputs bear their ports' names, f and g are "f" and "g", short
/// expressions spell themselves out ("cxi_minus_cxj_squared"), longer ones say what they are
/// ("sum").
std::vector<std::string> name_nodes(const model::TypedGraph& graph,
                                    const std::vector<std::string>& ports, NamePool& pool);

/// The operation in words of its operands' names: "cxi - cxj".
std::string formula(const model::TypedGraph& graph, model::NodeId node,
                    const std::vector<std::string>& names);

}  // namespace mixcmp::gen

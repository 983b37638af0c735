#pragma once

#include <set>
#include <string>
#include <vector>

#include "model/comparison/expression/typed_graph.hpp"
#include "model/lane/error/bound_graph.hpp"
#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::rtl {

/// Hands out each name once; a name already taken gets "_2", "_3", ...
class NamePool {
public:
  explicit NamePool(std::set<std::string> taken) : taken_(std::move(taken)) {}
  std::string unique(const std::string& wanted);

private:
  std::set<std::string> taken_;
};

/// A name for every node: inputs bear their ports' names; f and g are "f" and "g" (with several
/// parts "f_0", "g_0", "f_1", ...); short expressions are spelled out ("cxi_minus_cxj_squared");
/// longer ones are named after their operation ("sum").
std::vector<std::string> name_nodes(const TypedGraph& graph, const std::vector<std::string>& ports,
                                    NamePool& pool);

/// Names for the nodes of a lane in fixed point. An input bears its port's name with "_fixed"; a
/// difference that decides is "difference" (with several parts "difference_0", ...); a cut
/// ends in "_cut", a limit in "_limited"; others are named as in floating point.
std::vector<std::string> name_nodes(const fixed::FixedLane& lane,
                                    const std::vector<std::string>& ports, NamePool& pool);

/// The suffix of the nets that belong to one part: "_2"; empty if there is only one part.
std::string part_suffix(std::size_t part, std::size_t parts);

/// The operation as a formula over its operands' names: "cxi - cxj".
std::string formula(const TypedGraph& graph, NodeId node, const std::vector<std::string>& names);
/// The formula of an operation on operands with these texts.
std::string formula(Operation operation, const std::string& a, const std::string& b);

/// A name for every node of an error bound. The last is "error_bound" with its part's suffix; a
/// node that reads a value of the lane is named after it ("cxi_rounded_binade").
std::vector<std::string> name_bounds(const error::BoundGraph& bound, const std::string& suffix,
                                     const std::vector<std::string>& values, NamePool& pool);

/// A bound's operation as a formula over its operands' names: "2^-17 * cxi_rounded_binade".
std::string bound_formula(const error::BoundGraph& bound, int node,
                          const std::vector<std::string>& bounds,
                          const std::vector<std::string>& values);

}  // namespace mixcmp::rtl

#pragma once

#include <vector>

#include "model/common/result.hpp"
#include "model/expression/graph.hpp"

/// Block floating point divides the operands of a comparison by a power of two that depends on
/// them, and common cuts divide what is linear in the operands. That changes no verdict where f and
/// g are homogeneous of one degree.
namespace mixcmp::fixed {

/// The degree of each part: f and g of operands that are multiplied by t > 0 are t^degree times
/// what they were. It need not be an integer: that of sqrt(x) is 1/2. Errors name the operation
/// whose operands differ in degree, or the sides that do.
///
/// Source: Euler's definition of homogeneous functions; docs/fixed_point.md, theorem 6.
Result<std::vector<mpq_class>> scale_degrees(const Graph& graph);

/// Likewise for operands of which the affine ones (`affine_nodes`) are multiplied by t as they
/// enter other operations; 0 for parts that are affine on both sides.
Result<std::vector<mpq_class>> cut_degrees(const Graph& graph);

}  // namespace mixcmp::fixed

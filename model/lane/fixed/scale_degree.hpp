#pragma once

#include <vector>

#include "model/base/common/result.hpp"
#include "model/comparison/expression/graph.hpp"

/// Block floating point divides the operands of a comparison by a power of two that depends on
/// them. Common cuts divide values that are linear in the operands. Neither changes a verdict if f
/// and g are homogeneous of the same degree.
namespace mixcmp::fixed {

/// The degree of each part: if the operands are multiplied by t > 0, f and g are multiplied by
/// t^degree. It need not be an integer: that of sqrt(x) is 1/2. Errors name the operation whose
/// operands differ in degree, or the sides that do.
///
/// Source: Euler's definition of homogeneous functions; docs/fixed_point.md, theorem 6.
Result<std::vector<mpq_class>> scale_degrees(const Graph& graph);

/// The degree of each part if only affine values (`affine_nodes`) are multiplied by t, as they
/// enter other operations; 0 for parts that are affine on both sides. Errors as in scale_degrees.
Result<std::vector<mpq_class>> cut_degrees(const Graph& graph);

}  // namespace mixcmp::fixed

#pragma once

#include <gmpxx.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/judge/proof/function_structure.hpp"
#include "model/lane/fixed/fixed_lane.hpp"

/// Functions of lanes in fixed point, derived again from the lane's nodes: from the words of its
/// tables, without the search that made them.
namespace mixcmp::proof {

struct FunctionEnclosure {
  Range value;  ///< encloses the computed number
  Range error;  ///< encloses the computed number less the function of the real argument
  std::map<NodeId, Range> inside = {};  ///< the computed numbers of the nodes inside
  std::string reason = {};              ///< by which theorem, and how
};

/// Encloses the result of a function by value and error of its argument. On every piece each node
/// inside becomes a polynomial in t with rational coefficients, plus a range for its cuts. The
/// function's series encloses the difference, as in theorem 10 of docs/fixed_point.md. None if a
/// piece has no bound, or if tables and t divide the argument's bits differently. Functions that
/// jump are enclosed by theorem 11. `nodes`: those of `lane`, of which those inside and the result
/// are as the lane states them.
std::optional<FunctionEnclosure> enclose_function(const fixed::FixedLane& lane,
                                                  const std::vector<fixed::FixedNode>& nodes,
                                                  const FunctionNodes& function);

/// The accuracy and the shape that a lane states of a function.
struct StatedFunction {
  std::string text;  ///< as the scene has it: "log(u)"
  Range error;       ///< the computed number less the function of the real argument
  Range own_error;   ///< the computed number less the function of the computed argument
  int degree = 0;
  mpz_class pieces;  ///< those that hold arguments
};

/// The functions of a lane in the order of its nodes; none if functions_of finds none.
std::vector<StatedFunction> stated_functions(const fixed::FixedLane& lane);

/// The nodes as an expression has them, for messages. A function is one node.
std::vector<Node> expression_of(const fixed::FixedLane& lane,
                                const std::vector<FunctionNodes>& functions);

}  // namespace mixcmp::proof

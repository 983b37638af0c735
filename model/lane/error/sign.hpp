#pragma once

#include <optional>
#include <set>

#include "model/comparison/expression/typed_graph.hpp"

namespace mixcmp::error {

/// The inputs whose ranges prove a sign; none if there is no proof.
using SignProof = std::optional<std::set<int>>;

/// `both` returns a proof that needs the inputs of both proofs, none if one of them is missing.
/// `either` returns the proof that needs fewer inputs.
SignProof both(const SignProof& a, const SignProof& b);
SignProof either(const SignProof& a, const SignProof& b);

/// Proofs of a node's sign. They hold for its computed value and for its true value alike
/// (docs/error_bounds.md, theorem 6); zeros count as both signs.
struct Sign {
  SignProof nonnegative;
  SignProof nonpositive;

  Sign negated() const { return {nonpositive, nonnegative}; }
};

/// The sign of a sum; it is known if both operands lie on the same side of zero.
Sign sum_sign(const Sign& a, const Sign& b);
/// The sign of a fused sum; it is known if all terms lie on the same side of zero. `signs` has one
/// Sign per node.
Sign sum_sign(const std::vector<FusedTerm>& terms, const std::vector<Sign>& signs);

/// Returns one Sign per node. `input_nonnegative[i]`: input i's range excludes negative values.
std::vector<Sign> analyse_signs(const TypedGraph& graph,
                                const std::vector<bool>& input_nonnegative);

}  // namespace mixcmp::error

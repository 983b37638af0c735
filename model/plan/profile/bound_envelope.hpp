#pragma once

#include <array>
#include <span>
#include <vector>

#include "model/lane/error/lane.hpp"
#include "model/plan/profile/envelope.hpp"

namespace mixcmp::profile {

/// Upper limit of a running or constant bound, from the envelopes of the values on which it
/// depends. For all lanes of one structure, the bound at precision L is at most scaled 2^(A-L) +
/// fixed. Proof: docs/theory.md, theorem 3.
class BoundEnvelope {
public:
  /// `lanes` have the precisions first, first + 1, ..., none below A. Their bound graphs differ
  /// only in constants (`same_structure`) and refer to lane nodes by the envelope's numbers.
  BoundEnvelope(std::span<const error::Lane* const> lanes, int first, int last,
                const Envelope& envelope);

  static bool same_structure(const error::AbsoluteBoundCriterion& a,
                             const error::AbsoluteBoundCriterion& b);

  /// Raises `scaled` and `fixed` to the limit of this bound where they are lower. Sets `wild` to 1
  /// where a condition may fail or the bound may be infinite.
  void raise(const EnvelopeBlock& block, EnvelopeRow& scaled, EnvelopeRow& fixed,
             EnvelopeRow& wild) const;

private:
  /// One node of the bound graph. At precision L its value is at most `row` times 2^(A-L) if the
  /// degree is 1, and at most `row` if it is 0.
  struct Step {
    error::BoundOperation operation;
    std::array<int, 2> operands;
    NodeId value;
    int degree;
    double constant;
  };
  void add_constant(Step& step, std::span<const error::Lane* const> lanes, int first, int id);
  void round_up(EnvelopeRow& row, double least, EnvelopeRow& wild) const;
  void evaluate(const Step& step, const EnvelopeBlock& block, std::vector<EnvelopeRow>& rows,
                EnvelopeRow& wild) const;

  int anchor_;
  int digits_;
  std::array<double, 2> smallest_;  ///< the least limit that `round_up` returns, by degree
  double largest_;
  std::vector<Step> steps_;
  std::vector<error::BoundCondition> conditions_;
};

}  // namespace mixcmp::profile

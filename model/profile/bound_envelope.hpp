#pragma once

#include <array>
#include <span>
#include <vector>

#include "model/error/lane.hpp"
#include "model/profile/envelope.hpp"

namespace mixcmp::model {

/// What a running or constant bound can come to, from the envelopes of the values it is made of:
/// at precision L at most scaled 2^(A-L) + fixed, for all lanes of one structure. Proof:
/// docs/profile.md, theorem 3.
class BoundEnvelope {
public:
  /// `lanes`: of precisions first, first + 1, ... >= A, whose bound graphs differ in constants only
  /// (same_structure); the nodes they look at are numbered as in the envelope.
  BoundEnvelope(std::span<const Lane* const> lanes, int first, int last, const Envelope& envelope);

  static bool same_structure(const AbsoluteBoundDecision& a, const AbsoluteBoundDecision& b);

  /// Raises `scaled` and `fixed` to what this bound may come to, and `wild` to 1 where a condition
  /// may fail or the bound may be infinite.
  void raise(const EnvelopeBlock& block, EnvelopeRow& scaled, EnvelopeRow& fixed,
             EnvelopeRow& wild) const;

private:
  /// Degree 1: the bound is at most `row` times 2^(A-L); degree 0: at most `row`.
  struct Step {
    BoundOperation operation;
    std::array<int, 2> operands;
    NodeId value;
    int degree;
    double constant;
  };
  void add_constant(Step& step, std::span<const Lane* const> lanes, int first, int id);
  void round_up(EnvelopeRow& row, double least, EnvelopeRow& wild) const;
  void evaluate(const Step& step, const EnvelopeBlock& block, std::vector<EnvelopeRow>& rows,
                EnvelopeRow& wild) const;

  int anchor_;
  int digits_;
  std::array<double, 2> smallest_;  ///< by degree
  double largest_;
  std::vector<Step> steps_;
  std::vector<BoundCondition> conditions_;
};

}  // namespace mixcmp::model

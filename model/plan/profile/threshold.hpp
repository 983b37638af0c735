#pragma once

#include <span>
#include <variant>
#include <vector>

#include "model/lane/error/lane.hpp"
#include "model/lane/fixed/fixed_lane.hpp"
#include "model/plan/profile/bound_envelope.hpp"
#include "model/plan/profile/envelope.hpp"

namespace mixcmp::profile {

/// The distance of the true f and g at which a kind of lane certainly decides rightly, for every
/// precision L >= A at once: |f - g| > scaled 2^(A-L) + fixed suffices, unless the comparison is
/// wild (docs/theory.md, which also defines A). Proof: docs/theory.md, theorems 2 and 3.
class Threshold {
public:
  /// The threshold of a lane without an error bound, which decides by the order of the computed f
  /// and g.
  static Threshold of_order(const Envelope& envelope);
  /// `lanes` have the precisions A, A+1, ..., last. If a lane is missing, their kinds differ, or
  /// their graphs do not begin with the envelope's nodes, every comparison is wild.
  static Threshold of_lanes(std::span<const error::Lane* const> lanes, const Envelope& envelope);
  /// The threshold of one part of fixed-point lanes with W = A, A+1, ... bits; lanes may be
  /// missing. If any lane has limits, every comparison is wild.
  static Threshold of_fixed_lanes(std::span<const fixed::FixedLane* const> lanes, std::size_t part,
                                  const Envelope& envelope);

  /// Computes `scaled` and `fixed` for each comparison; sets `wild` to 1 if no threshold is known.
  void evaluate(const EnvelopeBlock& block, EnvelopeRow& scaled, EnvelopeRow& fixed,
                EnvelopeRow& wild) const;

private:
  struct Order {};
  struct Distance {
    double steps;  ///< the largest guard_ulp times 2^(1-A)
  };
  struct Interval {
    double f, g;  ///< factors of |f| and |g|
  };
  struct Absolute {
    std::vector<BoundEnvelope> bounds;  ///< one per structure of bound graphs
    double factor;
  };
  /// The threshold of a fixed-point lane: a constant and a multiple of the roots of f and g.
  struct Roots {
    double constant, per_root;  ///< the latter per sqrt(|f|) + sqrt(|g|)
    double error_of_double;     ///< double's error as a multiple of the error at precision A
  };
  /// A lane in block floating point compares operands divided by 2^e. `of_scaled` is the threshold
  /// for these; for the operands themselves it is 2^(e degree) times as large.
  struct Block {
    Roots of_scaled;
    double degree;               ///< of f and g, in the operands
    std::vector<NodeId> inputs;  ///< of the envelope's graph
    double least_scale;          ///< 2^e for the least e
  };
  struct Unknown {};
  using Kind = std::variant<Order, Distance, Interval, Absolute, Roots, Block, Unknown>;

  Threshold(Kind kind, double floor, NodeId f, NodeId g)
      : kind_(std::move(kind)), floor_(floor), f_(f), g_(g) {}
  static Kind kind_of(std::span<const error::Lane* const> lanes, const Envelope& envelope);
  static Kind distance(std::span<const error::Lane* const> lanes, const Envelope& envelope);
  static Kind interval(std::span<const error::Lane* const> lanes, const Envelope& envelope);
  static Kind block(const Roots& of_scaled, const fixed::FixedLane& lane, std::size_t part,
                    const Envelope& envelope);
  static Kind absolute(std::span<const error::Lane* const> lanes, const Envelope& envelope);
  void evaluate_of_floats(const EnvelopeBlock& block, EnvelopeRow& scaled, EnvelopeRow& fixed,
                          EnvelopeRow& wild) const;

  Kind kind_;
  double floor_;  ///< below it the lane's own difference might be flushed to zero
  NodeId f_, g_;
};

}  // namespace mixcmp::profile

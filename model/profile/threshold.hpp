#pragma once

#include <span>
#include <variant>
#include <vector>

#include "model/error/lane.hpp"
#include "model/profile/bound_envelope.hpp"
#include "model/profile/envelope.hpp"

namespace mixcmp::model {

/// How far apart f and g must be beyond their errors for one kind of lane to decide, at every
/// precision L >= A at once: |computed f - computed g| > scaled 2^(A-L) + fixed suffices, unless
/// the comparison is wild. Proof: docs/profile.md, theorems 2 and 3.
class Threshold {
public:
  /// The threshold of a lane without an error bound, which decides by the order of computed f and
  /// g.
  static Threshold of_order();
  /// `lanes`: of precisions A, A+1, ... last, whose graphs begin with the envelope's nodes. A kind
  /// of lane or graph that is not known makes every comparison wild.
  static Threshold of_lanes(std::span<const Lane* const> lanes, const Envelope& envelope);

  /// `wild` is raised to 1 where nothing can be said.
  void evaluate(const EnvelopeBlock& block, EnvelopeRow& scaled, EnvelopeRow& fixed,
                EnvelopeRow& wild) const;

private:
  struct Order {};
  struct Distance {
    double steps;  ///< guard_ulp 2^(1-A), at most
  };
  struct Interval {
    double f, g;  ///< of |f|, |g|
  };
  struct Absolute {
    std::vector<BoundEnvelope> bounds;  ///< one a structure
    double factor;
  };
  struct Unknown {};
  using Kind = std::variant<Order, Distance, Interval, Absolute, Unknown>;

  Threshold(Kind kind, double floor, NodeId f, NodeId g)
      : kind_(std::move(kind)), floor_(floor), f_(f), g_(g) {}
  static Kind kind_of(std::span<const Lane* const> lanes, const Envelope& envelope);
  static Kind distance(std::span<const Lane* const> lanes, const Envelope& envelope);
  static Kind interval(std::span<const Lane* const> lanes, const Envelope& envelope);
  static Kind absolute(std::span<const Lane* const> lanes, const Envelope& envelope);

  Kind kind_;
  double floor_;  ///< below it the lane's own difference might be flushed to zero
  NodeId f_, g_;
};

}  // namespace mixcmp::model

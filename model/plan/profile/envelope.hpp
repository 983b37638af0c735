#pragma once

#include <array>
#include <span>
#include <vector>

#include "model/base/settings/limits.hpp"
#include "model/comparison/expression/typed_graph.hpp"
#include "model/plan/profile/node_magnitudes.hpp"

namespace mixcmp::profile {

/// Number of comparisons in a block.
inline constexpr std::size_t envelope_width = 256;
using EnvelopeRow = std::array<double, envelope_width>;

/// The envelope of one node on a block of comparisons. It holds for those that are not wild.
struct NodeEnvelope {
  alignas(64) EnvelopeRow value;  ///< double evaluation of the true value x
  alignas(64) EnvelopeRow error;  ///< E: |computed - x| <= E 2^(A-L) at every precision L >= A
};

/// The envelopes of all nodes on one block; each thread has its own.
struct EnvelopeBlock {
  std::vector<NodeEnvelope> nodes;
  /// 1 for a wild comparison: some lane may meet an exceptional operation, so no envelope holds. 0
  /// for a tame one.
  alignas(64) EnvelopeRow wild;
};

/// Bounds the errors of the lanes of all precisions A, A+1, ..., last in one evaluation. Proof:
/// docs/theory.md, theorem 1.
class Envelope {
public:
  struct Options {
    int anchor = settings::limits::lane_precision.least;  ///< A
    int last = settings::limits::lane_precision.most;
    FloatFormat reference;  ///< also evaluates the comparison, in its own precision
    std::vector<NodeMagnitude> inputs;
  };

  /// `lane` is the graph that all lanes share, built at precision A. The envelope appends f - g to
  /// it.
  Envelope(const TypedGraph& lane, const Options& options);

  int anchor() const { return options_.anchor; }
  int node_count() const { return static_cast<int>(steps_.size()); }
  /// The lane's graph and f - g, its last node.
  const TypedGraph& graph() const { return graph_; }
  NodeId difference() const { return node_count() - 1; }

  /// Every value of a tame comparison is 0 or has a magnitude in 2^lowest .. 2^highest.
  int lowest() const { return lowest_; }
  int highest() const { return highest_; }
  /// The largest relative error of one rounding at precision A.
  double unit() const { return unit_; }

  /// Evaluates envelope_width comparisons: columns[i] points to the values of input i. Values
  /// beyond the end of the data are arbitrary.
  void evaluate(std::span<const double* const> columns, EnvelopeBlock& block) const;

private:
  /// How a node is evaluated, and the checks that it needs.
  struct Step {
    Operation operation;
    std::array<NodeId, 2> operands;
    int input;
    double constant, constant_error;
    bool may_be_large;
    /// If false, the check is |value| >= 2^lowest + tiny_factor * error, or an exact zero.
    bool never_tiny;
    double tiny_factor;
  };
  Step step(const TypedNode& node) const;
  void add_checks();
  void check(const Step& step, const NodeEnvelope& node, EnvelopeRow& wild) const;

  Options options_;
  double unit_;
  int lowest_, highest_;
  TypedGraph graph_;
  std::vector<Step> steps_;
};

}  // namespace mixcmp::profile

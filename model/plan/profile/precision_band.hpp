#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "model/plan/profile/envelope.hpp"
#include "model/plan/profile/lane_runner.hpp"
#include "model/plan/profile/schemes.hpp"
#include "model/plan/profile/threshold.hpp"

namespace mixcmp::profile {

/// The last precision at which a comparison may be open, in one byte. A comparison is open for a
/// scheme at a precision if the scheme may be undecided or wrong there.
using LastOpen = std::uint8_t;

/// The findings of one band on envelope_width comparisons.
struct BlockFindings {
  /// last[scheme * stride + k]: the last precision at which the scheme may be undecided or wrong on
  /// comparison k; anchor() - 1 if at none, next() if at next() or later.
  LastOpen* last;
  std::size_t stride;
  /// 1 if `likely_verdict` may differ from the true verdict or from the reference's.
  std::uint8_t* doubtful;
  Decision* likely_verdict;
};

/// The lanes of all schemes at precisions anchor .. next - 1, with an envelope at anchor that says
/// for which comparisons they need not be run.
class PrecisionBand {
public:
  /// `schemes` have lanes from precision `first` on. Without a graph there is no envelope, and all
  /// lanes have to be run.
  PrecisionBand(const Envelope::Options& options, int next, int first,
                const std::optional<TypedGraph>& graph, const std::vector<SchemeLanes>& schemes);

  int anchor() const { return anchor_; }
  int next() const { return next_; }
  std::size_t scheme_count() const { return runners_.size(); }
  const LaneRunner& runner(std::size_t scheme, int precision) const {
    return runners_[scheme][precision - anchor()];
  }

  /// Finds where envelope_width comparisons may be open. `columns` are as for Envelope::evaluate;
  /// `block` is working memory.
  void classify(std::span<const double* const> columns, EnvelopeBlock& block,
                const BlockFindings& findings) const;

private:
  /// One part of the comparison.
  struct Part {
    Envelope envelope;
    std::vector<Threshold> thresholds;  ///< one per scheme
  };

  void all_are_open(const BlockFindings& findings) const;
  void classify(const Part& part, std::span<const double* const> columns, EnvelopeBlock& block,
                const BlockFindings& findings) const;
  void last_open(const Part& part, const EnvelopeBlock& block, const BlockFindings& findings) const;
  void find_verdicts(const Part& part, const EnvelopeBlock& block,
                     const BlockFindings& findings) const;

  std::vector<Part> parts_;  ///< none without envelopes
  Combination combination_ = Combination::all;
  int reference_precision_;
  int anchor_, next_;
  std::vector<std::vector<LaneRunner>> runners_;  ///< [scheme][precision - anchor()]
};

}  // namespace mixcmp::profile

#include "model/plan/profile/precision_band.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "model/base/common/vector_clones.hpp"
#include "model/plan/profile/envelope_kernels.hpp"

namespace mixcmp::profile {
namespace {

using envelope_kernels::for_each_lane;
using envelope_kernels::outward;

/// Lower bounds of |f - g|, from its evaluation in double.
struct Gap {
  const NodeEnvelope &f, &g, &difference;
  double error_of_double;  ///< double's error as a multiple of the error at precision A

  double error(std::size_t k) const { return f.error[k] + g.error[k]; }
  double least(std::size_t k) const {
    return std::fabs(difference.value[k]) / outward - error(k) * error_of_double;
  }
};

Gap gap_of(const Envelope& envelope, const EnvelopeBlock& block) {
  const TypedGraph& graph = envelope.graph();
  return {block.nodes[graph.f()], block.nodes[graph.g()], block.nodes.back(),
          std::ldexp(outward, envelope.anchor() - 53)};
}

using Lanes = std::span<const std::optional<design::Lane>>;

Threshold threshold_of_floats(Lanes lanes, std::size_t part, const Envelope& envelope) {
  std::vector<std::optional<error::Lane>> parts;
  for (const auto& lane : lanes) {
    parts.push_back(lane ? std::optional(part_of(design::float_lane(*lane), part)) : std::nullopt);
  }
  std::vector<const error::Lane*> pointers;
  for (const auto& lane : parts) pointers.push_back(lane ? &*lane : nullptr);
  return Threshold::of_lanes(pointers, envelope);
}

Threshold threshold_in_fixed_point(Lanes lanes, std::size_t part, const Envelope& envelope) {
  std::vector<const fixed::FixedLane*> pointers;
  for (const auto& lane : lanes) {
    pointers.push_back(lane ? &std::get<fixed::FixedLane>(*lane) : nullptr);
  }
  return Threshold::of_fixed_lanes(pointers, part, envelope);
}

/// The threshold of one part, from precision number `index` on.
Threshold threshold_of(const SchemeLanes& scheme, std::size_t part, int index,
                       const Envelope& envelope) {
  if (scheme.kind == SchemeKind::lanes_alone) return Threshold::of_order(envelope);
  const Lanes lanes = Lanes(scheme.lanes).subspan(static_cast<std::size_t>(index));
  const bool fixed_point = scheme.bound && scheme.bound->is_fixed_point();
  return fixed_point ? threshold_in_fixed_point(lanes, part, envelope)
                     : threshold_of_floats(lanes, part, envelope);
}

/// Merges the findings on the parts into findings on the whole comparison. A scheme is settled on
/// the whole once it is settled on every part, or on one part that dominates: that part's true
/// verdict decides the combination, whatever the others are.
class PartsMerger {
public:
  PartsMerger(Combination combination, std::size_t schemes, LastOpen never)
      : dominating_(combination == Combination::all ? Decision::greater : Decision::less),
        all_(schemes * envelope_width, 0),
        dominated_(schemes * envelope_width, never),
        last_(schemes * envelope_width) {
    any_doubt_.fill(0);
    any_dominating_.fill(0);
  }

  /// The arrays for the findings of the next part.
  BlockFindings part() { return {last_.data(), envelope_width, doubtful_.data(), truth_.data()}; }

  void add_part() {
    for (std::size_t k = 0; k < envelope_width; ++k) {
      const bool dominating = doubtful_[k] == 0 && truth_[k] == dominating_;
      any_doubt_[k] |= doubtful_[k];
      any_dominating_[k] |= dominating ? 1 : 0;
      for (std::size_t at = k; at < last_.size(); at += envelope_width) {
        all_[at] = std::max(all_[at], last_[at]);
        if (dominating) dominated_[at] = std::min(dominated_[at], last_[at]);
      }
    }
  }

  /// A doubtful part matters only if no part dominates. Verdicts without doubt are less or greater,
  /// so if no part dominates they are all the other one.
  void finish(const BlockFindings& findings) const {
    const Decision other = dominating_ == Decision::greater ? Decision::less : Decision::greater;
    for (std::size_t k = 0; k < envelope_width; ++k) {
      const bool dominating = any_dominating_[k] != 0;
      findings.doubtful[k] = dominating ? 0 : any_doubt_[k];
      findings.likely_verdict[k] = dominating ? dominating_ : other;
      for (std::size_t at = k; at < last_.size(); at += envelope_width) {
        findings.last[at / envelope_width * findings.stride + k] =
            std::min(all_[at], dominated_[at]);
      }
    }
  }

private:
  Decision dominating_;
  std::vector<LastOpen> all_, dominated_, last_;  ///< [scheme * envelope_width + k]
  std::array<std::uint8_t, envelope_width> doubtful_, any_doubt_, any_dominating_;
  std::array<Decision, envelope_width> truth_;
};

}  // namespace

PrecisionBand::PrecisionBand(const Envelope::Options& options, int next, int first,
                             const std::optional<TypedGraph>& graph,
                             const std::vector<SchemeLanes>& schemes)
    : reference_precision_(options.reference.precision()), anchor_(options.anchor), next_(next) {
  if (graph) combination_ = graph->combination;
  for (std::size_t k = 0; graph && k < graph->parts.size(); ++k) {
    Part& part = parts_.emplace_back(Part{Envelope(part_of(*graph, k).graph, options), {}});
    for (const SchemeLanes& scheme : schemes) {
      part.thresholds.push_back(threshold_of(scheme, k, options.anchor - first, part.envelope));
    }
  }
  for (const SchemeLanes& scheme : schemes) {
    std::vector<LaneRunner>& runners = runners_.emplace_back();
    for (int precision = anchor(); precision < next; ++precision) {
      runners.emplace_back(scheme.kind, scheme.lanes[precision - first]);
    }
  }
}

void PrecisionBand::classify(std::span<const double* const> columns, EnvelopeBlock& block,
                             const BlockFindings& findings) const {
  if (parts_.empty()) return all_are_open(findings);
  if (parts_.size() == 1) return classify(parts_.front(), columns, block, findings);
  PartsMerger merger(combination_, scheme_count(), static_cast<LastOpen>(next_));
  for (const Part& part : parts_) {
    classify(part, columns, block, merger.part());
    merger.add_part();
  }
  merger.finish(findings);
}

void PrecisionBand::all_are_open(const BlockFindings& findings) const {
  std::fill_n(findings.doubtful, envelope_width, std::uint8_t{1});
  for (std::size_t scheme = 0; scheme < scheme_count(); ++scheme) {
    std::fill_n(findings.last + scheme * findings.stride, envelope_width,
                static_cast<LastOpen>(next_));
  }
}

void PrecisionBand::classify(const Part& part, std::span<const double* const> columns,
                             EnvelopeBlock& block, const BlockFindings& findings) const {
  part.envelope.evaluate(columns, block);
  last_open(part, block, findings);
  find_verdicts(part, block, findings);
}

MIXCMP_VECTOR_CLONES void PrecisionBand::last_open(const Part& part, const EnvelopeBlock& block,
                                                   const BlockFindings& findings) const {
  alignas(64) EnvelopeRow scaled, fixed, wild;
  const Gap gap = gap_of(part.envelope, block);
  // The exponent of the ratio is the number of precisions after anchor - 1 that are open: none if
  // the ratio is below 1, all of them from `enough` on.
  const double enough = std::ldexp(1.0, next_ - anchor());
  const auto bias = static_cast<std::uint64_t>(1022 - (anchor() - 1));
  for (std::size_t scheme = 0; scheme < part.thresholds.size(); ++scheme) {
    wild = block.wild;
    part.thresholds[scheme].evaluate(block, scaled, fixed, wild);
    LastOpen* const open = findings.last + scheme * findings.stride;
    for_each_lane([&](std::size_t k) {
      // Open at L only if (|f - g| - fixed) 2^(L-A) <= scaled.
      const double apart = gap.least(k) - fixed[k];
      const double ratio = scaled[k] / apart * outward;
      const bool known = (wild[k] == 0) & (apart > 0) & (ratio < enough);
      const double within = known ? ratio : enough;
      const double clamped = within < 0.5 ? 0.5 : within;
      open[k] = static_cast<LastOpen>((std::bit_cast<std::uint64_t>(clamped) >> 52) - bias);
    });
  }
}

MIXCMP_VECTOR_CLONES void PrecisionBand::find_verdicts(const Part& part, const EnvelopeBlock& block,
                                                       const BlockFindings& findings) const {
  const Gap gap = gap_of(part.envelope, block);
  const double in_reference = std::ldexp(outward, part.envelope.anchor() - reference_precision_);
  for_each_lane([&](std::size_t k) {
    const bool clear = (block.wild[k] == 0) & (gap.least(k) > gap.error(k) * in_reference);
    findings.doubtful[k] = clear ? 0 : 1;
  });
  for (std::size_t k = 0; k < envelope_width; ++k) {
    const bool greater = block.nodes.back().value[k] > 0;
    findings.likely_verdict[k] = greater ? Decision::greater : Decision::less;
  }
}

}  // namespace mixcmp::profile

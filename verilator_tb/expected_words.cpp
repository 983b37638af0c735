#include "verilator_tb/expected_words.hpp"

#include <algorithm>

#include "model/common/check.hpp"

namespace mixcmp::verilator_tb {
namespace {

/// Comparisons that are emulated at a time: their operands fit the second-level cache.
constexpr std::size_t batch_size = 2048;

Verdict verdict_of(Decision decision) {
  switch (decision) {
    case Decision::less: return Verdict::less;
    case Decision::equal: return Verdict::equal;
    case Decision::greater: return Verdict::greater;
    case Decision::unordered: return Verdict::unordered;
    case Decision::undecided: break;
  }
  MIXCMP_CHECK(!"a comparison that is decided");
}

}  // namespace

ExpectedWords::ExpectedWords(const design::Design& design, const data::Comparisons& comparisons)
    : source_(comparisons),
      operands_(comparisons.input_count(), batch_size),
      undecided_(comparisons.input_count(), batch_size),
      decisions_(batch_size) {
  for (const design::LaneGroup& group : design.lanes) {
    std::visit(design::Cases{[&](const error::Lane& lane) {
                               lanes_.emplace_back(std::in_place_type<emulator::Emulator>, lane);
                             },
                             [&](const fixed::FixedLane& lane) {
                               lanes_.emplace_back(std::in_place_type<emulator::FixedEmulator>,
                                                   lane);
                             }},
               group.lane);
  }
  if (!design.references.empty()) reference_.emplace(design.reference);
}

void ExpectedWords::find(std::size_t group, std::span<const std::uint64_t> indices,
                         std::span<ResultWord> words) {
  for (std::size_t first = 0; first < indices.size(); first += batch_size) {
    const std::size_t count = std::min(batch_size, indices.size() - first);
    find_batch(lanes_[group], indices.subspan(first, count), words.subspan(first, count));
  }
}

void ExpectedWords::find_batch(const LaneEmulator& lane, std::span<const std::uint64_t> indices,
                               std::span<ResultWord> words) {
  source_.fetch(indices, operands_);
  const auto decide = [&](const auto& emulator) {
    emulator.decide(operands_.columns(), indices.size(), decisions_);
  };
  std::visit(decide, lane);
  undecided_.resize(0);
  positions_.clear();
  for (std::size_t k = 0; k < indices.size(); ++k) {
    if (decisions_[k] != Decision::undecided) {
      words[k] = ResultWord::decided(verdict_of(decisions_[k]));
      continue;
    }
    words[k] = ResultWord::undecided();
    undecided_.append(operands_, k);
    positions_.push_back(k);
  }
  if (reference_ && !positions_.empty()) recompute(words);
}

void ExpectedWords::recompute(std::span<ResultWord> words) {
  reference_->decide(undecided_.columns(), positions_.size(), decisions_);
  for (std::size_t k = 0; k < positions_.size(); ++k) {
    words[positions_[k]] = ResultWord::recomputed(verdict_of(decisions_[k]));
  }
}

}  // namespace mixcmp::verilator_tb

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

/// Comparisons that are emulated together, and room for what is computed of them.
struct ExpectedWords::Batch {
  explicit Batch(std::size_t inputs)
      : operands(inputs, batch_size), undecided(inputs, batch_size), decisions(batch_size) {}

  data::OperandBlock operands;
  data::OperandBlock undecided;        ///< those of `operands` that the lane does not decide
  std::vector<std::size_t> positions;  ///< in the batch, of each of `undecided`
  std::vector<Decision> decisions;
};

ExpectedWords::ExpectedWords(const design::Design& design, const data::Comparisons& comparisons)
    : source_(comparisons) {
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

bool ExpectedWords::emulates(std::size_t group) const {
  const auto* fixed_point = std::get_if<emulator::FixedEmulator>(&lanes_[group]);
  return fixed_point == nullptr || fixed_point->is_exact_in_double();
}

std::vector<ResultWord> ExpectedWords::find(std::size_t group,
                                            std::span<const std::uint64_t> indices) const {
  std::vector<ResultWord> words(indices.size(), ResultWord::undecided());
  Batch batch(source_.data().input_count());
  for (std::size_t first = 0; first < indices.size(); first += batch_size) {
    const std::size_t count = std::min(batch_size, indices.size() - first);
    source_.fetch(indices.subspan(first, count), batch.operands);
    find_batch(lanes_[group], batch, std::span(words).subspan(first, count));
  }
  return words;
}

void ExpectedWords::find_batch(const LaneEmulator& lane, Batch& batch,
                               std::span<ResultWord> words) const {
  const auto decide = [&](const auto& emulator) {
    emulator.decide(batch.operands.columns(), words.size(), batch.decisions);
  };
  std::visit(decide, lane);
  batch.undecided.resize(0);
  batch.positions.clear();
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (batch.decisions[k] != Decision::undecided) {
      words[k] = ResultWord::decided(verdict_of(batch.decisions[k]));
      continue;
    }
    batch.undecided.append(batch.operands, k);
    batch.positions.push_back(k);
  }
  if (reference_ && !batch.positions.empty()) recompute(batch, words);
}

void ExpectedWords::recompute(Batch& batch, std::span<ResultWord> words) const {
  reference_->decide(batch.undecided.columns(), batch.positions.size(), batch.decisions);
  for (std::size_t k = 0; k < batch.positions.size(); ++k) {
    words[batch.positions[k]] = ResultWord::recomputed(verdict_of(batch.decisions[k]));
  }
}

}  // namespace mixcmp::verilator_tb

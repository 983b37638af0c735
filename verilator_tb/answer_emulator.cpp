#include "verilator_tb/answer_emulator.hpp"

#include <utility>

#include "model/base/common/check.hpp"

namespace mixcmp::verilator_tb {
namespace {

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

emulator::Emulator emulator_of(const design::Lane& lane) {
  return std::visit([](const auto& made) { return emulator::Emulator(made); }, lane);
}

}  // namespace

AnswerEmulator::AnswerEmulator(const design::Design& design)
    : marks_second_tier_(design.has_second_lanes()) {
  for (const design::LaneGroup& group : design.lanes) lanes_.push_back(emulator_of(group.lane));
  if (design.second_tier) second_tier_.emplace(emulator_of(design.second_tier->lane));
  if (design.references.empty()) return;
  const fixed::FixedLane* rounding = design.requested_reference();
  rounding == nullptr ? reference_.emplace(design.reference) : reference_.emplace(*rounding);
}

bool AnswerEmulator::emulates(std::size_t group) const {
  return lanes_[group].is_emulated() && (!second_tier_ || second_tier_->is_emulated());
}

void AnswerEmulator::find(std::size_t group, Batch& batch, std::span<ResultWord> words) const {
  decide(lanes_[group], batch, words);
  if (second_tier_ && !batch.positions_.empty()) decide_again(batch, words);
  if (reference_ && !batch.positions_.empty()) recompute(batch, words);
}

void AnswerEmulator::decide(const emulator::Emulator& lane, Batch& batch,
                            std::span<ResultWord> words) const {
  lane.decide(batch.operands.columns(), words.size(), batch.decisions_);
  batch.undecided_.resize(0);
  batch.positions_.clear();
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (batch.decisions_[k] != Decision::undecided) {
      words[k] = ResultWord::decided(verdict_of(batch.decisions_[k]));
      continue;
    }
    words[k] = ResultWord::undecided();
    batch.undecided_.append(batch.operands, k);
    batch.positions_.push_back(k);
  }
}

void AnswerEmulator::decide_again(Batch& batch, std::span<ResultWord> words) const {
  second_tier_->decide(batch.undecided_.columns(), batch.positions_.size(), batch.decisions_);
  const std::vector<std::size_t> asked = std::exchange(batch.positions_, {});
  batch.undecided_.resize(0);
  for (std::size_t k = 0; k < asked.size(); ++k) {
    if (batch.decisions_[k] != Decision::undecided) {
      const Verdict verdict = verdict_of(batch.decisions_[k]);
      words[asked[k]] =
          marks_second_tier_ ? ResultWord::recomputed(verdict) : ResultWord::decided(verdict);
      continue;
    }
    batch.undecided_.append(batch.operands, asked[k]);
    batch.positions_.push_back(asked[k]);
  }
}

void AnswerEmulator::recompute(Batch& batch, std::span<ResultWord> words) const {
  reference_->decide(batch.undecided_.columns(), batch.positions_.size(), batch.decisions_);
  for (std::size_t k = 0; k < batch.positions_.size(); ++k) {
    words[batch.positions_[k]] = ResultWord::recomputed(verdict_of(batch.decisions_[k]));
  }
}

}  // namespace mixcmp::verilator_tb

#include "verilator_tb/answer_emulator.hpp"

#include "model/common/check.hpp"

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

}  // namespace

AnswerEmulator::AnswerEmulator(const design::Design& design) {
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

bool AnswerEmulator::emulates(std::size_t group) const {
  const auto* fixed_point = std::get_if<emulator::FixedEmulator>(&lanes_[group]);
  return fixed_point == nullptr || fixed_point->is_exact_in_double();
}

void AnswerEmulator::find(std::size_t group, Batch& batch, std::span<ResultWord> words) const {
  const auto decide = [&](const auto& emulator) {
    emulator.decide(batch.operands.columns(), words.size(), batch.decisions_);
  };
  std::visit(decide, lanes_[group]);
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
  if (reference_ && !batch.positions_.empty()) recompute(batch, words);
}

void AnswerEmulator::recompute(Batch& batch, std::span<ResultWord> words) const {
  reference_->decide(batch.undecided_.columns(), batch.positions_.size(), batch.decisions_);
  for (std::size_t k = 0; k < batch.positions_.size(); ++k) {
    words[batch.positions_[k]] = ResultWord::recomputed(verdict_of(batch.decisions_[k]));
  }
}

}  // namespace mixcmp::verilator_tb

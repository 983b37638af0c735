#include "verilator_tb/expected_words.hpp"

#include <algorithm>

namespace mixcmp::verilator_tb {

std::vector<ResultWord> ExpectedWords::find(std::size_t group,
                                            std::span<const std::uint64_t> indices) const {
  std::vector<ResultWord> words(indices.size(), ResultWord::undecided());
  AnswerEmulator::Batch batch(source_.data().input_count());
  for (std::size_t first = 0; first < indices.size(); first += AnswerEmulator::batch_size) {
    const std::size_t count = std::min(AnswerEmulator::batch_size, indices.size() - first);
    source_.fetch(indices.subspan(first, count), batch.operands);
    emulator_.find(group, batch, std::span(words).subspan(first, count));
  }
  return words;
}

}  // namespace mixcmp::verilator_tb

#include "verilator_tb/test_vectors.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "model/base/number/double.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/expression/typed_graph.hpp"
#include "verilator_tb/expected_words.hpp"
#include "verilator_tb/judgement.hpp"
#include "verilator_tb/selection.hpp"

namespace mixcmp::verilator_tb {
namespace {

constexpr std::uint64_t seed = 1;

/// Finds comparisons by the word that a lane of the first group answers to them.
class WordFinder {
public:
  WordFinder(const design::Design& design, const data::Comparisons& comparisons)
      : design_(design), comparisons_(comparisons), operands_(comparisons.input_count()) {
    if (!fits_double(comparisons.format())) return;
    emulator_.emplace(design, comparisons);
    if (!emulator_->emulates(0)) emulator_.reset();
  }

  /// How many comparisons can be looked at in a second or so for each one that is wanted.
  std::uint64_t candidates_for_each() const { return emulator_ ? 64 : 4; }

  std::vector<ResultWord> words(const std::vector<std::uint64_t>& indices) {
    if (emulator_) return emulator_->find(0, indices);
    std::vector<ResultWord> words;
    for (const std::uint64_t index : indices) {
      comparisons_.fetch(index, operands_);
      words.push_back(expected_word(design_, 0, operands_));
    }
    return words;
  }

private:
  const design::Design& design_;
  const data::Comparisons& comparisons_;
  std::vector<Bits> operands_;
  std::optional<ExpectedWords> emulator_;
};

/// Indices of `count` comparisons in rising order: the rare words' first, then any others.
std::vector<std::uint64_t> pick(WordFinder& finder, std::uint64_t available, std::uint64_t count,
                                std::uint64_t quota) {
  const std::vector<std::uint64_t> candidates =
      spread(available, std::min(available, count * finder.candidates_for_each()));
  if (candidates.size() <= count) return candidates;
  const std::vector<ResultWord> words = finder.words(candidates);
  std::map<std::uint32_t, std::vector<std::uint64_t>> by_word;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    by_word[words[k].bits()].push_back(candidates[k]);
  }
  // There are at most nine words: those of less, equal, greater and unordered, each by a lane or by
  // a reference, and undecided.
  const std::uint64_t of_a_word = std::max<std::uint64_t>(quota / 8, 1);
  std::set<std::uint64_t> picked;
  for (const auto& [word, indices] : by_word) {
    for (const std::uint64_t k : spread(indices.size(), std::min(of_a_word, indices.size()))) {
      if (picked.size() < count) picked.insert(indices[k]);
    }
  }
  for (const std::uint64_t index : spread(available, count)) {
    if (picked.size() < count) picked.insert(index);
  }
  return {picked.begin(), picked.end()};
}

/// Comparisons that data rarely have: some of the data with one operand, or all of them, replaced
/// by a zero, a NaN, an infinity, or a number at an end of the format's range. They show faults in
/// ties, in special values and in range checks. Lanes decide few of them, so a series of them keeps
/// lanes, crossbar and references as busy with recomputations as possible. If a comparison has
/// several parts, in some cases all operands of one part are zero, and those of the others as in
/// the data: the parts' verdicts then differ, and one of them is a tie.
class EdgeCases {
public:
  EdgeCases(const design::Design& design, const data::Comparisons& comparisons)
      : comparisons_(comparisons),
        formats_(design.formats_of_inputs()),
        values_(values_in(comparisons.format())),
        inputs_of_parts_(inputs_of_parts(design.reference)) {}

  std::uint64_t available() const {
    return values_.size() * (comparisons_.input_count() + 1) + ties();
  }

  /// The operands of case number `number` of `count`.
  std::vector<Bits> operands(std::uint64_t number, std::uint64_t count) const {
    std::vector<Bits> operands = edge_operands(number, count);
    for (std::size_t k = 0; k < operands.size(); ++k) operands[k] = number_of(k, operands[k]);
    return operands;
  }

private:
  static constexpr std::size_t positive_zero = 0, negative_zero = 1;
  static constexpr std::size_t ties_of_a_part = 8;

  /// The operands before they become numbers of their inputs.
  std::vector<Bits> edge_operands(std::uint64_t number, std::uint64_t count) const {
    const std::size_t inputs = comparisons_.input_count();
    std::vector<Bits> operands(inputs);
    comparisons_.fetch(number * comparisons_.size() / count, operands);
    const std::size_t which = number % values_.size();
    if (number < values_.size()) {
      std::fill(operands.begin(), operands.end(), values_[which]);
      if (which == negative_zero) {  // as equal as zeros of one sign
        for (std::size_t k = 0; k < inputs; k += 2) operands[k] = values_[positive_zero];
      }
    } else if (number < values_.size() + ties()) {
      for (const int input : inputs_of_parts_[number % inputs_of_parts_.size()]) {
        operands[input] = values_[positive_zero];
      }
    } else {
      operands[(number / values_.size() + which) % inputs] = values_[which];
    }
    return operands;
  }

  std::uint64_t ties() const {
    return inputs_of_parts_.size() > 1 ? ties_of_a_part * inputs_of_parts_.size() : 0;
  }

  static std::vector<std::vector<int>> inputs_of_parts(const TypedGraph& graph) {
    std::vector<std::vector<int>> inputs;
    for (const Sides& part : graph.parts) {
      const std::vector<bool> needed = needed_nodes(graph, {part.f, part.g});
      std::vector<int>& own = inputs.emplace_back();
      for (std::size_t id = 0; id < needed.size(); ++id) {
        const TypedNode& node = graph.nodes[id];
        if (needed[id] && node.operation == Operation::input) own.push_back(node.input);
      }
    }
    return inputs;
  }

  static std::vector<Bits> values_in(FloatFormat format) {
    constexpr Bits smallest = 1;
    return {format.zero(false),
            format.zero(true),
            format.quiet_nan(),
            format.infinity(false),
            format.infinity(true),
            format.largest_finite(false),
            format.largest_finite(true),
            format.smallest_normal(false),
            smallest};
  }

  /// A number of an input in place of a special value: in fixed point the next one above it, within
  /// the format, and the largest for a NaN; in a narrow floating-point format the nearest one other
  /// than zero and infinity, also for the infinities that it lacks.
  Bits number_of(std::size_t input, Bits value) const {
    const FloatFormat format = comparisons_.format();
    const FixedFormat* fixed = formats_[input].fixed();
    if (fixed == nullptr) {
      if (formats_[input].holds(format, value)) return value;
      const FloatFormat own = *formats_[input].floating();
      const Bits smallest = own.zero(format.sign(value)) | 1;
      Bits nearest = converted(own, format, value);
      if (!own.is_finite(nearest)) nearest = own.largest_finite(format.sign(value));
      if (own.is_zero(nearest)) nearest = smallest;
      return converted(format, own, nearest);
    }
    const bool is_negative = format.sign(value) && !format.is_nan(value);
    mpz_class units = is_negative ? fixed->smallest() : fixed->largest();
    if (!format.is_nan(value) && !format.is_infinite(value)) {
      const mpz_class exact = ceiling_of(to_rational(format, value) / fixed->unit());
      units = std::clamp(exact, fixed->smallest(), fixed->largest());
    }
    return from_rational(format, units * fixed->unit());
  }

  const data::Comparisons& comparisons_;
  std::vector<OperandFormat> formats_;
  std::vector<Bits> values_;
  std::vector<std::vector<int>> inputs_of_parts_;
};

}  // namespace

std::vector<std::uint64_t> spread(std::uint64_t available, std::uint64_t count) {
  const Selection selection(
      available, {.limit = count, .sampling = Sampling::random, .seed = seed, .only = {}});
  std::vector<std::uint64_t> indices(selection.size());
  for (std::uint64_t k = 0; k < indices.size(); ++k) indices[k] = selection.index(k);
  return indices;
}

std::vector<std::uint64_t> choose_comparisons(const design::Design& design,
                                              const data::Comparisons& comparisons,
                                              std::uint64_t count, std::uint64_t quota) {
  WordFinder finder(design, comparisons);
  return pick(finder, comparisons.size(), count, quota);
}

namespace {

std::vector<std::vector<Bits>> all_operands(const design::Design& design,
                                            const data::Comparisons& comparisons,
                                            std::uint64_t count) {
  const EdgeCases edges(design, comparisons);
  const std::uint64_t edge_count = std::min(count / 8, edges.available());
  const std::uint64_t chosen = count - edge_count;
  std::vector<std::vector<Bits>> all;
  for (const std::uint64_t index : choose_comparisons(design, comparisons, chosen, chosen / 4)) {
    comparisons.fetch(index, all.emplace_back(comparisons.input_count()));
  }
  for (std::uint64_t k = 0; k < edge_count; ++k) all.push_back(edges.operands(k, edge_count));
  return all;
}

/// Fills the last word of a group of lanes up with its own first comparison. Lanes of a group are
/// of one kind, so they answer it alike.
void fill_last_word(std::vector<emit::TestVector>& vectors, std::size_t lanes_per_group) {
  while (vectors.size() % lanes_per_group != 0) {
    vectors.push_back(vectors[vectors.size() / lanes_per_group * lanes_per_group]);
  }
}

}  // namespace

std::vector<emit::TestVector> test_vectors(const design::Design& design,
                                           const data::Comparisons& comparisons,
                                           const emit::Signature& signature, std::uint64_t count) {
  std::vector<emit::TestVector> vectors;
  for (const std::vector<Bits>& operands : all_operands(design, comparisons, count)) {
    const std::size_t k = vectors.size();
    std::vector<std::uint8_t> tdata(static_cast<std::size_t>(signature.tdata_bytes));
    pack_operands(operands, signature.reference_format, signature.input_formats, k % 2 != 0, tdata);
    const auto lane = static_cast<int>(k % static_cast<std::size_t>(signature.lanes));
    vectors.push_back(
        {std::move(tdata), expected_word(design, design.group_of_lane(lane), operands)});
  }
  fill_last_word(vectors, static_cast<std::size_t>(signature.lanes_per_group));
  return vectors;
}

}  // namespace mixcmp::verilator_tb

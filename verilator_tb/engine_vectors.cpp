#include "verilator_tb/engine_vectors.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "verilator_tb/arg_min_chain.hpp"
#include "verilator_tb/engine_verify.hpp"
#include "verilator_tb/judgement.hpp"
#include "verilator_tb/test_vectors.hpp"

namespace mixcmp::verilator_tb {
namespace {

using emit::ArgMinVectors;
using emit::PairwiseVectors;
using emit::RowVector;
using Indices = std::vector<std::uint64_t>;

/// The bytes of these rows of a table, one vector for each.
std::vector<std::vector<std::uint8_t>> beats(const data::Table& table,
                                             const std::vector<std::string>& columns,
                                             const std::vector<OperandFormat>& formats,
                                             int bytes_of_one, const Indices& rows) {
  const std::vector<std::uint8_t> bytes = row_bytes(table, columns, formats, bytes_of_one, rows);
  std::vector<std::vector<std::uint8_t>> beats;
  for (auto at = bytes.begin(); at != bytes.end(); at += bytes_of_one) {
    beats.emplace_back(at, at + bytes_of_one);
  }
  return beats;
}

/// The most items whose pairs are at most `pairs`, at least two.
std::uint64_t items_for(std::uint64_t pairs) {
  std::uint64_t items = 2;
  while (data::pair_count(items + 1) <= pairs) ++items;
  return items;
}

/// Items in rising order: half of them from pairs whose results are rare, the others spread.
Indices choose_items(const design::Design& design, const data::Comparisons& comparisons,
                     std::uint64_t count) {
  std::set<std::uint64_t> chosen;
  const auto take = [&](std::uint64_t item) {
    if (chosen.size() < count) chosen.insert(item);
  };
  const std::uint64_t pairs = std::max<std::uint64_t>(count / 4, 1);
  for (const std::uint64_t index : choose_comparisons(design, comparisons, pairs, pairs)) {
    const data::Items items = comparisons.items(index);
    take(items.first);
    take(items.second);
  }
  for (const std::uint64_t item : spread(comparisons.table().rows(), count)) take(item);
  for (std::uint64_t item = 0; chosen.size() < count; ++item) take(item);
  return {chosen.begin(), chosen.end()};
}

/// The word of each pair of these items of one table, or of two.
std::vector<ResultWord> expected_words(const design::Design& design,
                                       const data::Comparisons& comparisons, const Indices& items,
                                       const Indices* others) {
  std::vector<ResultWord> expected;
  std::vector<Bits> operands(comparisons.input_count());
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::size_t group =
        design.group_of_lane(static_cast<int>(i % static_cast<std::size_t>(design.lane_count())));
    const Indices& partners = others != nullptr ? *others : items;
    for (std::size_t j = others != nullptr ? 0 : i + 1; j < partners.size(); ++j) {
      comparisons.fetch({.row = 0, .first = items[i], .second = partners[j]}, operands);
      expected.push_back(expected_word(design, group, operands));
    }
  }
  return expected;
}

PairwiseVectors pairs_of_one_table(const design::Design& design,
                                   const data::Comparisons& comparisons,
                                   const emit::SignatureEngine& engine, std::uint64_t count) {
  const std::uint64_t most = std::min<std::uint64_t>(comparisons.table().rows(),
                                                     static_cast<std::uint64_t>(engine.capacity));
  const Indices items = choose_items(design, comparisons, std::min(items_for(count), most));
  return {.items = beats(comparisons.table(), engine.columns, engine.column_formats,
                         engine.item_bytes, items),
          .expected = expected_words(design, comparisons, items, nullptr)};
}

/// As many items of each table, spread: their pairs are at most `count`.
PairwiseVectors pairs_of_two_tables(const design::Design& design,
                                    const data::Comparisons& comparisons,
                                    const emit::SignatureEngine& engine, std::uint64_t count) {
  const auto half = static_cast<std::uint64_t>(engine.capacity) / 2;
  std::uint64_t each = 1;
  while (each < half && (each + 1) * (each + 1) <= count) ++each;
  const auto choose = [&](const data::Table& table) {
    return spread(table.rows(), std::min<std::uint64_t>(table.rows(), each));
  };
  const Indices targets = choose(comparisons.tables()[0]), others = choose(comparisons.tables()[1]);
  PairwiseVectors vectors{.items = beats(comparisons.tables()[0], engine.columns,
                                         engine.column_formats, engine.item_bytes, targets),
                          .targets = targets.size(),
                          .expected = expected_words(design, comparisons, targets, &others)};
  for (auto& item : beats(comparisons.tables()[1], engine.columns, engine.column_formats,
                          engine.item_bytes, others)) {
    vectors.items.push_back(std::move(item));
  }
  return vectors;
}

PairwiseVectors pairwise_vectors(const design::Design& design, const data::Comparisons& comparisons,
                                 const emit::Signature& signature, std::uint64_t count) {
  return comparisons.pairing() == data::Pairing::cross
             ? pairs_of_two_tables(design, comparisons, *signature.engine, count)
             : pairs_of_one_table(design, comparisons, *signature.engine, count);
}

RowVector row_vector(ArgMinChain& chain, std::uint64_t row, std::uint64_t candidates) {
  RowVector vector;
  vector.choice =
      static_cast<std::uint32_t>(chain.choose(row, candidates, [&](const ChainComparison& made) {
        vector.is_recomputed.push_back(made.word.is_recomputed());
      }));
  return vector;
}

bool any_recomputed(const RowVector& row) {
  return std::find(row.is_recomputed.begin(), row.is_recomputed.end(), true) !=
         row.is_recomputed.end();
}

/// Rows in rising order: up to a quarter of them with a recomputed comparison, the others spread.
Indices choose_rows(ArgMinChain& chain, std::uint64_t candidates, std::uint64_t available,
                    std::uint64_t count) {
  std::set<std::uint64_t> chosen;
  const auto recomputes = [&](std::uint64_t row) {
    return any_recomputed(row_vector(chain, row, candidates));
  };
  const Indices looked_at = spread(available, std::min(available, 4 * count));
  for (const std::uint64_t row : looked_at) {
    if (chosen.size() < (count + 3) / 4 && recomputes(row)) chosen.insert(row);
  }
  for (const std::uint64_t row : spread(available, count)) {
    if (chosen.size() < count) chosen.insert(row);
  }
  return {chosen.begin(), chosen.end()};
}

ArgMinVectors arg_min_vectors(const design::Design& design, const data::Comparisons& comparisons,
                              const emit::Signature& signature, std::uint64_t count) {
  const emit::SignatureEngine& engine = *signature.engine;
  const data::Table& all = comparisons.tables()[1];
  Indices candidates(
      std::min<std::uint64_t>(all.rows(), static_cast<std::uint64_t>(engine.capacity)));
  std::iota(candidates.begin(), candidates.end(), std::uint64_t{0});
  ArgMinChain chain(design, comparisons);
  const std::uint64_t available = comparisons.table().rows();
  const auto lanes = static_cast<std::uint64_t>(signature.lanes);
  const Indices rows = choose_rows(chain, candidates.size(), available,
                                   std::clamp<std::uint64_t>(count / lanes, 1, available));
  ArgMinVectors vectors{
      beats(all, engine.columns, engine.column_formats, engine.item_bytes, candidates), {}};
  const auto data = beats(comparisons.table(), engine.row_columns, engine.row_column_formats,
                          engine.row_bytes, rows);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    vectors.rows.push_back(row_vector(chain, rows[k], candidates.size()));
    vectors.rows.back().tdata = data[k];
  }
  return vectors;
}

}  // namespace

emit::EngineVectors engine_vectors(const design::Design& design,
                                   const data::Comparisons& comparisons,
                                   const emit::Signature& signature, std::uint64_t count) {
  switch (design.system.engine.kind) {
    case scene::EngineKind::none: return {};
    case scene::EngineKind::pairwise:
      return pairwise_vectors(design, comparisons, signature, count);
    case scene::EngineKind::arg_min: return arg_min_vectors(design, comparisons, signature, count);
  }
  MIXCMP_CHECK(!"an engine of no enumerator");
}

}  // namespace mixcmp::verilator_tb

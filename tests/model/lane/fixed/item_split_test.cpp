#include "model/lane/fixed/item_split.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "model/comparison/data/pairing.hpp"
#include "tests/model/lane/fixed/lanes.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

namespace mixcmp::test::item_split_test {
namespace {

using fixed::FixedLane;
using fixed::ItemInput;
using fixed::ItemRole;
using fixed::ItemSplit;

/// A lane, its split, and the columns that its inputs stand for.
struct Split {
  FixedLane lane;
  std::vector<std::string> columns, row_columns;
  std::vector<ItemInput> inputs;
  ItemSplit split;
};

/// Inputs whose names end in neither i nor j are the row's.
Split split_of(const Graph& graph, int bits, const Range& range) {
  FixedLane lane = lane_of(graph, bits, range);
  std::vector<std::string> columns, row_columns;
  std::vector<ItemInput> inputs;
  for (const std::string& input : graph.inputs()) {
    const auto item = data::item_column(input);
    std::vector<std::string>& names = item ? columns : row_columns;
    const std::string& name = item ? item->name : input;
    const auto known = std::find(names.begin(), names.end(), name);
    ItemInput read{static_cast<int>(known - names.begin()), ItemRole::row};
    if (item) read.role = item->second ? ItemRole::second : ItemRole::first;
    inputs.push_back(read);
    if (known == names.end()) names.push_back(name);
  }
  ItemSplit split = fixed::split_by_item({&lane}, inputs, columns, row_columns);
  return {std::move(lane), std::move(columns), std::move(row_columns), std::move(inputs),
          std::move(split)};
}

std::vector<std::string> fields_of(const fixed::ItemLoader& loader) {
  std::vector<std::string> fields;
  for (const NodeId id : loader.lane.outputs) {
    fields.push_back(std::string(to_string(loader.lane.nodes[id].operation)) + " " +
                     loader.lane.nodes[id].format.name());
  }
  return fields;
}

TEST(ItemSplit, OperandsOfASphereAreFields) {
  const Split made = split_of(graph_of(spheres, "(ri + rj)^2"), 13, {0, 100});
  EXPECT_EQ(fields_of(made.split.items), (std::vector<std::string>(4, "input ufix13_En6")));
  EXPECT_EQ(made.split.items.flags, (std::vector<std::vector<NodeId>>{{0, 1, 2, 3}}));
  const FixedLane& rest = made.split.lanes.front();
  EXPECT_EQ(rest.loaded_inputs.size(), 8u);
  EXPECT_EQ(fixed::flags_read(rest).size(), 2u) << "one of each item";
}

TEST(ItemSplit, WhatOneItemDecidesIsComputedOnce) {
  const Split made = split_of(graph_of("(ai^2 + bi) - 2 * aj", "bj * bj"), 7, {0, 4});
  EXPECT_EQ(fields_of(made.split.items).size(), 3u) << "a^2 + b, 2 a or a, b^2";
  for (const fixed::FixedNode& node : made.split.lanes.front().nodes) {
    EXPECT_NE(node.operation, Operation::square);
    EXPECT_NE(node.operation, Operation::multiply);
  }
}

/// A field holds an operand in the finest format; the other lane reads its upper bits. The coarser
/// lane's values that depend on one item only are computed from these bits.
TEST(ItemSplit, LanesOfTwoFormatsShareAnOperand) {
  const Graph graph = graph_of("(ai - aj)^2", "bi^2");
  const FixedLane coarse = lane_of(graph, 5, {-4, 4}), fine = lane_of(graph, 9, {-4, 4});
  const std::vector<ItemInput> inputs = {
      {0, ItemRole::first}, {0, ItemRole::second}, {1, ItemRole::first}};
  const ItemSplit split = fixed::split_by_item({&coarse, &fine}, inputs, {"a", "b"}, {});
  EXPECT_EQ(split.items.lane.outputs.size(), 5u) << "a, and b^2 and |b| of either";
  EXPECT_EQ(split.items.flags.size(), 2u) << "of a and of b, whatever the lane";
  EXPECT_EQ(split.lanes[0].loaded_inputs[0].dropped_bits, 4);
  EXPECT_EQ(split.lanes[1].loaded_inputs[0].dropped_bits, 0);
  for (const char* a : {"-4", "-3.3", "-0.01", "-0", "0", "1.7", "3.99", "1e-9"}) {
    const std::vector<const char*> item = {a, "1.3"};
    const auto word = integers_of(split.items.lane, item);
    for (const auto& [lane, whole] :
         {std::pair(&split.lanes[0], &coarse), std::pair(&split.lanes[1], &fine)}) {
      const auto values = integers_of(*whole, {a, a, "1.3"});
      for (const fixed::LoadedInput& loaded : lane->loaded_inputs) {
        mpz_class value = word[split.items.lane.outputs[loaded.field]].value();
        mpz_fdiv_q_2exp(value.get_mpz_t(), value.get_mpz_t(),
                        static_cast<mp_bitcnt_t>(loaded.dropped_bits));
        EXPECT_NE(std::find(values.begin(), values.end(), value), values.end()) << a;
      }
    }
  }
}

TEST(ItemSplit, EachSetOfPartsHasAFlag) {
  const Split made = split_of(
      graph_of({{"ai", "aj"}, {"bi", "bj"}, {"ai + ci", "bj"}}, Combination::any), 6, {0, 9});
  // Column a of item i matters to parts 0 and 2, of item j to part 0. Column b of item i matters to
  // part 1, of item j to parts 1 and 2. Column c matters to part 2.
  EXPECT_EQ(made.split.items.flags.size(), 3u);
}

/// The flags of a word: whether some operand of each does not fit.
std::vector<bool> flags_of(const fixed::ItemLoader& loader,
                           const std::vector<std::optional<mpz_class>>& loaded) {
  std::vector<bool> flags;
  for (const std::vector<NodeId>& inputs : loader.flags) {
    flags.push_back(std::any_of(inputs.begin(), inputs.end(),
                                [&](NodeId id) { return !loaded[id].has_value(); }));
  }
  return flags;
}

/// The columns of item i, of item j and of the row.
using Columns = std::array<std::vector<Bits>, 3>;

/// The nodes of the whole lane in the order in which the rest has them.
class Walk {
public:
  Walk(const Split& made, const Columns& columns) : made_(made) {
    for (const ItemRole role : {ItemRole::first, ItemRole::second, ItemRole::row}) {
      const auto k = static_cast<std::size_t>(role);
      words_[k] = golden::evaluate(made.split.of(role).lane, columns[k]);
    }
    std::vector<Bits> operands;
    for (const ItemInput& input : made.inputs) {
      operands.push_back(columns[static_cast<std::size_t>(input.role)][input.column]);
    }
    whole_ = golden::evaluate(made.lane, operands);
  }

  /// Checks that each part sees the operands that do not fit, and that loaded values are those of
  /// the lane.
  void check() const {
    const FixedLane& rest = made_.split.lanes.front();
    for (std::size_t part = 0; part < rest.parts.size(); ++part) {
      EXPECT_EQ(is_out_of_range(rest, part),
                !whole_[made_.lane.parts[part].difference].has_value());
    }
    for (const fixed::FixedNode& node : rest.nodes) {
      if (node.operation == Operation::input) check_loaded(rest, node);
    }
  }

private:
  const std::vector<std::optional<mpz_class>>& word_of(const fixed::LoadedInput& loaded) const {
    return words_[static_cast<std::size_t>(loaded.role)];
  }

  bool is_out_of_range(const FixedLane& rest, std::size_t part) const {
    for (const NodeId id : fixed::fan_in(rest, rest.parts[part].difference)) {
      if (rest.nodes[id].operation != Operation::input) continue;
      const fixed::LoadedInput& loaded = rest.loaded_inputs[rest.nodes[id].input];
      const std::vector<bool> flags = flags_of(made_.split.of(loaded.role), word_of(loaded));
      for (const std::size_t flag : loaded.flags) {
        if (flags[flag]) return true;
      }
    }
    return false;
  }

  /// Checks that the lane has a node with the value of the field.
  void check_loaded(const FixedLane& rest, const fixed::FixedNode& node) const {
    const fixed::LoadedInput& loaded = rest.loaded_inputs[node.input];
    const NodeId field = made_.split.of(loaded.role).lane.outputs[loaded.field];
    const auto& value = word_of(loaded)[field];
    const bool known = std::find(whole_.begin(), whole_.end(), value) != whole_.end();
    EXPECT_TRUE(known);
  }

  const Split& made_;
  std::array<std::vector<std::optional<mpz_class>>, 3> words_;  ///< by role
  std::vector<std::optional<mpz_class>> whole_;
};

/// A row's word has the values that depend only on the row, a candidate's word those that depend
/// only on a candidate.
TEST(ItemSplit, ARowHasAWordOfItsOwn) {
  const Split made =
      split_of(graph_of("(x - ai)^2 + 2 * x^2 + bi^2", "(x - aj)^2 + y + bj^2"), 8, {0, 4});
  EXPECT_EQ(made.split.items.lane.outputs.size(), 2u) << "a, b^2";
  EXPECT_EQ(made.split.rows.lane.outputs.size(), 3u) << "x, 2 x^2, y";
  EXPECT_EQ(made.split.items.flags.size(), 1u);
  EXPECT_EQ(made.split.rows.flags.size(), 1u);
  const std::vector<fixed::LoadedFlag> flags = fixed::flags_read(made.split.lanes.front());
  ASSERT_EQ(flags.size(), 3u);
  EXPECT_EQ(flags[0].role, ItemRole::first);
  EXPECT_EQ(flags[1].role, ItemRole::second);
  EXPECT_EQ(flags[2].role, ItemRole::row);
}

TEST(ItemSplit, PartsSeeTheOperandsThatDoNotFit) {
  std::mt19937_64 random(5);
  const std::vector<const char*> texts = {"0",  "-0", "1",   "3.5", "8",
                                          "16", "-1", "nan", "inf", "7.9"};
  const std::vector<Graph> graphs = {
      graph_of(spheres, "(ri + rj)^2"),
      graph_of({{"ai", "aj"}, {"bi", "bj"}, {"ai + ci", "bj"}}, Combination::any),
      graph_of({{"(ai - aj)^2", "bi^2"}, {"max(ai, ci)", "bj + cj"}}, Combination::all),
      graph_of("(x - ai)^2 + (y - bi)^2", "(x - aj)^2 + (y - bj)^2"),
      graph_of({{"(x - ai)^2", "y^2 + bi"}, {"x + aj", "ai + z"}}, Combination::any)};
  for (const Graph& graph : graphs) {
    const Split made = split_of(graph, 6, {0, 8});
    const auto values_of = [&](const std::vector<std::string>& columns) {
      std::vector<Bits> values;
      for (std::size_t k = 0; k < columns.size(); ++k) {
        const char* text = random() % 3 > 0 ? "2.5" : texts[random() % texts.size()];
        values.push_back(from_text(made.lane.input_format, text).value());
      }
      return values;
    };
    for (int k = 0; k < 500; ++k) {
      Walk(made, {values_of(made.columns), values_of(made.columns), values_of(made.row_columns)})
          .check();
    }
  }
}

}  // namespace
}  // namespace mixcmp::test::item_split_test

#include "model/scene/moves.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <utility>

#include "model/comparison/expression/parser.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/judge/golden/enclosure.hpp"
#include "tests/model/scene/scene_fixture.hpp"
#include "tests/support/graphs.hpp"

namespace mixcmp::test::moves_test {
namespace {

using Ranges = std::vector<std::optional<Range>>;

std::string text_of(const Graph& graph) {
  std::string text;
  for (const auto& [f, g] : graph.parts()) {
    if (!text.empty()) text += "; ";
    text += to_text(graph, f, 1000) + " against " + to_text(graph, g, 1000);
  }
  return text;
}

/// The texts of all moves of f against g. `ranges`: of the inputs in their order of appearance.
std::vector<std::string> moves(const std::string& f, const std::string& g, const Ranges& ranges) {
  std::vector<std::string> texts;
  for (const Graph& graph : scene::moved(graph_of(f, g), ranges)) texts.push_back(text_of(graph));
  return texts;
}

using Texts = std::vector<std::string>;

std::string first_of(const Texts& texts) {
  return texts.empty() ? "none" : texts.front();
}

const Range any = {-100, 100}, positive = {1, 100}, not_negative = {0, 100}, negative = {-9, -1};

TEST(Moves, OperationsLeaveTheirSide) {
  EXPECT_EQ(moves("sqrt(a)", "b", {not_negative, not_negative}), Texts{"a against b^2"});
  EXPECT_EQ(moves("b", "sqrt(a)", {not_negative, not_negative}), Texts{"b^2 against a"});
  EXPECT_EQ(moves("a / c", "b", {any, positive, any}), Texts{"a against c * b"});
  EXPECT_EQ(moves("a / c", "b", {any, negative, any}), Texts{"c * b against a"});
  EXPECT_EQ(moves("exp(a)", "b", {any, positive}), Texts{"a against log(b)"});
  EXPECT_EQ(moves("log1p(a)", "b", {positive, positive}), Texts{"a against expm1(b)"});
  EXPECT_EQ(moves("a^(1/3)", "b", {positive, not_negative}), Texts{"a against b * b^2"});
  EXPECT_EQ(moves("a^0.4", "b", {positive, not_negative}), Texts{"a against b^2.5"});
}

TEST(Moves, SumsAndFactorsAroundThemGoFirst) {
  EXPECT_EQ(moves("sqrt(a) - (b + c)", "0", {any, positive, positive}), Texts{});
  EXPECT_EQ(moves("sqrt(a) - (b + c)", "0", {positive, positive, positive}),
            Texts{"a against (b + c)^2"});
  EXPECT_EQ(moves("3 - 2 * exp(a)", "-b", {any, positive}), Texts{"log((b + 3) * 0.5) against a"});
  EXPECT_EQ(moves("-sqrt(a)", "b", {positive, negative}), Texts{"(-b)^2 against a"});
}

TEST(Moves, TheSameOnBothSidesLeavesTogether) {
  EXPECT_EQ(moves("sqrt(a)", "sqrt(b)", {positive, positive}), Texts{"a against b"});
  EXPECT_EQ(first_of(moves("log(a)", "log(b)", {positive, positive})), "a against b");
  const Range branch = {mpq_class(-9, 10), mpq_class(9, 10)};
  EXPECT_EQ(first_of(moves("tan(a)", "tan(b)", {branch, branch})), "a against b");
  EXPECT_EQ(moves("tan(a)", "tan(b)", {branch, Range{2, 3}}), Texts{"a against atan(tan(b))"});
  EXPECT_EQ(first_of(moves("a / b", "c / d", {any, positive, any, positive})),
            "a * d against b * c");
  EXPECT_EQ(first_of(moves("a / b", "c / d", {any, positive, any, negative})),
            "b * c against a * d");
  EXPECT_EQ(first_of(moves("a / b", "c / d", {any, negative, any, negative})),
            "a * d against b * c");
}

TEST(Moves, AreMadeOnlyIfRangesProveTheirCondition) {
  EXPECT_EQ(moves("sqrt(a)", "b", {not_negative, any}), Texts{});
  EXPECT_EQ(moves("sqrt(a)", "b", {not_negative, std::nullopt}), Texts{});
  EXPECT_EQ(moves("sqrt(a)", "b", {Range{-1, 2}, positive}), Texts{}) << "may be unordered";
  EXPECT_EQ(moves("a / c", "b", {any, not_negative, any}), Texts{});
  EXPECT_EQ(moves("exp(a)", "b", {any, not_negative}), Texts{});
  EXPECT_EQ(moves("a^-1.5", "b", {positive, positive}), Texts{});
  EXPECT_EQ(moves("atan(a)", "b", {any, any}), Texts{});
  EXPECT_EQ(moves("tan(a)", "b", {any, any}), Texts{});
  const Range branch = {mpq_class(-9, 10), mpq_class(9, 10)};
  EXPECT_EQ(moves("tan(a)", "b", {branch, any}), Texts{"a against atan(b)"});
  EXPECT_EQ(moves("tan(a)", "b", {Range{-1, 1}, any}), Texts{}) << "a lane accepts 1.9";
  EXPECT_EQ(moves("a^0.25", "b", {positive, Range{-4, 4}}), Texts{}) << "b^4 falls below 0";
  EXPECT_EQ(moves("a", "b^20", {positive, Range{-2, 2}}), Texts{});
  EXPECT_EQ(first_of(moves("a^(1/18)", "(b^18)^(1/18)", {positive, Range{-2, 2}})),
            "a against b^18");
  EXPECT_EQ(moves("sin(a)", "b", {Range{-1, 1}, Range{-1, 1}}), Texts{});
  EXPECT_EQ(moves("within(sqrt(a), 0, 5)", "b", {positive, positive}), Texts{})
      << "comparisons beyond the limits may stay undecided";
  EXPECT_EQ(moves("a / c", "0", {any, positive}), Texts{}) << "c would have no use";
}

/// Each of the paths to the root would take years.
TEST(Moves, AreFoundInSumsWithManyPaths) {
  Graph graph;
  const NodeId root = graph.apply(Operation::square_root, graph.input("a"));
  NodeId before = root, last = graph.input("b");
  for (int k = 0; k < 60; ++k) {
    before = std::exchange(last, graph.apply(Operation::add, before, last));
  }
  graph.compare(last, graph.constant(0));
  EXPECT_LE(scene::moved(graph, {positive, positive}).size(), scene::most_moves);
}

TEST(Moves, PartsThatBecomeEqualAreOne) {
  const Graph graph = graph_of({{"sqrt(a)", "b"}, {"a", "b^2"}}, Combination::any);
  const auto all = scene::moved(graph, {positive, positive});
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(text_of(all[0]), "a against b^2");
}

TEST(Moves, EachPartHasItsOwn) {
  const Graph graph = graph_of({{"sqrt(a)", "b"}, {"a", "b"}, {"a / b", "2"}}, Combination::any);
  const auto all = scene::moved(graph, {positive, positive});
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(text_of(all[0]), "a against b^2; a against b; a against b * 2");
  EXPECT_EQ(all[0].combination(), Combination::any);
  EXPECT_EQ(all[0].inputs(), graph.inputs());
}

/// The order of the real numbers f and g; none if it is not known.
std::optional<Verdict> true_order(const Graph& graph, const std::vector<Bits>& operands) {
  golden::Enclosure enclosure(graph, 300);
  const FloatFormat format = FloatFormat::make(53, 11).value();
  if (enclosure.compute(format, operands) != golden::Knowledge::enclosed) return std::nullopt;
  if (enclosure.are_equal()) return Verdict::equal;
  if (mpfr_less_p(enclosure.f().high.get(), enclosure.g().low.get()) != 0) return Verdict::less;
  if (mpfr_greater_p(enclosure.f().low.get(), enclosure.g().high.get()) != 0) {
    return Verdict::greater;
  }
  return std::nullopt;
}

/// Random expressions of a, b and c.
class Expressions {
public:
  explicit Expressions(unsigned seed) : random_(seed) {}

  std::string next(int depth) {
    const std::vector<std::string> operands = {"a", "b", "c", "0.75", "-2"};
    if (depth == 0) return operands[below(5)];
    const std::vector<std::string> unary = {
        "sqrt(X)", "exp(X)",  "log(X)",  "log1p(X)", "expm1(X)",  "tan(X)", "atan(X)",
        "exp2(X)", "log2(X)", "(X)^0.4", "(-(X))",   "(3 * (X))", "(X)^2"};
    const std::vector<std::string> binary = {"(X / Y)", "(X + Y)", "(X - Y)"};
    std::string form = below(3) > 0 ? unary[below(unary.size())] : binary[below(3)];
    for (const char name : {'X', 'Y'}) {
      const auto at = form.find(name);
      // A name of a function has no capital letter.
      if (at != std::string::npos) form.replace(at, 1, next(depth - 1));
    }
    return form;
  }

  Range range() {
    const mpq_class low = mpq_class(static_cast<int>(below(40))) / 10 - 1;
    return {low, low + mpq_class(static_cast<int>(1 + below(20))) / 10};
  }

  double within(const Range& range) {
    const double low = range.low.get_d(), high = range.high.get_d();
    switch (below(5)) {
      case 0: return low;
      case 1: return high;
      default: return std::uniform_real_distribution<double>(low, high)(random_);
    }
  }

  std::size_t below(std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
  }

private:
  std::mt19937 random_;
};

TEST(Moves, OrderRealNumbersAsBefore) {
  Expressions random(58);
  int moves = 0, orders = 0;
  while (moves < 400) {
    const std::string f = random.next(3), g = random.next(2);
    Graph graph;
    const auto left = parse_expression(graph, f, {}), right = parse_expression(graph, g, {});
    if (!left.ok() || !right.ok()) continue;  // such as log(-2)
    graph.compare(*left, *right);
    Ranges ranges;
    for (std::size_t k = 0; k < graph.inputs().size(); ++k) ranges.emplace_back(random.range());
    for (const Graph& moved : scene::moved(graph, ranges)) {
      ++moves;
      for (int k = 0; k < 8; ++k) {
        std::vector<Bits> operands;
        for (const auto& range : ranges) {
          operands.push_back(std::bit_cast<std::uint64_t>(random.within(*range)));
        }
        const auto before = true_order(graph, operands), after = true_order(moved, operands);
        if (!before || !after) continue;
        ++orders;
        ASSERT_EQ(*before, *after) << f << " against " << g << " as " << text_of(moved);
      }
    }
  }
  EXPECT_GT(orders, 2000);
}

class MovedScenes : public SceneTest {
protected:
  static std::string scene(const std::string& f, const std::string& g, const std::string& input,
                           const std::string& reference) {
    return "[comparison]\nname = \"s\"\nf = \"" + f + "\"\ng = \"" + g + "\"\n[inputs]\n\"*\" = {" +
           input + "}\n" + (reference.empty() ? "" : "[reference]\nformat = \"" + reference) +
           (reference.empty() ? "" : "\"\n");
  }

  Texts variants(const std::string& text) {
    const auto scene = load(text);
    EXPECT_TRUE(scene.ok()) << scene.error().to_string();
    return scene.ok() ? scene->variants : Texts();
  }
};

TEST_F(MovedScenes, AreVariantsOfAScene) {
  const std::string text = scene("(a - b) / c", "d", "range = [1, 9]", "s24e8");
  const auto given = load(text);
  ASSERT_TRUE(given.ok()) << given.error().to_string();
  EXPECT_EQ(given->variants, Texts{"moved_1"});
  EXPECT_EQ(given->variant, "");
  const auto moved = load(text, {"comparison.variant=moved_1"});
  ASSERT_TRUE(moved.ok()) << moved.error().to_string();
  EXPECT_EQ(moved->name, "s_moved_1");
  EXPECT_EQ(moved->f_text(), "a - b");
  EXPECT_EQ(moved->g_text(), "c * d");
  EXPECT_EQ(moved->graph.inputs(), given->graph.inputs());
  const auto as_written = load(text, {"comparison.variant=none"});
  ASSERT_TRUE(as_written.ok()) << as_written.error().to_string();
  EXPECT_EQ(as_written->variants, Texts{});
  EXPECT_FALSE(load(text, {"comparison.variant=moved_2"}).ok());
}

/// The square overflows in a format in which the root does not.
TEST_F(MovedScenes, ReferencesHaveNoNewException) {
  EXPECT_EQ(variants(scene("sqrt(a)", "b", "range = [1, 60000]", "s11e5")), Texts{});
  EXPECT_EQ(variants(scene("sqrt(a)", "b", "range = [1, 60000]", "s24e8")), Texts{"moved_1"});
  EXPECT_EQ(variants(scene("1e25 * sqrt(a)", "b^3", "range = [1, 1e30]", "s24e8")), Texts{})
      << "the format has no 1e50";
}

TEST_F(MovedScenes, StandForComparisonsThatNoReferenceComputes) {
  const std::string integers = scene("sqrt(a^2 + b^2)", "c", "format = \"uint8\"", "");
  const auto moved = load(integers);
  ASSERT_TRUE(moved.ok()) << moved.error().to_string();
  EXPECT_EQ(moved->f_text(), "a^2 + b^2");
  EXPECT_EQ(moved->variant, "moved_1");
  ASSERT_FALSE(moved->notes.empty());
  EXPECT_EQ(moved->notes[0],
            "no reference computes [comparison] (no reference is exact: square roots are rounded): "
            "moved_1 is used instead");
  EXPECT_FALSE(load(integers, {"comparison.variant=none"}).ok());
  EXPECT_TRUE(load(integers, {"comparison.variant=moved_1"}).ok());
  const auto without_logarithms = load(scene("log(a)", "log(b)", "range = [1, 9]", "s24e8"));
  ASSERT_TRUE(without_logarithms.ok()) << without_logarithms.error().to_string();
  EXPECT_EQ(without_logarithms->f_text(), "a");
}

/// Factors of roots move as their squares, not as reciprocals, which no format may hold.
TEST_F(MovedScenes, ExactReferencesStayExact) {
  const std::string text = scene("a / 3", "sqrt(b)", "format = \"uint8\"", "");
  const auto moved = load(text);
  ASSERT_TRUE(moved.ok()) << moved.error().to_string();
  EXPECT_EQ(moved->f_text() + " against " + moved->g_text(), "a^2 against b * 9");
  EXPECT_FALSE(load(text, {"comparison.variant=moved_1"}).ok()) << "a against 3 sqrt(b)";
}

}  // namespace
}  // namespace mixcmp::test::moves_test

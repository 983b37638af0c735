#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "model/base/number/verdict.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// Tests the combined verdict of several parts against the two orders in the documentation of the
/// scene file.
namespace mixcmp::test::combination_test {
namespace {

using golden::combine;
using golden::evaluate_reference;
using golden::true_verdict;

constexpr std::array order_of_all = {Verdict::less, Verdict::equal, Verdict::unordered,
                                     Verdict::greater};
constexpr std::array order_of_any = {Verdict::less, Verdict::unordered, Verdict::equal,
                                     Verdict::greater};

template <class Order>
std::ptrdiff_t place(const Order& order, Verdict verdict) {
  return std::find(order.begin(), order.end(), verdict) - order.begin();
}

TEST(Combination, IsTheLastOfAllAndTheFirstOfAny) {
  for (const Verdict a : order_of_all) {
    for (const Verdict b : order_of_all) {
      const Verdict last = place(order_of_all, a) > place(order_of_all, b) ? a : b;
      const Verdict first = place(order_of_any, a) < place(order_of_any, b) ? a : b;
      EXPECT_EQ(combine(Combination::all, a, b), last) << to_string(a) << ", " << to_string(b);
      EXPECT_EQ(combine(Combination::any, a, b), first) << to_string(a) << ", " << to_string(b);
    }
  }
}

Verdict of_parts(Combination combination, const std::vector<Verdict>& verdicts) {
  const auto before = [&](Verdict a, Verdict b) {
    return combination == Combination::all ? place(order_of_all, a) < place(order_of_all, b)
                                           : place(order_of_any, a) < place(order_of_any, b);
  };
  const auto all = combination == Combination::all;
  return all ? *std::max_element(verdicts.begin(), verdicts.end(), before)
             : *std::min_element(verdicts.begin(), verdicts.end(), before);
}

/// Compares every triple of encodings, NaNs and infinities among them, in three parts.
TEST(Combination, OfTruthAndReferenceIsThatOfTheirParts) {
  const FloatFormat format = format_of(3, 2);
  for (const Combination combination : {Combination::all, Combination::any}) {
    const Graph graph =
        graph_of({{"a", "b"}, {"b - c", "a * c"}, {"max(a, c)", "b / a"}}, combination);
    const TypedGraph reference = reference_graph(graph, {format});
    std::vector<TypedGraph> alone;
    for (std::size_t k = 0; k < 3; ++k) {
      alone.push_back(reference_graph(graph.part(k), {format}));
    }
    const Bits end = Bits{1} << format.width();
    for (Bits index = 0; index < end * end * end; ++index) {
      const std::vector<Bits> inputs = {index % end, index / end % end, index / end / end};
      std::vector<Verdict> truths, references;
      for (std::size_t k = 0; k < 3; ++k) {
        truths.push_back(true_verdict(graph.part(k), format, inputs).value());
        references.push_back(evaluate_reference(alone[k], inputs));
      }
      ASSERT_EQ(true_verdict(graph, format, inputs), of_parts(combination, truths));
      ASSERT_EQ(evaluate_reference(reference, inputs), of_parts(combination, references));
    }
  }
}

}  // namespace
}  // namespace mixcmp::test::combination_test

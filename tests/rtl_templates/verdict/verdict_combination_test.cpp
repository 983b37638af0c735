#include <gtest/gtest.h>

#include <vector>

#include "VCombination1_0.h"
#include "VCombination1_1.h"
#include "VCombination2_0.h"
#include "VCombination2_1.h"
#include "VCombination3_0.h"
#include "VCombination3_1.h"
#include "model/base/number/verdict.hpp"
#include "model/judge/golden/evaluate.hpp"

namespace mixcmp::test::verdict_combination_test {
namespace {

struct Expected {
  bool decided;
  Verdict verdict;
};

Expected expected_of(Combination combination, const std::vector<Verdict>& verdicts,
                     unsigned known) {
  const Verdict decides = golden::dominating_verdict(combination);
  Verdict all = verdicts.front();
  bool every = true;
  for (std::size_t part = 0; part < verdicts.size(); ++part) {
    const bool is_known = (known >> part & 1) != 0;
    if (is_known && verdicts[part] == decides) return {true, decides};
    every &= is_known;
    all = golden::combine(combination, all, verdicts[part]);
  }
  return {every, all};
}

/// Sends every verdict of every part, each known or not, through one registered cut.
template <class Model>
void expect_combined(unsigned parts, Combination combination) {
  VerilatedContext context;
  Model model(&context);
  int decided = 0;
  for (unsigned verdicts = 0; verdicts < 1u << (2 * parts); ++verdicts) {
    for (unsigned known = 0; known < 1u << parts; ++known) {
      model.verdicts = static_cast<CData>(verdicts);
      model.known = static_cast<CData>(known);
      model.aclk = 0;
      model.eval();
      model.aclk = 1;
      model.eval();
      std::vector<Verdict> of_parts;
      for (unsigned part = 0; part < parts; ++part) {
        of_parts.push_back(static_cast<Verdict>(verdicts >> (2 * part) & 3));
      }
      const Expected expected = expected_of(combination, of_parts, known);
      EXPECT_EQ(model.decided != 0, expected.decided) << parts << " " << verdicts << " " << known;
      if (!expected.decided) continue;
      ++decided;
      EXPECT_EQ(static_cast<Verdict>(model.verdict), expected.verdict)
          << parts << " " << verdicts << " " << known;
    }
  }
  EXPECT_GE(decided, 1 << (2 * parts));
}

TEST(VerdictCombination, OfAll) {
  expect_combined<VCombination1_0>(1, Combination::all);
  expect_combined<VCombination2_0>(2, Combination::all);
  expect_combined<VCombination3_0>(3, Combination::all);
}

TEST(VerdictCombination, OfAny) {
  expect_combined<VCombination1_1>(1, Combination::any);
  expect_combined<VCombination2_1>(2, Combination::any);
  expect_combined<VCombination3_1>(3, Combination::any);
}

}  // namespace
}  // namespace mixcmp::test::verdict_combination_test

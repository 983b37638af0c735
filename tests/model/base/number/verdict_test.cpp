#include "model/base/number/verdict.hpp"

#include <gtest/gtest.h>

/// Tests the encodings that rtl_templates/stream/README.md states, bit by bit.
namespace mixcmp::test::verdict_test {
namespace {

TEST(ResultWord, HasTheBitsThatThePageOfTheRtlSays) {
  EXPECT_EQ(ResultWord::decided(Verdict::less).bits(), 0b0000u);
  EXPECT_EQ(ResultWord::decided(Verdict::equal).bits(), 0b0001u);
  EXPECT_EQ(ResultWord::decided(Verdict::greater).bits(), 0b0010u);
  EXPECT_EQ(ResultWord::decided(Verdict::unordered).bits(), 0b0011u);
  EXPECT_EQ(ResultWord::recomputed(Verdict::greater).bits(), 0b0110u);
  EXPECT_EQ(ResultWord::undecided().bits(), 0b1000u);
}

TEST(ResultWord, IsReadFromAnyBits) {
  for (std::uint32_t bits = 0; bits < 64; ++bits) {
    const ResultWord word(bits);
    EXPECT_EQ(word.is_recomputed(), (bits & 4) != 0) << bits;
    EXPECT_EQ(word.is_undecided(), (bits & 8) != 0) << bits;
    EXPECT_EQ(word.is_decided_by_lane(), (bits & 12) == 0) << bits;
    EXPECT_EQ(word.is_possible(), bits < 12) << bits;
    EXPECT_EQ(word.verdict(), all_verdicts[bits % 4]) << bits;
  }
}

TEST(ResultWord, OfTheUndecidedIsTheSameWhateverItsVerdictBits) {
  for (std::uint32_t a = 0; a < 64; ++a) {
    for (std::uint32_t b = 0; b < 64; ++b) {
      const bool both_undecided = (a & 8) != 0 && (b & 8) != 0;
      EXPECT_EQ(ResultWord(a) == ResultWord(b), both_undecided ? a / 4 == b / 4 : a == b);
    }
  }
}

TEST(VerdictSet, HasABitForEachVerdict) {
  EXPECT_EQ(VerdictSet().mask(), 0u);
  EXPECT_EQ((VerdictSet{Verdict::less, Verdict::equal, Verdict::unordered}.mask()), 11u);
  const VerdictSet greater = {Verdict::greater};
  for (const Verdict verdict : all_verdicts) {
    EXPECT_EQ(greater.contains(verdict), verdict == Verdict::greater);
  }
}

TEST(Decisions, AreVerdictsOrNone) {
  for (const Verdict verdict : all_verdicts) {
    EXPECT_EQ(static_cast<int>(decision_of(verdict)), static_cast<int>(verdict));
  }
  EXPECT_EQ(decision_of(std::optional<Verdict>()), Decision::undecided);
}

}  // namespace
}  // namespace mixcmp::test::verdict_test

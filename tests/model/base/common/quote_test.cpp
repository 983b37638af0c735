#include "model/base/common/quote.hpp"

#include <gtest/gtest.h>

namespace mixcmp::test::quote_test {
namespace {

TEST(InQuotes, KeepsWhatALineCanShow) {
  EXPECT_EQ(in_quotes("s17e8"), "\"s17e8\"");
  EXPECT_EQ(in_quotes("größe"), "\"größe\"");
  EXPECT_EQ(in_quotes("a\tb\nc\x7f"), "\"a?b?c?\"");
  EXPECT_EQ(in_quotes("gr\xf6\xdf"
                      "e"),
            "\"gr??e\"")
      << "Latin-1";
  EXPECT_EQ(in_quotes("\xc0\x80 \xed\xa0\x80"), "\"?? ???\"") << "overlong, a surrogate";
}

TEST(InQuotes, CutsBetweenCharacters) {
  const std::string long_text = std::string(79, 'x') + "ä" + std::string(20, 'y');
  EXPECT_EQ(in_quotes(long_text), '"' + std::string(79, 'x') + "...\"");
  EXPECT_EQ(in_quotes(std::string(80, 'x')), '"' + std::string(80, 'x') + '"');
}

TEST(OnOneLine, HasOneBlankBetweenWords) {
  EXPECT_EQ(on_one_line("\n  a^2\r\n\t+ b "), "a^2 + b");
  EXPECT_EQ(on_one_line(" \n"), "");
}

TEST(Quoted, IsOneWordOfAShell) {
  EXPECT_EQ(quoted("scene.toml"), "scene.toml");
  EXPECT_EQ(quoted(""), "''");
  EXPECT_EQ(quoted("it's $HOME"), "'it'\\''s $HOME'");
  EXPECT_EQ(quoted("two\nlines"), "'two\nlines'");
}

}  // namespace
}  // namespace mixcmp::test::quote_test

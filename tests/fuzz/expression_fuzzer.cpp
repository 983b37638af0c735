#include <array>

#include "model/comparison/expression/parser.hpp"
#include "model/comparison/expression/text.hpp"
#include "tests/fuzz/input.hpp"

using namespace mixcmp;

/// The first line is an expression that may name the second as a let; the third is an index range.
/// The text of an expression that was read is an expression again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::array<std::string, 3> lines;
  std::size_t line = 0;
  for (const char c : test::text_of(data, size)) {
    if (c == '\n' && line + 1 < lines.size()) {
      ++line;
    } else {
      lines[line] += c;
    }
  }
  const std::array lets = {LetDefinition{"p", lines[1]}};
  const std::array indices = {IndexValue{"k", 3}};
  Graph graph;
  const auto node = parse_expression(graph, lines[0], lets, nullptr, indices);
  test::is_read(parse_index_range(lines[2], lets));
  if (!test::is_read(node)) return 0;
  constexpr std::size_t whole = 10000;
  const std::string text = to_text(graph, *node, whole);
  const bool is_cut = text.size() >= whole || text.find("about ") != std::string::npos;
  if (is_cut) return 0;
  Graph again;
  test::require(parse_expression(again, text, {}).ok());
  return 0;
}

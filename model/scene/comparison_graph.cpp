#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/settings/section.hpp"
#include "model/comparison/data/points.hpp"
#include "model/scene/sections.hpp"

namespace mixcmp::scene {
namespace {

/// Turns an error's column within an expression into a line and a column of the file. If the file
/// does not contain the text literally (escapes, --set), the message gives the position in the text
/// instead. An error in another file has its place already.
Error with_location(const settings::Setting& setting, Error error) {
  if (!error.file.empty()) return error;
  const auto column = static_cast<std::size_t>(error.column);
  static const std::string nothing;
  const std::string& source = setting.file ? setting.file->text : nothing;
  const auto& text = std::get<std::string>(setting.value);
  error.file = settings::file_of(setting);
  error.line = setting.line;
  error.column = 0;
  std::size_t line_start = 0;
  for (int line = 1; line < setting.line; ++line) line_start = source.find('\n', line_start) + 1;
  // An element of a list has no key and no equals sign.
  const std::size_t value = setting.key.empty() ? line_start : source.find('=', line_start);
  const std::size_t quote = source.find_first_of("\"'", value);
  std::size_t begin = quote == std::string::npos ? quote : source.find(text, quote + 1);
  // The text of a list's element may also occur inside another element. The right occurrence
  // follows a quote.
  while (setting.key.empty() && begin != std::string::npos && source[begin - 1] != '"' &&
         source[begin - 1] != '\'') {
    begin = source.find(text, begin + 1);
  }
  const auto lines_between = [&](std::size_t from, std::size_t to) {
    return static_cast<int>(std::count(source.begin() + static_cast<long>(from),
                                       source.begin() + static_cast<long>(to), '\n'));
  };
  const bool stands_there =
      setting.line > 0 && begin != std::string::npos &&
      setting.line + lines_between(line_start, begin + text.size()) <= setting.end_line;
  if (!stands_there) {
    error.message += fmt::format(" at character {} of the text", column);
    return error;
  }
  const std::size_t place = begin + column - 1;
  error.line += lines_between(line_start, place);
  const std::size_t newline = place == 0 ? std::string::npos : source.rfind('\n', place - 1);
  error.column = static_cast<int>(newline == std::string::npos ? place + 1 : place - newline);
  return error;
}

/// Gives a place in the file to an error in the text of `setting`, whose key is `field`, or in the
/// text of a let that it uses.
Error with_location_in(const settings::Settings& settings, const settings::Setting& setting,
                       const std::string& field, Error error) {
  if (error.field.empty()) {
    error.field = field;
    return with_location(setting, error);
  }
  const std::string let = error.field.substr(std::string_view("let.").size());
  const auto& let_table = std::get<settings::Setting::Table>(settings.root.find("let")->value);
  return with_location(*let_table.find(let), error);
}

/// The context in which all expressions of a comparison are parsed.
struct Reading {
  const settings::Settings& settings;
  std::span<const LetDefinition> lets;
  std::set<std::string> used_lets = {};

  Result<NodeId> parse(Graph& graph, const settings::Setting& setting, const std::string& field,
                       std::span<const IndexValue> indices) {
    const auto read_points = [&](const std::string& file, int degree) {
      return data::read_points(settings.path.parent_path() / file, degree);
    };
    const Result<NodeId> node = parse_expression(graph, std::get<std::string>(setting.value), lets,
                                                 &used_lets, indices, read_points);
    if (node.ok()) return node;
    return with_location_in(settings, setting, field, node.error());
  }
};

/// Refuses an index of `for` that has the name of an input. Lets do not see the index, so one of
/// them may use the same name for an input.
Result<Done> check_index_name(const ComparisonSpec& comparison, const Graph& graph) {
  if (comparison.index == nullptr) return Done{};
  const std::string& name = comparison.parts.front().indices.front().name;
  const std::vector<std::string>& inputs = graph.inputs();
  if (std::find(inputs.begin(), inputs.end(), name) == inputs.end()) return Done{};
  return settings::mistake_at(*comparison.index, "comparison.for",
                              fmt::format("the index {} has the name of an input", name),
                              comparison.index->shown(), "a name of no let, function or input");
}

}  // namespace

Result<Done> expand_parts(const settings::Settings& settings, std::span<const LetDefinition> lets,
                          ComparisonSpec& comparison) {
  if (comparison.index == nullptr) return Done{};
  const auto parsed = parse_index_range(std::get<std::string>(comparison.index->value), lets);
  if (!parsed.ok())
    return with_location_in(settings, *comparison.index, "comparison.for", parsed.error());
  const std::vector<PartSettings> listed = std::exchange(comparison.parts, {});
  for (long value = parsed->first; value <= parsed->last; ++value) {
    if (comparison.parts.size() + listed.size() > max_parts) {
      return settings::mistake_at(*comparison.index, "comparison.for", "too many parts",
                                  comparison.index->shown(),
                                  fmt::format("at most {} values", max_parts / listed.size()));
    }
    for (const PartSettings& part : listed) {
      comparison.parts.push_back({part.f, part.g, {{parsed->name, value}}});
    }
  }
  return Done{};
}

Result<Graph> read_graph(const settings::Settings& settings, const ComparisonSpec& comparison,
                         std::span<const LetDefinition> lets,
                         const std::vector<std::string>& inputs, std::set<std::string>& used_lets) {
  Graph graph;
  for (const std::string& input : inputs) graph.input(input);
  Reading reading{settings, lets};
  std::vector<Sides> parts;
  for (const PartSettings& part : comparison.parts) {
    MIXCMP_TRY(f, reading.parse(graph, *part.f, "comparison.f", part.indices));
    MIXCMP_TRY(g, reading.parse(graph, *part.g, "comparison.g", part.indices));
    parts.push_back({f, g});
  }
  MIXCMP_DO(check_index_name(comparison, graph));
  graph.compare(std::move(parts), comparison.combination);
  used_lets.merge(reading.used_lets);
  if (graph.inputs().empty()) {
    const settings::Section section(settings, "comparison");
    return section.mistake("f", "f and g name no input", "constants only",
                           "at least one input name");
  }
  return graph;
}

Result<Done> check_unused_lets(const settings::Settings& settings,
                               std::span<const LetDefinition> lets,
                               const std::set<std::string>& used) {
  for (const LetDefinition& let : lets) {
    if (used.contains(let.name)) continue;
    Graph scratch;
    Reading reading{settings, lets};
    const auto& table = std::get<settings::Setting::Table>(settings.root.find("let")->value);
    MIXCMP_TRY(node, reading.parse(scratch, *table.find(let.name), "let." + let.name, {}));
    MIXCMP_CHECK(node >= 0);
  }
  return Done{};
}

}  // namespace mixcmp::scene

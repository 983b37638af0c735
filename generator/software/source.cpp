#include "generator/software/source.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "embedded/software_program.hpp"
#include "generator/hardware/emit/version.hpp"
#include "generator/hardware/rtl/net_names.hpp"
#include "model/base/number/exact.hpp"

namespace mixcmp::software {
namespace {

using error::BoundOperation;

/// A finite number of the graph's format as an exact C++ literal.
std::string literal(FloatFormat format, Bits bits) {
  const double value = to_rational(format, bits).get_d();
  return fmt::format("{:a}{}", value, format == software_format() ? "" : "f");
}

std::string literal(float value) {
  return fmt::format("{:a}f", value);
}

/// The names in the loop body of one kernel: the nodes' local variables and the loads of inputs.
struct Body {
  const data::Comparisons& data;
  const TypedGraph& graph;
  rtl::NamePool pool;
  std::vector<std::string> names;

  Body(const data::Comparisons& comparisons, const TypedGraph& typed)
      : data(comparisons),
        graph(typed),
        pool({"columns", "i", "j", "threshold", "less", "greater", "all_less", "all_greater",
              "any_less", "any_greater", "use",
              // functions of program/arithmetic.hpp
              "magnitude", "square_root", "minimum", "maximum", "binade"}) {
    std::vector<std::string> ports;
    // No keyword of C++ begins with "in_".
    for (const std::string& input : graph.input_names) ports.push_back(pool.unique("in_" + input));
    names = rtl::name_nodes(graph, ports, pool);
  }

  std::string load(int input) const {
    const data::Item item = data.sources()[static_cast<std::size_t>(input)].item;
    return fmt::format("columns[{}][{}]", input, item == data.moving_item() ? "j" : "i");
  }
};

/// The operation of a node in C++. Inputs and conversions of inputs are loads, since columns are
/// rounded already.
std::string expression(const Body& body, NodeId id) {
  const TypedNode& node = body.graph.nodes[static_cast<std::size_t>(id)];
  const auto operand = [&](int k) {
    return body.names[static_cast<std::size_t>(node.operands[k])];
  };
  switch (node.operation) {
    case Operation::input: return body.load(node.input);
    case Operation::constant: return literal(node.format, node.constant);
    case Operation::convert:
      return body.load(body.graph.nodes[static_cast<std::size_t>(node.operands[0])].input);
    case Operation::negate: return "-" + operand(0);
    case Operation::absolute: return fmt::format("magnitude({})", operand(0));
    case Operation::add: return fmt::format("{} + {}", operand(0), operand(1));
    case Operation::subtract: return fmt::format("{} - {}", operand(0), operand(1));
    case Operation::multiply: return fmt::format("{} * {}", operand(0), operand(1));
    case Operation::square: return fmt::format("{0} * {0}", operand(0));
    case Operation::divide: return fmt::format("{} / {}", operand(0), operand(1));
    case Operation::square_root: return fmt::format("square_root({})", operand(0));
    case Operation::minimum: return fmt::format("minimum({}, {})", operand(0), operand(1));
    case Operation::maximum: return fmt::format("maximum({}, {})", operand(0), operand(1));
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;  // software has only composed sums
  }
  MIXCMP_CHECK(false);
}

std::string define(const std::string& name, const std::string& value) {
  return fmt::format("    const Real {} = {};\n", name, value);
}

std::string nodes(const Body& body) {
  std::string text;
  for (NodeId id = 0; id < static_cast<NodeId>(body.graph.nodes.size()); ++id) {
    const TypedNode& node = body.graph.nodes[static_cast<std::size_t>(id)];
    const bool unrounded =
        node.operation == Operation::input && node.format != body.graph.arithmetic.format;
    if (!unrounded) {
      text += define(body.names[static_cast<std::size_t>(id)], expression(body, id));
    }
  }
  return text;
}

/// A relation that must hold between f and g of any part, or of all.
std::string over_parts(const Body& body, const std::vector<Sides>& parts, const char* relation,
                       const char* joined_by) {
  std::string text;
  for (const Sides& part : parts) {
    const std::string& f = body.names[static_cast<std::size_t>(part.f)];
    const std::string& g = body.names[static_cast<std::size_t>(part.g)];
    const bool alone = parts.size() == 1;
    text += text.empty() ? "" : joined_by;
    text +=
        alone ? fmt::format("{} {} {}", f, relation, g) : fmt::format("({} {} {})", f, relation, g);
  }
  return text;
}

/// The call use(less, equal, greater). All three are false if a part is unordered and no other part
/// outweighs it.
std::string exact_verdict(const Body& body, const TypedGraph& graph) {
  const std::vector<Sides>& parts = graph.parts;
  const auto any = [&](const char* relation) { return over_parts(body, parts, relation, " | "); };
  const auto all = [&](const char* relation) { return over_parts(body, parts, relation, " & "); };
  if (parts.size() == 1) {
    return fmt::format("    use({}, {}, {});\n", all("<"), all("=="), all(">"));
  }
  if (graph.combination == Combination::all) {
    return fmt::format("    const bool less = {};\n    use(less, ({}) & !less, {});\n", all("<"),
                       all("<="), any(">"));
  }
  return fmt::format("    const bool greater = {};\n    use({}, ({}) & !greater, greater);\n",
                     all(">"), any("<"), all(">="));
}

std::string doubles(const scene::Scene& scene, const data::Comparisons& data) {
  const TypedGraph graph = reference_graph(scene.graph.with_any_operands(), {software_format()});
  const Body body(data, graph);
  return fmt::format(R"(struct Doubles {{
  using Real = double;
  const Real* const* columns;
  std::size_t i;

  /// use(less, equal, greater)
  template <class Use>
  void operator()(std::size_t j, Use use) const {{
{}{}  }}
}};
)",
                     nodes(body), exact_verdict(body, graph));
}

std::string bound_expression(const error::BoundGraph& bound, const error::BoundNode& node,
                             const std::vector<std::string>& bounds,
                             const std::vector<std::string>& values) {
  const auto operand = [&](int k) { return bounds[static_cast<std::size_t>(node.operands[k])]; };
  const std::string value = node.value < 0 ? "" : values[static_cast<std::size_t>(node.value)];
  switch (node.operation) {
    case BoundOperation::constant: return literal(float_at_least(node.constant));
    case BoundOperation::magnitude: return fmt::format("magnitude({})", value);
    case BoundOperation::binade: return fmt::format("binade({})", value);
    case BoundOperation::reciprocal: return fmt::format("1 / magnitude({})", value);
    case BoundOperation::add: return fmt::format("{} + {}", operand(0), operand(1));
    case BoundOperation::multiply: return fmt::format("{} * {}", operand(0), operand(1));
    case BoundOperation::maximum:
      return fmt::format("{0} > {1} ? {0} : {1}", operand(0), operand(1));
  }
  MIXCMP_CHECK(bound.nodes.empty());
  return "";
}

std::string scaled(const std::string& bound, float factor) {
  return factor == 1 ? bound : fmt::format("{} * {}", bound, literal(factor));
}

/// The C++ text that decides one part: statements, then the conditions for less and for greater.
struct PartText {
  std::string statements;
  std::string less;
  std::string greater;
};

PartText decide(Body& body, const RatioCriterion& criterion) {
  const std::string& f = body.names[static_cast<std::size_t>(body.graph.f())];
  const std::string& g = body.names[static_cast<std::size_t>(body.graph.g())];
  const std::string ratio = literal(criterion.ratio);
  return {"", fmt::format("{} * {} < {}", f, ratio, g), fmt::format("{} * {} < {}", g, ratio, f)};
}

PartText decide(Body& body, const ThresholdCriterion& criterion) {
  const std::vector<std::string> bounds =
      rtl::name_bounds(criterion.bound, "", body.names, body.pool);
  std::string text;
  for (std::size_t id = 0; id < bounds.size(); ++id) {
    text += define(bounds[id], bound_expression(criterion.bound, criterion.bound.nodes[id], bounds,
                                                body.names));
  }
  text += define("threshold", scaled(bounds.back(), criterion.factor));
  std::string valid;
  for (const FloatCondition& condition : criterion.conditions) {
    valid +=
        fmt::format(" & ({} <= magnitude({}))",
                    scaled(bounds[static_cast<std::size_t>(condition.bound)], condition.factor),
                    body.names[static_cast<std::size_t>(condition.value)]);
  }
  const std::string& difference = body.names[static_cast<std::size_t>(criterion.difference)];
  text += fmt::format("    const bool less = ({} < -threshold){};\n", difference, valid);
  text += fmt::format("    const bool greater = ({} > threshold){};\n", difference, valid);
  return {text, "less", "greater"};
}

int sign_code(error::RequiredSign sign) {
  switch (sign) {
    case error::RequiredSign::any: return 0;
    case error::RequiredSign::nonnegative: return 1;
    case error::RequiredSign::nonpositive: return 2;
  }
  MIXCMP_CHECK(false);
}

/// The range checks of all parts, each once. An operand that fails a check is a NaN in every part
/// that reads it.
std::string checks(const FloatFilter& filter) {
  std::vector<error::RangeCheck> all;
  for (const PartFilter& part : filter.parts) {
    for (const error::RangeCheck& check : part.checks) {
      if (std::find(all.begin(), all.end(), check) == all.end()) all.push_back(check);
    }
  }
  std::string text =
      fmt::format("  static constexpr std::array<Check, {}> checks = {{{{", all.size());
  for (const error::RangeCheck& check : all) {
    const int shift =
        check.leading_bits == 0 ? 0 : software_format().width() - 1 - check.leading_bits;
    text += fmt::format("\n      {{{}, {}, {}, {:#x}, {:#x}}},", check.input, sign_code(check.sign),
                        shift, static_cast<std::uint64_t>(check.least),
                        static_cast<std::uint64_t>(check.greatest));
  }
  return text + "}};\n";
}

std::string filter_type(BoundKind kind) {
  switch (kind) {
    case BoundKind::relative: return "RelativeFilter";
    case BoundKind::running: return "RunningFilter";
    case BoundKind::constant: return "ConstantFilter";
    case BoundKind::norm:
    case BoundKind::grid:
    case BoundKind::profiled: break;
  }
  MIXCMP_CHECK(false);
}

/// The kernel of a comparison of a single part.
std::string text_of_part(const data::Comparisons& data, const PartFilter& part) {
  Body body(data, part.graph);
  const std::string values = nodes(body);
  const PartText text =
      std::visit([&](const auto& each) { return decide(body, each); }, part.criterion);
  return values + text.statements + fmt::format("    use({}, {});\n", text.less, text.greater);
}

std::string indented(const std::string& text) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin) + 1;
    result += "  " + text.substr(begin, end - begin);
    begin = end;
  }
  return result;
}

/// The kernel of a comparison of several parts, one block for each. The compiler merges equal
/// operations of the blocks.
std::string text_of_parts(const data::Comparisons& data, const FloatFilter& filter,
                          Combination combination) {
  std::string text =
      "    bool all_less = true, any_less = false, all_greater = true, any_greater = false;\n";
  for (const PartFilter& part : filter.parts) {
    Body body(data, part.graph);
    std::string block = nodes(body);
    const PartText decided =
        std::visit([&](const auto& each) { return decide(body, each); }, part.criterion);
    block += decided.statements;
    block += fmt::format("    all_less &= {0};\n    any_less |= {0};\n", decided.less);
    block += fmt::format("    all_greater &= {0};\n    any_greater |= {0};\n", decided.greater);
    text += "    {\n" + indented(block) + "    }\n";
  }
  const bool all = combination == Combination::all;
  return text + (all ? "    use(all_less, any_greater);\n" : "    use(any_less, all_greater);\n");
}

std::string filter_text(const data::Comparisons& data, const FloatFilter& filter,
                        Combination combination) {
  const bool alone = filter.parts.size() == 1;
  return fmt::format(
      R"(
struct {} {{
  using Real = float;
  static constexpr const char* name = "{}";
{}  const Real* const* columns;
  std::size_t i;

  /// use(less, greater); neither: undecided
  template <class Use>
  void operator()(std::size_t j, Use use) const {{
{}  }}
}};
)",
      filter_type(filter.kind), to_string(filter.kind), checks(filter),
      alone ? text_of_part(data, filter.parts.front()) : text_of_parts(data, filter, combination));
}

std::string header(const scene::Scene& scene) {
  return fmt::format(R"(// The comparison {} in software: the sign of f - g,
//   f = {}
//   g = {}
// Written by mixcmp {}; unencumbered.
// Compile: g++ -std=c++20 -O3 -march=native -ffp-contract=off -fno-math-errno -fno-trapping-math
// -pthread; never -ffast-math.
)",
                     scene.name, scene.f_text(), scene.g_text(), emit::version);
}

std::string_view form_of(data::Pairing pairing) {
  switch (pairing) {
    case data::Pairing::rows: return "rows";
    case data::Pairing::all: return "all_pairs";
    case data::Pairing::cross: return "cross";
    case data::Pairing::arg_min: break;
  }
  MIXCMP_CHECK(false);
}

std::string constants(const data::Comparisons& data) {
  const SoftwareColumns columns = software_columns(data);
  std::string list;
  for (const std::size_t column : columns.of_inputs) list += fmt::format("{}, ", column);
  return fmt::format(R"(enum class Form {{ rows, all_pairs, cross }};
constexpr Form form = Form::{};
constexpr std::size_t file_columns = {};
constexpr std::array<std::size_t, {}> column_of_input = {{{}}};
)",
                     form_of(data.pairing()), columns.inputs.size(), columns.of_inputs.size(),
                     list);
}

std::string_view program_part(const std::string& name) {
  const auto parts = software_program();
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&](const EmbeddedFile& file) { return file.name == name; });
  MIXCMP_CHECK(found != parts.end());
  return found->text;
}

}  // namespace

SoftwareColumns software_columns(const data::Comparisons& data) {
  SoftwareColumns columns;
  const std::vector<data::Comparisons::Source>& sources = data.sources();
  for (std::size_t input = 0; input < sources.size(); ++input) {
    const auto same = [&](std::size_t other) {
      return sources[other].table == sources[input].table &&
             sources[other].column == sources[input].column;
    };
    const auto found = std::find_if(columns.inputs.begin(), columns.inputs.end(), same);
    columns.of_inputs.push_back(static_cast<std::size_t>(found - columns.inputs.begin()));
    if (found == columns.inputs.end()) columns.inputs.push_back(input);
  }
  return columns;
}

bool has_software_loops(data::Pairing pairing) {
  return pairing != data::Pairing::arg_min;
}

std::string software_source(const scene::Scene& scene, const data::Comparisons& data,
                            const FloatFilters& filters) {
  std::string text = header(scene);
  text += program_part("arithmetic.hpp");
  text += "\nnamespace {\n\n" + constants(data) + "\n" + doubles(scene, data);
  std::string list;
  for (const FloatFilter& filter : filters.filters) {
    text += filter_text(data, filter, scene.graph.combination());
    list += (list.empty() ? "" : ", ") + filter_type(filter.kind);
  }
  text += "\nusing Filters = std::tuple<" + list + ">;\n\n}  // namespace\n\n";
  return text + std::string(program_part("harness.hpp"));
}

}  // namespace mixcmp::software

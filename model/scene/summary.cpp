#include "model/scene/summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/expression/text.hpp"
#include "model/golden/arithmetic.hpp"

namespace mixcmp::model {
namespace {

constexpr std::size_t max_expression_length = 60;

std::vector<OperatorCount> count_operators(const TypedGraph& graph) {
  std::vector<OperatorCount> counts;
  for (const TypedNode& node : graph.nodes) {
    if (arity(node.operation) == 0) continue;
    const auto same = [&](const OperatorCount& known) {
      return known.operation == node.operation && known.format == node.format &&
             known.operand_format == node.operand_format;
    };
    const auto known = std::find_if(counts.begin(), counts.end(), same);
    if (known != counts.end()) {
      ++known->count;
    } else {
      counts.push_back({node.operation, node.operand_format, node.format, 1});
    }
  }
  return counts;
}

bool knows(const TypedGraph& graph, Event event) {
  const auto has = [&](Operation operation) {
    return std::any_of(graph.nodes.begin(), graph.nodes.end(),
                       [&](const TypedNode& node) { return node.operation == operation; });
  };
  switch (event) {
    case Event::overflow:
    case Event::underflow: return true;
    case Event::division_by_zero: return has(Operation::divide);
    case Event::root_of_negative: return has(Operation::square_root);
  }
  MIXCMP_CHECK(false);
}

/// Adds one more way in which what is asked may happen: certain ways outweigh those left open.
void add_way(Finding& finding, const TypedGraph& graph, NodeId node, const NodeRange& range) {
  finding.operations.push_back(
      to_text(graph.nodes, graph.input_names, node, max_expression_length));
  for (const int input : range.rangeless_inputs) {
    const std::string& name = graph.input_names[static_cast<std::size_t>(input)];
    const auto known = std::find(finding.rangeless.begin(), finding.rangeless.end(), name);
    if (known == finding.rangeless.end()) finding.rangeless.push_back(name);
  }
  const bool open = !range.rangeless_inputs.empty();
  if (!open) finding.answer = Possibility::possible;
  if (open && finding.answer == Possibility::ruled_out) finding.answer = Possibility::unknown;
}

DatapathSummary summarise_datapath(const std::string& name, const TypedGraph& graph,
                                   const std::vector<std::optional<Range>>& ranges) {
  DatapathSummary summary{
      .name = name, .arithmetic = graph.arithmetic, .operators = count_operators(graph)};
  const std::vector<NodeRange> nodes = analyse_ranges(graph, ranges);
  for (const Event event : all_events) {
    if (!knows(graph, event)) continue;
    Finding& finding = summary.events.emplace_back();
    finding.question = to_string(event);
    for (std::size_t node = 0; node < nodes.size(); ++node) {
      if (nodes[node].may(event)) add_way(finding, graph, static_cast<NodeId>(node), nodes[node]);
    }
  }
  return summary;
}

SideSummary summarise_side(const std::string& name, const std::string& text,
                           const TypedGraph& graph, NodeId root,
                           const std::vector<std::optional<Range>>& ranges) {
  const NodeRange range = analyse_ranges(graph, ranges)[static_cast<std::size_t>(root)];
  SideSummary side{.name = name,
                   .text = text,
                   .value = range.value,
                   .negative = {.question = name + " negative"},
                   .zero = {.question = name + " zero"}};
  if (range.value.low < 0) add_way(side.negative, graph, root, range);
  if (range.value.low <= 0 && range.value.high >= 0) add_way(side.zero, graph, root, range);
  return side;
}

std::string data_source(const DataSpec& data) {
  if (!data.file.empty()) return data.file.filename().string();
  return fmt::format("{} (count {}, side {}, radius_max {}, seed {})", data.items, data.count,
                     data.side, data.radius_max, data.seed);
}

/// Whether table row `row` serves the first or second item of any comparison.
bool takes_part(const Comparisons& data, std::size_t row, bool second) {
  if (!data.pairs()) return true;
  return second ? row > 0 : row + 1 < data.table().rows();
}

bool is_within(const Range& range, FloatFormat format, Bits bits) {
  if (format.is_nan(bits) || format.is_infinite(bits)) return false;
  const mpq_class value = golden::to_rational(format, bits);
  return range.low <= value && value <= range.high;
}

/// The first input whose range the number at (row, column) breaks; -1 if none.
int broken_input(const Scene& scene, const Comparisons& data, std::size_t row, std::size_t column) {
  for (std::size_t input = 0; input < data.sources().size(); ++input) {
    const Comparisons::Source& source = data.sources()[input];
    if (source.column != column || !scene.ranges[input]) continue;
    if (!takes_part(data, row, source.second)) continue;
    if (!is_within(*scene.ranges[input], data.table().format, data.table().at(row, column))) {
      return static_cast<int>(input);
    }
  }
  return -1;
}

DataSummary summarise_data(const Scene& scene, const Comparisons& data) {
  const Table& table = data.table();
  DataSummary summary{.source = scene.data ? data_source(*scene.data) : "",
                      .rows = table.rows(),
                      .comparisons = data.size()};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      const int input = broken_input(scene, data, row, column);
      if (input < 0 || summary.out_of_range++ > 0) continue;
      const Range& range = *scene.ranges[static_cast<std::size_t>(input)];
      const std::string label =
          table.labels.empty() ? fmt::format("row {}", row) : table.labels[row];
      summary.first_out_of_range =
          fmt::format("{}: {} = {} is outside [{}, {}] of {}", label, table.columns[column],
                      golden::to_text(table.format, table.at(row, column)), to_text(range.low),
                      to_text(range.high), scene.graph.inputs()[static_cast<std::size_t>(input)]);
    }
  }
  return summary;
}

}  // namespace

std::string_view to_string(Possibility possibility) {
  switch (possibility) {
    case Possibility::ruled_out: return "ruled out";
    case Possibility::possible: return "possible";
    case Possibility::unknown: return "unknown";
  }
  MIXCMP_CHECK(false);
}

Summary summarise(const Scene& scene, const Comparisons* data) {
  const TypedGraph reference = reference_graph(scene.graph, scene.reference);
  Summary summary{.scene = &scene};
  summary.sides = {
      summarise_side("f", scene.f_text, reference, reference.f, scene.ranges),
      summarise_side("g", scene.g_text, reference, reference.g, scene.ranges),
  };
  summary.datapaths.push_back(summarise_datapath("reference", reference, scene.ranges));
  if (scene.reduced.format) {
    const Arithmetic reduced = {*scene.reduced.format, scene.reduced.rounding,
                                scene.reduced.subnormals};
    const TypedGraph lane =
        lane_graph(scene.graph, scene.reference.format, reduced, scene.reduced.inputs);
    summary.datapaths.push_back(summarise_datapath("lane", lane, scene.ranges));
  }
  if (data != nullptr) summary.data = summarise_data(scene, *data);
  return summary;
}

}  // namespace mixcmp::model

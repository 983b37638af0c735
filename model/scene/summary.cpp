#include "model/scene/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "model/base/number/decimal.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "model/lane/error/exactness.hpp"
#include "model/lane/error/hazards.hpp"
#include "model/scene/reference_model.hpp"

namespace mixcmp::scene {
namespace {

constexpr std::size_t max_expression_length = 60;

std::vector<OperatorCount> count_operators(const TypedGraph& graph) {
  std::vector<OperatorCount> counts;
  for (const TypedNode& node : graph.nodes) {
    if (node.operation == Operation::input || node.operation == Operation::constant) continue;
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

bool knows(const TypedGraph& graph, error::Event event) {
  const auto has = [&](Operation operation) {
    return std::any_of(graph.nodes.begin(), graph.nodes.end(),
                       [&](const TypedNode& node) { return node.operation == operation; });
  };
  switch (event) {
    case error::Event::overflow:
    case error::Event::underflow: return true;
    case error::Event::division_by_zero: return has(Operation::divide);
    case error::Event::root_of_negative: return has(Operation::square_root);
  }
  MIXCMP_CHECK(false);
}

/// Adds an operation in which the event may happen. The answer becomes `possible` if all ranges
/// under the operation are declared. Otherwise it becomes `unknown`, unless it is already
/// `possible`.
void add_way(RangeQuestion& finding, const TypedGraph& graph, NodeId node,
             const error::NodeRange& range) {
  // Two nodes may have the same text: a minimum in two formats, or two long expressions that are
  // cut short.
  const std::string text = to_text(graph.nodes, graph.input_names, node, max_expression_length);
  auto& operations = finding.operations;
  if (std::find(operations.begin(), operations.end(), text) == operations.end()) {
    operations.push_back(text);
  }
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
  const std::vector<error::NodeRange> nodes =
      error::analyse_ranges(graph, ranges, error::Infinities::followed);
  for (const error::Event event : error::all_events) {
    if (!knows(graph, event)) continue;
    RangeQuestion& finding = summary.events.emplace_back();
    finding.question = to_string(event);
    for (std::size_t node = 0; node < nodes.size(); ++node) {
      if (nodes[node].may(event)) add_way(finding, graph, static_cast<NodeId>(node), nodes[node]);
    }
  }
  return summary;
}

SideSummary summarise_side(const std::string& name, const std::string& text,
                           const TypedGraph& graph, NodeId root, const error::NodeRange& range) {
  SideSummary side{.name = name,
                   .text = text,
                   .value = range.value,
                   .negative = {.question = name + " negative"},
                   .zero = {.question = name + " zero"}};
  if (range.value.low < 0) add_way(side.negative, graph, root, range);
  if (range.value.low <= 0 && range.value.high >= 0) add_way(side.zero, graph, root, range);
  return side;
}

std::string data_source(const data::DataSpec& data) {
  if (!data.file.empty()) return data.file.filename().string();
  if (data.items == "sphere_family") {
    return fmt::format("{} \"{}\" (count {}, seed {})", data.items, data.family, data.count,
                       data.seed);
  }
  if (data.items == "uniform") {
    const std::string second =
        data::has_second_table(data.pairing) ? fmt::format(", with_count {}", data.with_count) : "";
    return fmt::format("{} (count {}{}, seed {})", data.items, data.count, second, data.seed);
  }
  return fmt::format("{} (count {}, side {}, radius_max {}, seed {})", data.items, data.count,
                     data.side, data.radius_max, data.seed);
}

bool is_multiple(const mpq_class& grid, FloatFormat format, Bits bits) {
  if (format.is_nan(bits) || format.is_infinite(bits)) return false;
  return mpq_class(to_rational(format, bits) / grid).get_den() == 1;
}

bool is_within(const Range& range, FloatFormat format, Bits bits) {
  if (format.is_nan(bits) || format.is_infinite(bits)) return false;
  const mpq_class value = to_rational(format, bits);
  return range.low <= value && value <= range.high;
}

/// Counts numbers of the data that break a declaration, and describes the first in words.
struct Breaches {
  std::uint64_t count = 0;
  std::string first;

  template <typename Words>
  void add(Words words) {
    if (count++ == 0) first = words();
  }
};

/// Checks each number of the tables against the range and the grid of every input that reads it.
class DataCheck {
public:
  DataCheck(const Scene& scene, const data::Comparisons& data) : scene_(scene), data_(data) {}

  void run() {
    for (std::size_t table = 0; table < data_.tables().size(); ++table) {
      for (std::size_t row = 0; row < data_.tables()[table].rows(); ++row) {
        for (std::size_t column = 0; column < data_.tables()[table].columns.size(); ++column) {
          check_number(table, row, column);
        }
      }
    }
  }

  const Breaches& ranges() const { return ranges_; }
  const Breaches& grids() const { return grids_; }

private:
  void check_number(std::size_t table_index, std::size_t row, std::size_t column) {
    const data::Table& table = data_.tables()[table_index];
    const Bits bits = table.at(row, column);
    bool within = true, on_grid = true;
    for (std::size_t input = 0; input < data_.sources().size(); ++input) {
      const data::Comparisons::Source& source = data_.sources()[input];
      if (source.table != table_index || source.column != column) continue;
      if (!data_.takes_part(source, row)) continue;
      const auto& range = scene_.ranges[input];
      const auto& grid = scene_.grids[input];
      if (within && range && !is_within(*range, table.format, bits)) {
        within = false;
        ranges_.add([&] {
          return fmt::format("{} is outside [{}, {}] of {}", number(table_index, row, column),
                             to_text(range->low), to_text(range->high), name(input));
        });
      }
      if (on_grid && grid && !is_multiple(*grid, table.format, bits)) {
        on_grid = false;
        grids_.add([&] {
          return fmt::format("{} is no multiple of {} as {} is", number(table_index, row, column),
                             to_text(*grid), name(input));
        });
      }
    }
  }

  std::string number(std::size_t table_index, std::size_t row, std::size_t column) const {
    const data::Table& table = data_.tables()[table_index];
    return fmt::format("{}: {} = {}", place(table, row), table.columns[column],
                       to_text(table.format, table.at(row, column)));
  }

  /// "points.csv:7" if rows have lines, else the row's label or its number, counted from 0.
  std::string place(const data::Table& table, std::size_t row) const {
    if (!table.lines.empty()) return fmt::format("{}:{}", table.source, table.lines[row]);
    const std::string label = table.labels.empty() ? fmt::format("row {}", row) : table.labels[row];
    return data_.tables().size() > 1 ? fmt::format("{} {}", table.source, label) : label;
  }

  const std::string& name(std::size_t input) const { return scene_.graph.inputs()[input]; }

  const Scene& scene_;
  const data::Comparisons& data_;
  Breaches ranges_, grids_;
};

DataSummary summarise_data(const Scene& scene, const data::Comparisons& data) {
  DataCheck check(scene, data);
  check.run();
  return {.source = scene.data ? data_source(*scene.data) : "",
          .pairing = data.pairing(),
          .rows = data.table().rows(),
          .with = scene.data && data::has_second_table(scene.data->pairing)
                      ? data::table_name(*scene.data, 1)
                      : "",
          .with_rows = data::has_second_table(data.pairing()) ? data.tables()[1].rows() : 0,
          .comparisons = data.size(),
          .out_of_range = check.ranges().count,
          .first_out_of_range = check.ranges().first,
          .off_grid = check.grids().count,
          .first_off_grid = check.grids().first,
          .lost = data::lost_numbers_of(data),
          .inputs = data::input_sources(data, scene.graph.inputs())};
}

mpq_class least_magnitude(const Range& range) {
  if (range.low <= 0 && range.high >= 0) return 0;
  return std::min<mpq_class>(abs(range.low), abs(range.high));
}

/// Whether a sum has exactly one product and the magnitudes of its terms may add up to less than
/// the smallest normal number.
bool may_be_loose(const TypedNode& sum, const std::vector<error::NodeRange>& ranges) {
  const mpq_class smallest_normal = power_of_two(sum.format.min_exponent());
  mpq_class least = 0;
  for (const FusedTerm& term : sum.terms) {
    const mpq_class a = least_magnitude(ranges[term.a].value);
    least += term.is_product() ? mpq_class(a * least_magnitude(ranges[term.b].value)) : a;
  }
  return least < smallest_normal &&
         std::count_if(sum.terms.begin(), sum.terms.end(),
                       [](const FusedTerm& term) { return term.is_product(); }) == 1;
}

std::string first_loose_sum(const Scene& scene, const TypedGraph& reference) {
  if (reference.arithmetic.subnormals == Subnormals::flush) return {};
  const std::vector<error::NodeRange> ranges =
      analyse_ranges(reference, scene.ranges, error::Infinities::followed);
  for (std::size_t id = 0; id < reference.nodes.size(); ++id) {
    const TypedNode& node = reference.nodes[id];
    const bool is_rounded = node.operation == Operation::fused_sum && !node.is_sign_of_sum();
    if (!is_rounded || !may_be_loose(node, ranges)) continue;
    return to_text(reference.nodes, reference.input_names, static_cast<NodeId>(id),
                   max_expression_length);
  }
  return {};
}

Exactness summarise_exactness(const Scene& scene, const TypedGraph& reference) {
  const std::vector<bool> exact = error::exact_nodes(reference, scene.ranges, scene.grids);
  const auto first = std::find(exact.begin(), exact.end(), false);
  if (first == exact.end()) return {.exact = true};
  return {
      .exact = false,
      .first_rounding = to_text(reference.nodes, reference.input_names,
                                static_cast<NodeId>(first - exact.begin()), max_expression_length),
      .first_loose_sum = first_loose_sum(scene, reference)};
}

void count_saved(LaneSavings& savings, Operation operation, const error::Hazards& hazards) {
  if (!error::has_unit(operation)) return;
  ++savings.operations;
  savings.without_special_operands += hazards.special_operand ? 0 : 1;
  savings.without_overflow += hazards.overflow ? 0 : 1;
  savings.without_underflow += hazards.underflow ? 0 : 1;
  savings.sums += operation == Operation::add || operation == Operation::subtract ? 1 : 0;
  savings.without_cancellation += hazards.cancellation ? 0 : 1;
}

std::optional<LaneSavings> summarise_savings(const Scene& scene, const ReducedSpec& reduced,
                                             const TypedGraph& graph) {
  if (reduced.is_profiled) return std::nullopt;
  const Result<error::Lane> lane = error::certified_lane(
      graph,
      {.kind = reduced.error_bound, .bound_digits = reduced.bound_digits, .ranges = scene.ranges});
  if (!lane.ok()) return std::nullopt;
  LaneSavings savings;
  for (const error::RangeCheck& check : lane->checks) {
    const std::string& name = scene.graph.inputs()[static_cast<std::size_t>(check.input)];
    auto& checked = savings.checked_inputs;
    if (std::find(checked.begin(), checked.end(), name) == checked.end()) checked.push_back(name);
  }
  for (std::size_t id = 0; id < lane->hazards.size(); ++id) {
    count_saved(savings, lane->graph.nodes[id].operation, lane->hazards[id]);
  }
  return savings;
}

DatapathSummary summarise_lane(const std::string& name, const Scene& scene,
                               const ReducedSpec& reduced) {
  const Arithmetic arithmetic = {*reduced.format, reduced.rounding, reduced.subnormals};
  const FloatFormat reference = scene.reference.format;
  const TypedGraph graph =
      lane_graph(scene.graph, reference, arithmetic, reduced.inputs_beside(reference));
  DatapathSummary summary = summarise_datapath(name, graph, scene.ranges);
  summary.savings = summarise_savings(scene, reduced, graph);
  return summary;
}

/// Makes the side of one part, by its name, text and node in the sides' graph.
using MakeSide = std::function<SideSummary(std::string, const std::string&, NodeId)>;

/// The sides of the comparison: f and g of a single part, or f[0], g[0], f[1], ... of several
/// parts.
std::vector<SideSummary> sides_of(const Scene& scene, const std::vector<Sides>& parts,
                                  const MakeSide& make) {
  std::vector<SideSummary> sides;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::string index = parts.size() == 1 ? "" : fmt::format("[{}]", k);
    sides.push_back(make("f" + index, scene.parts[k].f, parts[k].f));
    sides.push_back(make("g" + index, scene.parts[k].g, parts[k].g));
  }
  return sides;
}

/// The sides as a reference in fixed point computes them. All its inputs have ranges.
std::vector<SideSummary> sides_of(const Scene& scene, const fixed::FixedLane& reference) {
  std::vector<Sides> parts;
  for (const fixed::FixedPart& part : reference.parts) {
    const auto [f, g] = reference.nodes[part.difference].operands;
    parts.push_back({f, g});
  }
  return sides_of(scene, parts, [&](std::string name, const std::string& text, NodeId root) {
    const Range& value = reference.nodes[root].value;
    SideSummary side{.name = name,
                     .text = text,
                     .value = value,
                     .negative = {.question = name + " negative"},
                     .zero = {.question = name + " zero"}};
    const auto may = [&](RangeQuestion& finding) {
      finding.answer = Possibility::possible;
      finding.operations = {text};
    };
    if (value.low < 0) may(side.negative);
    if (contains_zero(value)) may(side.zero);
    return side;
  });
}

std::vector<SideSummary> sides_of(const Scene& scene, const TypedGraph& reference) {
  const std::vector<error::NodeRange> ranges =
      error::analyse_ranges(reference, scene.ranges, error::Infinities::followed);
  return sides_of(scene, reference.parts,
                  [&](std::string name, const std::string& text, NodeId root) {
                    return summarise_side(std::move(name), text, reference, root, ranges[root]);
                  });
}

}  // namespace

std::vector<std::string> lane_group_labels(const Scene& scene) {
  if (scene.lane_groups().size() == 1) return {"lane"};
  std::vector<std::string> labels;
  int first = 0;
  for (const LaneGroupSpec& group : scene.lane_groups()) {
    const int next = first + *group.count;
    labels.push_back(next - first == 1 ? fmt::format("lane {}", first)
                                       : fmt::format("lanes {}-{}", first, next - 1));
    first = next;
  }
  return labels;
}

std::string_view to_string(Possibility possibility) {
  switch (possibility) {
    case Possibility::ruled_out: return "ruled out";
    case Possibility::possible: return "possible";
    case Possibility::unknown: return "unknown";
  }
  MIXCMP_CHECK(false);
}

Summary summarise(const Scene& scene, const data::Comparisons* data) {
  Summary summary{.scene = &scene};
  const auto model = reference_model(scene);
  MIXCMP_CHECK(model.ok());  // the scene was checked
  if (const auto* fixed = std::get_if<fixed::FixedLane>(&*model)) {
    summary.sides = sides_of(scene, *fixed);
    summary.reference = {.exact = fixed::is_exact(*fixed)};
  } else {
    const auto& reference = std::get<TypedGraph>(*model);
    summary.sides = sides_of(scene, sides_graph(scene.graph, scene.reference));
    summary.datapaths.push_back(summarise_datapath("reference", reference, scene.ranges));
    summary.reference = summarise_exactness(scene, reference);
  }
  const std::vector<std::string> labels = lane_group_labels(scene);
  const std::vector<LaneGroupSpec> groups = scene.lane_groups();
  for (std::size_t k = 0; k < groups.size(); ++k) {
    if (!groups[k].reduced.format) continue;
    summary.datapaths.push_back(summarise_lane(labels[k], scene, groups[k].reduced));
  }
  if (data != nullptr) summary.data = summarise_data(scene, *data);
  return summary;
}

}  // namespace mixcmp::scene

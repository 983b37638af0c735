#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "model/expression/text.hpp"
#include "model/scene/summary.hpp"

namespace mixcmp::model {
namespace {

constexpr std::size_t max_shown_operations = 3;

std::string shown(const Range& range) {
  return fmt::format("[{}, {}]", to_text(range.low), to_text(range.high));
}

std::string shown(const std::optional<int>& number) {
  return number ? fmt::format("{}", *number) : "auto";
}

std::string shown(const Arithmetic& arithmetic) {
  return fmt::format("{}, {}, {}", arithmetic.format.name(), to_string(arithmetic.rounding),
                     to_string(arithmetic.subnormals));
}

std::string formats_of(const OperatorCount& count) {
  if (count.operand_format == count.format) return count.format.name();
  return fmt::format("{} -> {}", count.operand_format.name(), count.format.name());
}

/// Collects lines "name    text" in sections.
class Page {
public:
  void section(std::string_view title) { append("{}\n", title); }
  void line(std::string_view name, std::string_view text) { append("  {:<18} {}\n", name, text); }
  const std::string& text() const { return text_; }

private:
  template <class... Arguments>
  void append(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
  }

  std::string text_;
};

std::string answer(const Finding& finding, bool with_operations) {
  std::string text(to_string(finding.answer));
  if (finding.answer == Possibility::ruled_out) return text;
  if (!finding.rangeless.empty()) {
    text += fmt::format(": no range for {}", fmt::join(finding.rangeless, ", "));
  }
  if (!with_operations) return text;
  const std::size_t count = std::min(max_shown_operations, finding.operations.size());
  const auto last = finding.operations.begin() + static_cast<long>(count);
  text += fmt::format("; in {}", fmt::join(finding.operations.begin(), last, "; "));
  if (count < finding.operations.size()) {
    text += fmt::format("; and {} more", finding.operations.size() - count);
  }
  return text;
}

std::string_view error_bound_of(const ReducedSpec& reduced) {
  return reduced.error_bound ? to_string(*reduced.error_bound) : "auto";
}

void print_understood(Page& page, const Scene& scene) {
  page.section(fmt::format("scene {}", scene.name));
  page.line("f", scene.f_text);
  page.line("g", scene.g_text);
  page.section("inputs");
  for (std::size_t k = 0; k < scene.ranges.size(); ++k) {
    std::string declared = scene.ranges[k] ? shown(*scene.ranges[k]) : "no range";
    if (scene.grids[k]) declared += fmt::format(", multiples of {}", to_text(*scene.grids[k]));
    page.line(scene.graph.inputs()[k], declared);
  }
  page.section("formats");
  page.line("reference", shown(scene.reference));
  const ReducedSpec& reduced = scene.reduced;
  page.line("reduced", fmt::format("{}, {}, {}, inputs {}, bound {}",
                                   reduced.format ? reduced.format->name() : "auto",
                                   to_string(reduced.rounding), to_string(reduced.subnormals),
                                   to_string(reduced.inputs), to_string(reduced.bound)));
  if (reduced.bound == BoundKind::certified) {
    page.line("error bound", fmt::format("{}, running ones of {} digits", error_bound_of(reduced),
                                         reduced.bound_digits));
  }
  const SystemSpec& system = scene.system;
  page.section("system");
  page.line("device", fmt::format("{}, slack {}", system.device, system.slack));
  page.line("lanes", shown(system.lanes));
  page.line("references", shown(system.references));
  page.line("target_mhz", fmt::format("{}", system.target_mhz));
  page.line("order", to_string(system.order));
  page.line("operands", to_string(system.operands));
  page.line("tag_bits", fmt::format("{}", system.tag_bits));
  page.line("counter_bits", fmt::format("{}", system.counter_bits));
}

void print_data(Page& page, const DataSummary& data) {
  page.section("data");
  page.line("source", data.source);
  page.line("rows", fmt::format("{}", data.rows));
  page.line("comparisons", fmt::format("{}", data.comparisons));
  page.line("out of range", data.out_of_range == 0
                                ? std::string("none")
                                : fmt::format("{} numbers, the first: {}", data.out_of_range,
                                              data.first_out_of_range));
  if (data.off_grid > 0) {
    page.line("off the grid",
              fmt::format("{} numbers, the first: {}", data.off_grid, data.first_off_grid));
  }
}

void print_savings(Page& page, const LaneSavings& savings) {
  const auto left_out = [&](const char* what, int count, int all, const char* units) {
    page.line(what, fmt::format("not built in {} of {} {}", count, all, units));
  };
  const auto& checked = savings.checked_inputs;
  page.section("what a lane leaves out");
  page.line("operands checked",
            checked.empty() ? std::string("none") : fmt::format("{}", fmt::join(checked, ", ")));
  left_out("NaN, infinity", savings.without_special_operands, savings.operations, "operations");
  left_out("overflow", savings.without_overflow, savings.operations, "operations");
  left_out("underflow", savings.without_underflow, savings.operations, "operations");
  left_out("cancellation", savings.without_cancellation, savings.sums, "sums");
}

/// Nobody expects a reference to be exact who has declared no grid.
void print_exactness(Page& page, const Summary& summary) {
  const auto& grids = summary.scene->grids;
  const bool any = std::any_of(grids.begin(), grids.end(), [](const auto& grid) { return !!grid; });
  if (!any) return;
  const bool broken =
      summary.data && (summary.data->off_grid > 0 || summary.data->out_of_range > 0);
  std::string text = "may round, first in " + summary.reference.first_rounding;
  if (summary.reference.exact) {
    text = broken ? "exact, but for data that break a range or a grid"
                  : "exact: its verdicts are the order of the real numbers";
  }
  page.line("reference", text);
}

nlohmann::json json_of(const std::optional<Range>& range) {
  if (!range) return nullptr;
  return {to_text(range->low), to_text(range->high)};
}

nlohmann::json json_of(const Finding& finding) {
  return {{"answer", to_string(finding.answer)},
          {"operations", finding.operations},
          {"inputs_without_range", finding.rangeless}};
}

nlohmann::json json_of(const DatapathSummary& datapath) {
  nlohmann::json operators = nlohmann::json::array();
  for (const OperatorCount& count : datapath.operators) {
    operators.push_back({{"operation", to_string(count.operation)},
                         {"operand_format", count.operand_format.name()},
                         {"format", count.format.name()},
                         {"count", count.count}});
  }
  nlohmann::json events = nlohmann::json::object();
  for (const Finding& finding : datapath.events) events[finding.question] = json_of(finding);
  return {{"format", datapath.arithmetic.format.name()},
          {"rounding", to_string(datapath.arithmetic.rounding)},
          {"subnormals", to_string(datapath.arithmetic.subnormals)},
          {"operators", operators},
          {"events", events}};
}

nlohmann::json json_of(const std::optional<int>& number) {
  if (!number) return "auto";
  return *number;
}

nlohmann::json json_of(const SystemSpec& system) {
  return {{"device", system.device},
          {"lanes", json_of(system.lanes)},
          {"references", json_of(system.references)},
          {"slack", system.slack},
          {"target_mhz", system.target_mhz},
          {"order", to_string(system.order)},
          {"operands", to_string(system.operands)},
          {"tag_bits", system.tag_bits},
          {"counter_bits", system.counter_bits}};
}

nlohmann::json json_of(const DataSummary& data) {
  return {{"source", data.source},
          {"rows", data.rows},
          {"comparisons", data.comparisons},
          {"out_of_range", data.out_of_range},
          {"first_out_of_range", data.first_out_of_range},
          {"off_grid", data.off_grid},
          {"first_off_grid", data.first_off_grid}};
}

nlohmann::json json_of(const LaneSavings& savings) {
  return {{"checked_inputs", savings.checked_inputs},
          {"operations", savings.operations},
          {"without_special_operands", savings.without_special_operands},
          {"without_overflow", savings.without_overflow},
          {"without_underflow", savings.without_underflow},
          {"sums", savings.sums},
          {"without_cancellation", savings.without_cancellation}};
}

nlohmann::json json_of(const ReducedSpec& reduced) {
  return {{"format", reduced.format ? reduced.format->name() : "auto"},
          {"rounding", to_string(reduced.rounding)},
          {"subnormals", to_string(reduced.subnormals)},
          {"bound", to_string(reduced.bound)},
          {"error_bound", error_bound_of(reduced)},
          {"bound_digits", reduced.bound_digits},
          {"inputs", to_string(reduced.inputs)}};
}

}  // namespace

std::string to_text(const Summary& summary) {
  Page page;
  print_understood(page, *summary.scene);
  for (const DatapathSummary& datapath : summary.datapaths) {
    page.section(
        fmt::format("operators of {} {}", datapath.name == "lane" ? "a" : "the", datapath.name));
    for (const OperatorCount& count : datapath.operators) {
      page.line(fmt::format("{} {}", count.count, to_string(count.operation)), formats_of(count));
    }
  }
  page.section("what the ranges rule out");
  for (const SideSummary& side : summary.sides) {
    page.line(side.name + " within", shown(side.value));
    page.line(side.negative.question, answer(side.negative, false));
    page.line(side.zero.question, answer(side.zero, false));
  }
  for (const DatapathSummary& datapath : summary.datapaths) {
    for (const Finding& event : datapath.events) {
      page.line(fmt::format("{} {}", datapath.name, event.question), answer(event, true));
    }
  }
  print_exactness(page, summary);
  if (summary.savings) print_savings(page, *summary.savings);
  if (summary.data) print_data(page, *summary.data);
  if (!summary.scene->notes.empty()) page.section("notes");
  for (const std::string& note : summary.scene->notes) page.line("-", note);
  return page.text();
}

nlohmann::json to_json(const Summary& summary) {
  const Scene& scene = *summary.scene;
  nlohmann::json json = {{"name", scene.name},
                         {"system", json_of(scene.system)},
                         {"reduced", json_of(scene.reduced)},
                         {"notes", scene.notes}};
  for (std::size_t k = 0; k < scene.ranges.size(); ++k) {
    json["inputs"].push_back(
        {{"name", scene.graph.inputs()[k]}, {"range", json_of(scene.ranges[k])}});
  }
  for (const SideSummary& side : summary.sides) {
    json[side.name] = {{"text", side.text},
                       {"within", json_of(side.value)},
                       {"negative", json_of(side.negative)},
                       {"zero", json_of(side.zero)}};
  }
  for (const DatapathSummary& datapath : summary.datapaths) {
    json["datapaths"][datapath.name] = json_of(datapath);
  }
  json["reference_exact"] = summary.reference.exact;
  if (!summary.reference.exact) json["first_rounding"] = summary.reference.first_rounding;
  json["lane_leaves_out"] = summary.savings ? json_of(*summary.savings) : nlohmann::json();
  json["data"] = summary.data ? json_of(*summary.data) : nlohmann::json();
  return json;
}

}  // namespace mixcmp::model

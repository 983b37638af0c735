#include "generator/present/report/paper_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "generator/present/report/units.hpp"

namespace mixcmp::report {

using measured::Measurement;
using optimise::Exploration;
using optimise::PlanSummary;
using optimise::PublishedFigures;
using optimise::ReferenceImplementation;
using optimise::ResultsAtClocks;

namespace {

constexpr const char* nothing = "-";

/// "87-108", or "87" where both ends print alike.
std::string range_text(double low, double high, const char* format) {
  const std::string from = fmt::format(fmt::runtime(format), low);
  const std::string to = fmt::format(fmt::runtime(format), high);
  return from == to ? from : from + "-" + to;
}

/// The range of a value over plans.
std::string range_of(const std::vector<PlanSummary>& plans,
                     const std::function<double(const PlanSummary&)>& value, const char* format) {
  std::vector<double> values;
  for (const PlanSummary& plan : plans) values.push_back(value(plan));
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return range_text(*low, *high, format);
}

/// One line of Table IV: its name, the cell of the paper, and the cell of each column of ours.
struct TableLine {
  std::string name;
  std::function<std::string(const PublishedFigures&)> of_paper;
  std::function<std::string(const ResultsAtClocks&)> of_column;
};

void add_line(table::Table& table, const Exploration& exploration,
              const std::optional<PublishedFigures>& published, const TableLine& line) {
  std::vector<table::Json> cells = {line.name};
  if (published) cells.push_back(line.of_paper(*published));
  for (const ResultsAtClocks& column : exploration.columns) cells.push_back(line.of_column(column));
  table.rows.push_back({std::move(cells)});
}

std::string giga_text(double per_s) {
  return fmt::format("{:.3g}", per_s / giga);
}

std::string speedups(double low, double high, double worst, double baseline) {
  return fmt::format("I {}x, II {:.3g}x, references alone {:.3g}x", range_text(low, high, "{:.3g}"),
                     worst, baseline);
}

using OfPaper = std::function<std::string(const PublishedFigures&)>;

/// Throughputs of scenarios I and II and of the baseline, each divided by `unit`.
TableLine ratio_line(std::string name, double unit, OfPaper of_paper) {
  return {std::move(name), std::move(of_paper), [=](const ResultsAtClocks& c) {
            double low = c.scenario_1.front().throughput_per_s, high = low;
            for (const PlanSummary& plan : c.scenario_1) {
              low = std::min(low, plan.throughput_per_s);
              high = std::max(high, plan.throughput_per_s);
            }
            return speedups(low / unit, high / unit, summary_of(c.worst).throughput_per_s / unit,
                            c.baseline_per_s / unit);
          }};
}

std::vector<TableLine> baseline_lines() {
  return {
      {"references alone: p_H",
       [](const PublishedFigures& p) { return fmt::format("{}", p.baseline_references); },
       [](const ResultsAtClocks& c) { return fmt::format("{}", c.baseline_references); }},
      {"references alone, G/s",
       [](const PublishedFigures& p) { return giga_text(p.baseline_per_s); },
       [](const ResultsAtClocks& c) { return giga_text(c.baseline_per_s); }},
  };
}

/// The lines of scenario I, which has a plan for each data set.
std::vector<TableLine> scenario_1_lines() {
  const auto throughput = [](const PlanSummary& s) { return s.throughput_per_s / giga; };
  const auto lanes = [](const PlanSummary& s) { return static_cast<double>(s.lanes); };
  const auto references = [](const PlanSummary& s) { return static_cast<double>(s.references); };
  const auto precision = [](const PlanSummary& s) { return static_cast<double>(s.precision); };
  const auto clock = [](const PlanSummary& s) { return s.clock_mhz; };
  return {
      {"scenario I: L", [](const PublishedFigures&) { return nothing; },
       [=](const ResultsAtClocks& c) { return range_of(c.scenario_1, precision, "{:.0f}"); }},
      {"scenario I: p_L",
       [](const PublishedFigures& p) { return range_text(p.lanes_worst, p.lanes_best, "{:.0f}"); },
       [=](const ResultsAtClocks& c) { return range_of(c.scenario_1, lanes, "{:.0f}"); }},
      {"scenario I: p_H",
       [](const PublishedFigures& p) {
         return range_text(p.references_best, p.references_worst, "{:.0f}");
       },
       [=](const ResultsAtClocks& c) { return range_of(c.scenario_1, references, "{:.0f}"); }},
      {"clock, MHz (ours: of lanes, scenario I)",
       [](const PublishedFigures& p) {
         return range_text(p.lane_mhz_low, p.lane_mhz_high, "{:.0f}");
       },
       [=](const ResultsAtClocks& c) { return range_of(c.scenario_1, clock, "{:.0f}"); }},
      {"scenario I: T(equ), G/s",
       [](const PublishedFigures& p) {
         return range_text(p.worst_per_s / giga, p.best_per_s / giga, "{:.3g}");
       },
       [=](const ResultsAtClocks& c) { return range_of(c.scenario_1, throughput, "{:.3g}"); }},
      {"scenario I: gain over references alone",
       [](const PublishedFigures& p) {
         return range_text(p.gain_worst, p.gain_best, "{:.3g}") + "x";
       },
       [=](const ResultsAtClocks& c) {
         return range_of(
             c.scenario_1,
             [&c](const PlanSummary& s) {
               return c.baseline_per_s > 0 ? s.throughput_per_s / c.baseline_per_s : 0;
             },
             "{:.3g}x");
       }},
  };
}

/// The lines of scenario II, which has one plan for the worst of all data sets.
std::vector<TableLine> scenario_2_lines() {
  return {
      {"scenario II: L", [](const PublishedFigures&) { return nothing; },
       [](const ResultsAtClocks& c) { return fmt::format("{}", summary_of(c.worst).precision); }},
      {"scenario II: p_L x p_H",
       [](const PublishedFigures& p) {
         return fmt::format("{} x {}", p.lanes_worst, p.references_worst);
       },
       [](const ResultsAtClocks& c) {
         const PlanSummary s = summary_of(c.worst);
         return fmt::format("{} x {}", s.lanes, s.references);
       }},
      {"scenario II: T(equ), G/s",
       [](const PublishedFigures& p) { return giga_text(p.worst_per_s); },
       [](const ResultsAtClocks& c) { return giga_text(summary_of(c.worst).throughput_per_s); }},
      {"scenario II: gain over references alone",
       [](const PublishedFigures& p) { return fmt::format("{:.3g}x", p.gain_worst); },
       [](const ResultsAtClocks& c) {
         if (c.baseline_per_s == 0) return std::string("no reference fits");
         return fmt::format("{:.3g}x", summary_of(c.worst).throughput_per_s / c.baseline_per_s);
       }},
  };
}

std::vector<std::string> headers(const Exploration& exploration, bool with_paper) {
  std::vector<std::string> cells = {exploration.device.name};
  if (with_paper) cells.push_back("the paper");
  for (const ResultsAtClocks& column : exploration.columns) cells.push_back(column.title);
  return cells;
}

}  // namespace

table::Table table3(const Exploration& exploration,
                    const std::optional<PublishedFigures>& published) {
  table::Table table = table::text_table(
      {exploration.device.name, "LUT", "registers", "DSP", "latency, cycles", "MHz"});
  if (published) {
    table.rows.push_back(
        {{"the paper, placed and routed", fmt::format("{} pairs", published->reference_luts),
          nothing, published->reference_dsps, nothing,
          fmt::format("{:.0f}", published->reference_mhz)}});
  }
  for (const ReferenceImplementation& reference : exploration.columns.front().example.references) {
    const Measurement& m = reference.measured;
    table.rows.push_back(
        {{reference.kind.name, m.area.luts, m.area.registers, m.area.dsps, m.latency_cycles,
          m.clock ? fmt::format("{:.0f}, {}", m.clock->mhz, to_string(m.clock->source))
                  : nothing}});
  }
  return table;
}

table::Table table4(const Exploration& exploration,
                    const std::optional<PublishedFigures>& published,
                    const std::vector<SoftwareThroughput>& software) {
  table::Table table = table::text_table(headers(exploration, published.has_value()));
  for (const auto& lines : {baseline_lines(), scenario_1_lines(), scenario_2_lines()}) {
    for (const TableLine& line : lines) add_line(table, exploration, published, line);
  }
  if (published) {
    add_line(table, exploration, published,
             ratio_line(fmt::format("over {}, {} cores, {:.3g} G/s (the paper's)", published->cpu,
                                    published->cpu_cores, published->cpu_per_s / giga),
                        published->cpu_per_s, [](const PublishedFigures& p) {
                          return speedups(p.speedup_worst, p.speedup_best, p.speedup_worst,
                                          p.speedup_baseline);
                        }));
  }
  for (const SoftwareThroughput& cpu : software) {
    const std::string name =
        fmt::format("over {}: all cores {:.3g} G/s, one core {:.3g} G/s (measured here)", cpu.title,
                    cpu.all_cores_per_s / giga, cpu.one_core_per_s / giga);
    add_line(table, exploration, published,
             ratio_line(name, cpu.all_cores_per_s, [&](const PublishedFigures& p) {
               const double unit = cpu.all_cores_per_s;
               return speedups(p.worst_per_s / unit, p.best_per_s / unit, p.worst_per_s / unit,
                               p.baseline_per_s / unit);
             }));
  }
  return table;
}

}  // namespace mixcmp::report

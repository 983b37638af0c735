#include "generator/schematic/pipeline_maker.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/expression/text.hpp"

namespace mixcmp::schematic {
namespace {

void add_line(std::string& text, const std::string& line) {
  if (line.empty()) return;
  if (!text.empty()) text += '\n';
  text += line;
}

/// The word of an operation, as a reader would call its unit.
std::string word_of(Operation operation) {
  std::string word(to_string(operation));
  std::replace(word.begin(), word.end(), '_', ' ');
  return word;
}

}  // namespace

int PipelineMaker::add_input(const std::string& name, const std::string& format) {
  return add({.title = name, .format = format, .meaning = "operand", .role = page::UnitRole::input},
             {}, {});
}

int PipelineMaker::add(const Box& box, const datapath::Step& step,
                       const std::vector<int>& operands) {
  const int cycles = step.ready_cycle - step.start_cycle;
  page::PipelineUnit unit{.title = box.title,
                          .detail = box.format,
                          .tip = box.title,
                          .role = box.role,
                          .start_cycle = step.start_cycle,
                          .ready_cycle = step.ready_cycle,
                          .operands = {}};
  if (cycles > 1) {
    unit.detail += fmt::format("{}{} cycles", unit.detail.empty() ? "" : ", ", cycles);
  }
  if (box.meaning != box.title) add_line(unit.tip, box.meaning);
  add_line(unit.tip, box.format);
  if (!step.unit.module.empty()) {
    add_line(unit.tip, fmt::format("{}, cycles {} to {}", step.unit.module, step.start_cycle,
                                   step.ready_cycle));
  }
  for (const int operand : operands) {
    const bool known =
        std::find(unit.operands.begin(), unit.operands.end(), operand) != unit.operands.end();
    if (operand != none && !known) unit.operands.push_back(operand);
  }
  pipeline_.units.push_back(std::move(unit));
  return static_cast<int>(pipeline_.units.size()) - 1;
}

page::Pipeline PipelineMaker::finish(const std::string& title, const datapath::Schedule& schedule,
                                     const std::vector<int>& decisions, Combination combination) {
  if (!schedule.combination.unit.module.empty()) {
    add({.title = fmt::format("combine: {}", to_string(combination)),
         .format = "verdict",
         .meaning = "the verdict of all parts",
         .role = page::UnitRole::decision},
        schedule.combination, decisions);
  }
  pipeline_.title = title;
  pipeline_.cycles = schedule.latency_cycles;
  return std::move(pipeline_);
}

std::string title_of(const std::vector<TypedNode>& nodes, const std::vector<std::string>& inputs,
                     NodeId node) {
  constexpr std::size_t most_letters = 16;
  const Operation operation = nodes[node].operation;
  if (operation == Operation::convert) return "round";
  const std::string expression = meaning_of(nodes, inputs, node);
  return expression.size() <= most_letters ? expression : word_of(operation);
}

std::string meaning_of(const std::vector<TypedNode>& nodes, const std::vector<std::string>& inputs,
                       NodeId node) {
  constexpr std::size_t most_letters = 300;
  return expression::to_text(nodes, inputs, node, most_letters);
}

std::string decision_title(std::size_t part, std::size_t parts) {
  return parts == 1 ? "decide" : fmt::format("decide part {}", part);
}

}  // namespace mixcmp::schematic

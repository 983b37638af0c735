#include "generator/present/schematic/pipeline_maker.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/comparison/expression/text.hpp"

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

std::string PipelineMaker::title_of(NodeId node) const {
  constexpr std::size_t most_letters = 16;
  const Operation operation = nodes_[node].operation;
  if (operation == Operation::convert) return "round";
  const std::string expression = meaning_of(node);
  return expression.size() <= most_letters ? expression : word_of(operation);
}

std::string PipelineMaker::meaning_of(NodeId node) const {
  constexpr std::size_t most_letters = 300;
  return expression::to_text(nodes_, inputs_, node, most_letters);
}

int PipelineMaker::add_input(int input, const std::string& format) {
  return add({.title = name_of(input),
              .format = format,
              .meaning = "operand",
              .role = page::UnitRole::input},
             {}, {});
}

void PipelineMaker::add_node(const std::string& title, const std::string& format,
                             const std::vector<int>& operands) {
  const auto id = static_cast<NodeId>(boxes_.size());
  add_node(add({.title = title, .format = format, .meaning = meaning_of(id)},
               schedule_.steps[boxes_.size()], operands));
}

void PipelineMaker::add_decision(const std::string& format, const std::string& meaning,
                                 const std::vector<int>& operands) {
  const std::size_t part = decisions_.size();
  const bool alone = schedule_.parts.size() == 1;
  decisions_.push_back(add({.title = alone ? "decide" : fmt::format("decide part {}", part),
                            .format = format,
                            .meaning = meaning,
                            .role = page::UnitRole::decision},
                           schedule_.parts[part].decision, operands));
}

std::vector<int> PipelineMaker::read_by(const datapath::Step& step) const {
  std::vector<int> found;
  for (const NodeId node : step.reads) found.push_back(boxes_[static_cast<std::size_t>(node)]);
  return found;
}

int PipelineMaker::add(const Box& box, const datapath::Step& step,
                       const std::vector<int>& operands) {
  const int cycles = step.ready_cycle - step.start_cycle;
  const int entry = box.role == page::UnitRole::input ? 0 : schedule_.entry_cycles;
  page::PipelineUnit unit{.title = box.title,
                          .detail = box.format,
                          .tip = box.title,
                          .role = box.role,
                          .start_cycle = entry + step.start_cycle,
                          .ready_cycle = entry + step.ready_cycle,
                          .operands = {}};
  if (cycles > 1) {
    unit.detail += fmt::format("{}{} cycles", unit.detail.empty() ? "" : ", ", cycles);
  }
  if (box.meaning != box.title) add_line(unit.tip, box.meaning);
  add_line(unit.tip, box.format);
  if (!step.unit.module.empty()) {
    add_line(unit.tip, fmt::format("{}, cycles {} to {}", step.unit.module, unit.start_cycle,
                                   unit.ready_cycle));
  }
  for (const int operand : operands) {
    const bool known =
        std::find(unit.operands.begin(), unit.operands.end(), operand) != unit.operands.end();
    if (operand != none && !known) unit.operands.push_back(operand);
  }
  pipeline_.units.push_back(std::move(unit));
  return static_cast<int>(pipeline_.units.size()) - 1;
}

page::Pipeline PipelineMaker::finish(const std::string& title, Combination combination) {
  if (!schedule_.combination.unit.module.empty()) {
    add({.title = fmt::format("combine: {}", to_string(combination)),
         .format = "verdict",
         .meaning = "the verdict of all parts",
         .role = page::UnitRole::decision},
        schedule_.combination, decisions_);
  }
  pipeline_.title = title;
  pipeline_.cycles = schedule_.latency_cycles;
  return std::move(pipeline_);
}

}  // namespace mixcmp::schematic

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "generator/faces/api/operands.hpp"
#include "generator/faces/api/state.hpp"
#include "generator/tasks/generate.hpp"
#include "model/base/common/quote.hpp"
#include "verilator_tb/answer_emulator.hpp"
#include "verilator_tb/judgement.hpp"

namespace mixcmp::api {

struct System::State {
  State(design::Design made, emit::GeneratedSystem system)
      : design(std::move(made)), generated(std::move(system)), emulator(design) {}

  design::Design design;
  emit::GeneratedSystem generated;
  verilator_tb::AnswerEmulator emulator;
  std::vector<LaneGroup> lanes;
  std::vector<File> files;

  OperandRows operands(std::span<const double> rows, std::size_t group) const {
    if (group < lanes.size()) {
      return value_or_throw(OperandRows::make(rows, design.inputs, design.reference.input_format,
                                              design.formats_of_inputs()));
    }
    fail({.field = "group",
          .message = "there is no such group of lanes",
          .received = std::to_string(group),
          .accepted = fmt::format("0 to {}", lanes.size() - 1)});
  }
};

namespace {

std::vector<LaneGroup> groups_of(const emit::Signature& signature) {
  std::vector<LaneGroup> groups;
  for (const emit::SignatureLanes& lanes : signature.lane_groups) {
    groups.push_back({.format = lanes.format,
                      .count = lanes.count,
                      .latency_cycles = lanes.latency_cycles,
                      .certified = lanes.certified,
                      .decision = lanes.decision});
  }
  return groups;
}

std::vector<File> files_of(const emit::GeneratedSystem& generated) {
  std::vector<File> files;
  for (const emit::GeneratedFile& file : generated.files) files.push_back({file.name, file.text});
  return files;
}

Answer answer_of(ResultWord word) {
  return Answer(static_cast<std::uint8_t>(word.bits()));
}

/// Copies rows into the batch's columns.
void fill(data::OperandBlock& block, const OperandRows& rows, std::size_t first, std::size_t count,
          std::size_t inputs) {
  block.resize(count);
  for (std::size_t input = 0; input < inputs; ++input) {
    double* const column = block.column(input);
    for (std::size_t k = 0; k < count; ++k) column[k] = rows.value(first + k, input);
  }
}

}  // namespace

System::System(const Scene& scene) {
  const SceneState& given = Access::state(scene);
  auto [design, generated] = value_or_throw(tasks::generate(given.request, given.loaded));
  auto state = std::make_shared<State>(std::move(design), std::move(generated));
  state->lanes = groups_of(state->generated.signature);
  state->files = files_of(state->generated);
  state_ = std::move(state);
}

System::System(const System&) = default;
System& System::operator=(const System&) = default;
System::System(System&&) noexcept = default;
System& System::operator=(System&&) noexcept = default;
System::~System() = default;

const std::string& System::top() const {
  return state_->generated.signature.top;
}

bool System::certified() const {
  return state_->generated.signature.certified;
}

int System::lane_count() const {
  return state_->generated.signature.lanes;
}

int System::reference_count() const {
  return state_->generated.signature.references;
}

const std::vector<LaneGroup>& System::lanes() const {
  return state_->lanes;
}

const std::vector<std::string>& System::notes() const {
  return state_->generated.notes;
}

std::vector<Answer> System::emulate(std::span<const double> rows, std::size_t group) const {
  using verilator_tb::AnswerEmulator;
  const OperandRows operands = state_->operands(rows, group);
  const std::size_t inputs = state_->design.inputs.size();
  AnswerEmulator::Batch batch(inputs);
  std::vector<ResultWord> words(AnswerEmulator::batch_size, ResultWord::undecided());
  std::vector<Answer> answers;
  answers.reserve(operands.rows());
  for (std::size_t first = 0; first < operands.rows(); first += words.size()) {
    const std::size_t count = std::min(words.size(), operands.rows() - first);
    fill(batch.operands, operands, first, count, inputs);
    state_->emulator.find(group, batch, std::span(words).first(count));
    std::transform(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(count),
                   std::back_inserter(answers), answer_of);
  }
  return answers;
}

std::vector<Answer> System::evaluate(std::span<const double> rows, std::size_t group) const {
  const OperandRows operands = state_->operands(rows, group);
  std::vector<Bits> bits(state_->design.inputs.size());
  std::vector<Answer> answers;
  answers.reserve(operands.rows());
  for (std::size_t row = 0; row < operands.rows(); ++row) {
    operands.fetch(row, bits);
    answers.push_back(answer_of(verilator_tb::expected_word(state_->design, group, bits)));
  }
  return answers;
}

const std::vector<File>& System::files() const {
  return state_->files;
}

void System::write(const std::filesystem::path& folder) const {
  if (folder.empty()) {
    fail({.field = "folder",
          .message = "a folder without a name",
          .received = in_quotes(""),
          .accepted = "the path of a folder"});
  }
  value_or_throw(emit::write_system(state_->generated, folder));
}

}  // namespace mixcmp::api

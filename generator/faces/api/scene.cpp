#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "generator/faces/api/operands.hpp"
#include "generator/faces/api/state.hpp"
#include "generator/hardware/emit/version.hpp"
#include "generator/present/report/json_text.hpp"
#include "generator/present/report/summary_report.hpp"
#include "model/base/number/double.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/scene/summary.hpp"

namespace mixcmp::api {
namespace {

SceneState load(tasks::SceneRequest request) {
  auto loaded = value_or_throw(tasks::load(request));
  if (auto note = tasks::lost_numbers_note(loaded)) loaded.scene.notes.push_back(std::move(*note));
  return {std::move(request), std::move(loaded)};
}

OperandRows rows_of(const SceneState& state, std::span<const double> numbers) {
  return value_or_throw(OperandRows::make(numbers, state.loaded.scene.graph.inputs(),
                                          state.loaded.scene.reference.format,
                                          state.loaded.scene.operand_formats));
}

/// Tells whether a double, taken as an operand, gives this number of the format again. All NaNs
/// count as one number.
bool is_same(FloatFormat format, Bits bits, double value) {
  if (format.is_nan(bits)) return true;
  const auto operand = nearest_operand(format, value);
  return operand && operand->bits == bits;
}

}  // namespace

std::string version() {
  return std::string(emit::version);
}

std::string_view to_string(Verdict verdict) {
  return mixcmp::to_string(static_cast<mixcmp::Verdict>(verdict));
}

const data::Comparisons& data_of(const SceneState& state, std::string_view why) {
  const auto there = tasks::check_has_data(state.loaded, std::string(why));
  if (there.ok()) return *state.loaded.data;
  mixcmp::Error error = there.error();
  error.accepted += ", or with_operands";
  fail(error);
}

Scene::Scene(std::shared_ptr<const SceneState> state) : state_(std::move(state)) {}
Scene::Scene(const Scene&) = default;
Scene& Scene::operator=(const Scene&) = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

Scene Scene::from_file(const std::filesystem::path& file,
                       const std::vector<std::string>& settings) {
  return Access::make(load({file, settings}));
}

Scene Scene::from_text(std::string_view toml, const std::vector<std::string>& settings,
                       const std::filesystem::path& folder) {
  return Access::make(load({{folder / "(text)", std::string(toml)}, settings}));
}

Scene Scene::with_operands(std::span<const double> rows) const {
  const OperandRows operands = rows_of(*state_, rows);
  if (operands.rows() == 0) {
    fail({.field = "operands",
          .message = "nothing to compare",
          .received = "0 rows",
          .accepted = "at least one"});
  }
  const std::size_t width = inputs().size();
  data::Table table{.format = state_->loaded.scene.reference.format,
                    .columns = inputs(),
                    .values = std::vector<Bits>(operands.rows() * width),
                    .source = "operands"};
  for (std::size_t row = 0; row < operands.rows(); ++row) {
    operands.fetch(row, std::span(table.values).subspan(row * width, width));
  }
  SceneState state = *state_;
  state.loaded.data = value_or_throw(data::Comparisons::rows(std::move(table), inputs()));
  state.loaded.scene.data.reset();
  return Access::make(std::move(state));
}

const std::string& Scene::name() const {
  return state_->loaded.scene.name;
}

const std::vector<std::string>& Scene::inputs() const {
  return state_->loaded.scene.graph.inputs();
}

std::string Scene::f() const {
  return state_->loaded.scene.f_text();
}

std::string Scene::g() const {
  return state_->loaded.scene.g_text();
}

std::string Scene::reference_format() const {
  return state_->loaded.scene.reference.format.name();
}

std::string Scene::reduced_format() const {
  return state_->loaded.scene.reduced.format_name();
}

const std::vector<std::string>& Scene::notes() const {
  return state_->loaded.scene.notes;
}

std::uint64_t Scene::comparison_count() const {
  return state_->loaded.data ? state_->loaded.data->size() : 0;
}

std::vector<double> Scene::operands(std::uint64_t first, std::size_t count) const {
  const data::Comparisons& data = data_of(*state_, "there are no operands");
  if (first > data.size() || count > data.size() - first) {
    fail({.field = "operands",
          .message = "there are fewer comparisons",
          .received = fmt::format("{} from number {} on", count, first),
          .accepted = fmt::format("at most {} in all", data.size())});
  }
  const std::size_t width = inputs().size();
  std::vector<Bits> bits(width);
  std::vector<double> rows;
  rows.reserve(count * width);
  for (std::size_t k = 0; k < count; ++k) {
    data.fetch(first + k, bits);
    for (std::size_t input = 0; input < width; ++input) {
      rows.push_back(to_double(data.format(), bits[input]));
      if (is_same(data.format(), bits[input], rows.back())) continue;
      fail({.field = fmt::format("operands, row {}, {}", k, inputs()[input]),
            .message = "double does not hold the number",
            .received = "a number of " + data.format().name(),
            .accepted = "data of at most 53 digits and 11 exponent bits"});
    }
  }
  return rows;
}

std::vector<std::optional<Verdict>> Scene::true_verdicts(std::span<const double> rows) const {
  const OperandRows operands = rows_of(*state_, rows);
  std::vector<Bits> bits(inputs().size());
  std::vector<std::optional<Verdict>> verdicts(operands.rows());
  for (std::size_t row = 0; row < operands.rows(); ++row) {
    operands.fetch(row, bits);
    const auto truth = golden::true_verdict(state_->loaded.scene.graph,
                                            state_->loaded.scene.reference.format, bits);
    if (truth) verdicts[row] = static_cast<Verdict>(*truth);
  }
  return verdicts;
}

std::string Scene::summary() const {
  return report::to_text(scene::summarise(state_->loaded.scene, state_->loaded.data_if_any()));
}

std::string Scene::summary_json() const {
  const scene::Summary summary =
      scene::summarise(state_->loaded.scene, state_->loaded.data_if_any());
  return report::json_text(nlohmann::ordered_json(report::to_json(summary)));
}

}  // namespace mixcmp::api

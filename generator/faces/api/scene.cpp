#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "generator/faces/api/operands.hpp"
#include "generator/faces/api/state.hpp"
#include "generator/hardware/datapath/delays.hpp"
#include "generator/hardware/emit/version.hpp"
#include "generator/present/report/json_text.hpp"
#include "generator/present/report/summary_report.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/number/double.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/judge/workload/load_comparisons.hpp"
#include "model/scene/error_location.hpp"
#include "model/scene/summary.hpp"

namespace mixcmp::api {
namespace {

SceneState load(scene::SceneSource source, std::vector<std::string> settings) {
  auto read = scene::load_scene(source, settings);
  if (!read.ok()) fail(scene::with_location(read.error(), source, settings));
  SceneState state{std::move(source), std::move(settings), std::move(read).value(), {}};
  value_or_throw(datapath::delays_of(state.scene.system.device), state);
  if (state.scene.data) state.data = value_or_throw(workload::load_comparisons(state.scene), state);
  return state;
}

OperandRows rows_of(const SceneState& state, std::span<const double> numbers) {
  return value_or_throw(
      OperandRows::make(numbers, state.scene.graph.inputs(), state.scene.reference.format));
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

const data::Comparisons& data_of(const SceneState& state, const std::string& why) {
  if (state.data) return *state.data;
  fail({.file = state.scene.path.string(),
        .field = "data",
        .message = why,
        .received = "a scene without data",
        .accepted = "[data] with items or file, or with_operands"});
}

std::string origin(const std::string& verb, const SceneState& state) {
  const bool from_text = state.source.text.has_value();
  std::string line = from_text
                         ? "the library of mixcmp, of a scene from a text"
                         : "mixcmp " + verb + " " + quoted(state.source.path.filename().string());
  for (const std::string& setting : state.settings) line += " --set " + quoted(setting);
  return line;
}

Scene::Scene(std::shared_ptr<const SceneState> state) : state_(std::move(state)) {}
Scene::Scene(const Scene&) = default;
Scene& Scene::operator=(const Scene&) = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

Scene Scene::from_file(const std::filesystem::path& file,
                       const std::vector<std::string>& settings) {
  return Access::make(load(file, settings));
}

Scene Scene::from_text(std::string_view toml, const std::vector<std::string>& settings,
                       const std::filesystem::path& folder) {
  return Access::make(load({folder / "(text)", std::string(toml)}, settings));
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
  data::Table table{.format = state_->scene.reference.format,
                    .columns = inputs(),
                    .values = std::vector<Bits>(operands.rows() * width),
                    .source = "operands"};
  for (std::size_t row = 0; row < operands.rows(); ++row) {
    operands.fetch(row, std::span(table.values).subspan(row * width, width));
  }
  SceneState state = *state_;
  state.data = value_or_throw(data::Comparisons::rows(std::move(table), inputs()));
  state.scene.data.reset();
  return Access::make(std::move(state));
}

const std::string& Scene::name() const {
  return state_->scene.name;
}

const std::vector<std::string>& Scene::inputs() const {
  return state_->scene.graph.inputs();
}

std::string Scene::f() const {
  return state_->scene.f_text();
}

std::string Scene::g() const {
  return state_->scene.g_text();
}

std::string Scene::reference_format() const {
  return state_->scene.reference.format.name();
}

std::string Scene::reduced_format() const {
  return state_->scene.reduced.format_name();
}

const std::vector<std::string>& Scene::notes() const {
  return state_->scene.notes;
}

std::uint64_t Scene::comparison_count() const {
  return state_->data ? state_->data->size() : 0;
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
    const auto truth =
        golden::true_verdict(state_->scene.graph, state_->scene.reference.format, bits);
    if (truth) verdicts[row] = static_cast<Verdict>(*truth);
  }
  return verdicts;
}

std::string Scene::summary() const {
  return report::to_text(scene::summarise(state_->scene, state_->data ? &*state_->data : nullptr));
}

std::string Scene::summary_json() const {
  const scene::Summary summary =
      scene::summarise(state_->scene, state_->data ? &*state_->data : nullptr);
  return report::json_text(nlohmann::ordered_json(report::to_json(summary)));
}

}  // namespace mixcmp::api

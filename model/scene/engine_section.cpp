#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>

#include "model/base/number/verdict.hpp"
#include "model/base/settings/section.hpp"
#include "model/comparison/data/pairing.hpp"
#include "model/scene/sections.hpp"

namespace mixcmp::scene {
namespace {

/// Checks the keys of [system] that the pairwise engine sets. A scene may repeat the engine's value
/// but not give another.
Result<Done> check_pairwise_system(const settings::Settings& settings, const EngineSpec& engine) {
  settings::Section section(settings, "system");
  const auto refuse = [&](const char* key, const std::string& received,
                          const std::string& accepted) {
    return section.mistake(key, "the pairwise engine decides it", received, accepted);
  };
  OperandStore operands = OperandStore::refetched;
  section.choice("operands", operands, {OperandStore::carried, OperandStore::refetched});
  if (operands != OperandStore::refetched) {
    return refuse("operands", "\"carried\"",
                  "\"refetched\", or no key: the engine's memory holds the operands");
  }
  int tag_bits = engine.tag_bits();
  section.integer("tag_bits", tag_bits, settings::limits::tag_bits);
  if (tag_bits != engine.tag_bits()) {
    return refuse("tag_bits", fmt::format("{}", tag_bits),
                  fmt::format("{}, the numbers of two of {} items, or no key", engine.tag_bits(),
                              engine.capacity));
  }
  return Done{};
}

/// Checks the keys of [system] with an arg-min engine.
Result<Done> check_arg_min_system(const settings::Settings& settings, const EngineSpec& engine) {
  settings::Section section(settings, "system");
  const auto refuse = [&](const char* key, const std::string& message, const std::string& received,
                          const std::string& accepted) {
    return section.mistake(key, message, received, accepted);
  };
  const std::string decided = "the arg-min engine decides it";
  OperandStore operands = OperandStore::refetched;
  section.choice("operands", operands, {OperandStore::carried, OperandStore::refetched});
  if (operands != OperandStore::refetched) {
    return refuse("operands", decided, "\"carried\"",
                  "\"refetched\", or no key: the engine's memories hold the operands");
  }
  ResultOrder order = ResultOrder::in_order;
  section.choice("order", order, {ResultOrder::tagged, ResultOrder::in_order});
  if (order != ResultOrder::in_order) {
    return refuse("order", decided, "\"tagged\"", "\"in_order\", or no key");
  }
  int tag_bits = engine.tag_bits();
  section.integer("tag_bits", tag_bits, settings::limits::tag_bits);
  if (tag_bits != engine.tag_bits()) {
    return refuse(
        "tag_bits", decided, fmt::format("{}", tag_bits),
        fmt::format("{}, or no key: a row's tag is engine.tag_bits wide", engine.tag_bits()));
  }
  return Done{};
}

Result<Done> check_pairwise_inputs(const settings::Section& section,
                                   const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    if (data::item_column(input)) continue;
    return section.mistake("kind", "the pairwise engine compares item i with item j",
                           fmt::format("the input {}", input),
                           "inputs that are a column's name followed by i or j");
  }
  return Done{};
}

/// Checks that some inputs belong to the candidates and some to the row.
Result<Done> check_arg_min_inputs(const settings::Section& section,
                                  const std::vector<std::string>& inputs) {
  const bool has_candidates =
      std::any_of(inputs.begin(), inputs.end(),
                  [](const std::string& name) { return data::item_column(name).has_value(); });
  const bool has_rows = std::any_of(inputs.begin(), inputs.end(), [](const std::string& name) {
    return !data::item_column(name).has_value();
  });
  if (has_candidates && has_rows) return Done{};
  return section.mistake("kind", "the arg-min engine compares candidates i and j for a row",
                         fmt::format("the inputs {}", fmt::join(inputs, ", ")),
                         "names that end in i or j for candidates, and others for the row");
}

Result<Done> check_data(const settings::Settings& settings,
                        const std::optional<data::DataSpec>& data,
                        const std::vector<data::Pairing>& wanted, const char* message) {
  if (!data || std::find(wanted.begin(), wanted.end(), data->pairing) != wanted.end()) {
    return Done{};
  }
  std::vector<std::string> accepted;
  for (const data::Pairing pairing : wanted) {
    accepted.push_back(fmt::format("pairs = \"{}\"", to_string(pairing)));
  }
  const settings::Section section(settings, "data");
  const bool absent = data->pairing == data::Pairing::rows;
  return section.mistake("pairs", message,
                         absent ? "nothing" : fmt::format("\"{}\"", to_string(data->pairing)),
                         fmt::format("{}", fmt::join(accepted, " or ")));
}

Result<Done> check_report_form(const settings::Section& section, const EngineSpec& engine) {
  const std::vector<std::string_view> reported = reported_verdicts(engine);
  if (engine.report_as != ReportForm::bitmap || reported.size() == 1) return Done{};
  return section.mistake("report_as", "a flag says of a pair that it is reported, not why",
                         fmt::format("\"bitmap\" with {}", fmt::join(reported, ", ")),
                         "\"bitmap\" with one verdict in report");
}

Result<Done> check_pairwise(const settings::Settings& settings, const settings::Section& section,
                            const EngineSpec& engine, const std::vector<std::string>& inputs,
                            const std::optional<data::DataSpec>& data) {
  MIXCMP_DO(check_pairwise_system(settings, engine));
  MIXCMP_DO(check_pairwise_inputs(section, inputs));
  MIXCMP_DO(check_report_form(section, engine));
  return check_data(settings, data, {data::Pairing::all, data::Pairing::cross},
                    "the pairwise engine compares every two items, or those of two tables");
}

Result<Done> check_arg_min(const settings::Settings& settings, const settings::Section& section,
                           const EngineSpec& engine, const std::vector<std::string>& inputs,
                           const std::optional<data::DataSpec>& data) {
  MIXCMP_DO(check_arg_min_system(settings, engine));
  MIXCMP_DO(check_arg_min_inputs(section, inputs));
  return check_data(settings, data, {data::Pairing::arg_min},
                    "the arg-min engine compares candidates for each row");
}

/// Refuses a form of reports in the key of the reported verdicts: the two keys are easily confused.
void refuse_form_as_report(settings::Section& section) {
  const settings::Setting* setting = section.find("report");
  if (setting == nullptr) return;
  const auto* list = std::get_if<settings::Setting::Array>(&setting->value);
  for (const settings::Setting& element :
       list == nullptr ? settings::Setting::Array{*setting} : *list) {
    const auto* word = std::get_if<std::string>(&element.value);
    for (const ReportForm form : {ReportForm::pairs, ReportForm::bitmap, ReportForm::count}) {
      if (word == nullptr || *word != to_string(form)) continue;
      section.fail("report", "has verdicts; the key report_as says how their pairs leave",
                   fmt::format("\"{}\"", *word),
                   fmt::format("report_as = \"{}\", and in report a list of one or more of less, "
                               "equal, greater, unordered",
                               *word));
    }
  }
}

void read_pairwise_keys(settings::Section& section, EngineSpec& engine) {
  section.integer("capacity", engine.capacity, settings::limits::engine_capacity);
  std::vector<Verdict> report;
  refuse_form_as_report(section);
  section.choices("report", report,
                  {Verdict::less, Verdict::equal, Verdict::greater, Verdict::unordered});
  if (!report.empty()) engine.report = {};
  for (const Verdict verdict : report) engine.report.insert(verdict);
  section.choice("report_as", engine.report_as,
                 {ReportForm::pairs, ReportForm::bitmap, ReportForm::count});
  section.integer("report_streams", engine.report_streams, settings::limits::report_streams);
  section.integer("lanes_per_group", engine.lanes_per_group, settings::limits::lanes_per_group);
}

}  // namespace

int index_bits_for(int count) {
  return std::bit_width(static_cast<unsigned>(count - 1));
}

int EngineSpec::tag_bits() const {
  return kind == EngineKind::arg_min ? 1 : 2 * index_bits_for(capacity);
}

int EngineSpec::lanes_per_segment() const {
  return kind == EngineKind::pairwise ? lanes_per_group : 1;
}

SystemSpec with_engine(SystemSpec system, const EngineSpec& engine) {
  system.engine = engine;
  switch (engine.kind) {
    case EngineKind::none: return system;
    case EngineKind::pairwise: break;
    case EngineKind::arg_min: system.order = ResultOrder::in_order; break;
  }
  system.input_registers = 0;
  system.lanes_per_group = 1;
  system.operands = OperandStore::refetched;
  system.tag_bits = engine.tag_bits();
  return system;
}

std::string_view to_string(EngineKind kind) {
  switch (kind) {
    case EngineKind::none: return "none";
    case EngineKind::pairwise: return "pairwise";
    case EngineKind::arg_min: return "arg_min";
  }
  MIXCMP_CHECK(false);
}

std::string_view to_string(ReportForm form) {
  switch (form) {
    case ReportForm::pairs: return "pairs";
    case ReportForm::bitmap: return "bitmap";
    case ReportForm::count: return "count";
  }
  MIXCMP_CHECK(false);
}

std::vector<std::string_view> reported_verdicts(const EngineSpec& engine) {
  std::vector<std::string_view> words;
  for (const Verdict verdict : all_verdicts) {
    if (engine.report.contains(verdict)) words.push_back(to_string(verdict));
  }
  return words;
}

Result<EngineSpec> read_engine(const settings::Settings& settings,
                               const std::vector<std::string>& inputs,
                               const std::optional<data::DataSpec>& data) {
  settings::Section section(settings, "engine");
  EngineSpec engine;
  if (section.present() && section.find("kind") == nullptr) {
    section.fail("kind", "missing beside other keys of the engine", "nothing",
                 "kind = \"pairwise\", \"arg_min\" or \"none\"");
  }
  section.choice("kind", engine.kind,
                 {EngineKind::none, EngineKind::pairwise, EngineKind::arg_min});
  // A key of the other kind of engine is an error; with kind = "none" all keys are read and unused.
  if (engine.kind != EngineKind::arg_min) read_pairwise_keys(section, engine);
  if (engine.kind != EngineKind::pairwise) {
    section.integer("tag_bits", engine.row_tag_bits, settings::limits::tag_bits);
  }
  if (const auto error = section.finish()) return *error;
  switch (engine.kind) {
    case EngineKind::none: break;
    case EngineKind::pairwise: {
      MIXCMP_TRY(checked, check_pairwise(settings, section, engine, inputs, data));
      break;
    }
    case EngineKind::arg_min: {
      MIXCMP_DO(check_arg_min(settings, section, engine, inputs, data));
      break;
    }
  }
  return engine;
}

}  // namespace mixcmp::scene

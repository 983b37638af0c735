#include <fmt/format.h>

#include <bit>

#include "model/data/pairing.hpp"
#include "model/golden/arithmetic.hpp"
#include "model/scene/section.hpp"
#include "model/scene/sections.hpp"

namespace mixcmp::model {
namespace {

using golden::Verdict;

/// Keys of [system] that an engine decides: one may repeat them, not contradict.
Result<Done> check_system(const Settings& settings, const EngineSpec& engine) {
  Section section(settings, "system");
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
  section.integer("tag_bits", tag_bits, 1, 64);
  if (tag_bits != engine.tag_bits()) {
    return refuse("tag_bits", fmt::format("{}", tag_bits),
                  fmt::format("{}, the numbers of two of {} items, or no key", engine.tag_bits(),
                              engine.capacity));
  }
  return Done{};
}

Result<Done> check_inputs(const Section& section, const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    if (item_column(input)) continue;
    return section.mistake("kind", "the pairwise engine compares item i with item j",
                           fmt::format("the input {}", input),
                           "inputs that are a column's name followed by i or j");
  }
  return Done{};
}

Result<Done> check_data(const Settings& settings, const std::optional<DataSpec>& data) {
  if (!data || data->pairing == Pairing::all) return Done{};
  const Section section(settings, "data");
  return section.mistake("pairs", "the pairwise engine compares every two items",
                         fmt::format("{}", to_string(data->pairing)), "pairs = \"all\"");
}

}  // namespace

int EngineSpec::index_bits() const {
  return std::bit_width(static_cast<unsigned>(capacity - 1));
}

SystemSpec with_engine(SystemSpec system, const EngineSpec& engine) {
  system.engine = engine;
  if (engine.kind == EngineKind::none) return system;
  system.operands = OperandStore::refetched;
  system.tag_bits = engine.tag_bits();
  return system;
}

std::string_view to_string(EngineKind kind) {
  switch (kind) {
    case EngineKind::none: return "none";
    case EngineKind::pairwise: return "pairwise";
  }
  MIXCMP_CHECK(false);
}

std::vector<std::string_view> reported_verdicts(const EngineSpec& engine) {
  std::vector<std::string_view> words;
  for (std::size_t k = 0; k < engine.report.size(); ++k) {
    if (engine.report[k]) words.push_back(to_string(static_cast<Verdict>(k)));
  }
  return words;
}

Result<EngineSpec> read_engine(const Settings& settings, const std::vector<std::string>& inputs,
                               const std::optional<DataSpec>& data) {
  Section section(settings, "engine");
  EngineSpec engine;
  if (section.present()) section.require("kind");
  section.choice("kind", engine.kind, {EngineKind::none, EngineKind::pairwise});
  section.integer("capacity", engine.capacity, 2, EngineSpec::max_capacity);
  std::vector<Verdict> report;
  section.choices("report", report,
                  {Verdict::less, Verdict::equal, Verdict::greater, Verdict::unordered});
  if (!report.empty()) engine.report = {};
  for (const Verdict verdict : report) engine.report[static_cast<std::size_t>(verdict)] = true;
  if (const auto error = section.finish()) return *error;
  if (engine.kind == EngineKind::none) return engine;
  MIXCMP_TRY(system_checked, check_system(settings, engine));
  MIXCMP_TRY(inputs_checked, check_inputs(section, inputs));
  MIXCMP_TRY(data_checked, check_data(settings, data));
  return engine;
}

}  // namespace mixcmp::model

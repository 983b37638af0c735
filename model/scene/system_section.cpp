#include <fmt/format.h>

#include "model/scene/section.hpp"
#include "model/scene/sections.hpp"

namespace mixcmp::model {
namespace {

constexpr int min_reference_precision = 11;

}  // namespace

Result<ReferenceSpec> read_reference(const Settings& settings) {
  Section section(settings, "reference");
  std::optional<FloatFormat> format;
  Subnormals subnormals = Subnormals::gradual;
  section.require("format");
  section.format("format", format);
  section.choice("subnormals", subnormals, {Subnormals::flush, Subnormals::gradual});
  Multipliers multipliers = Multipliers::embedded;
  section.choice("multipliers", multipliers, {Multipliers::embedded, Multipliers::logic});
  if (format && format->precision() < min_reference_precision) {
    section.fail(
        "format", "precision out of range", format->name(),
        fmt::format("precision {}..{}", min_reference_precision, FloatFormat::max_precision));
  }
  if (const auto error = section.finish()) return *error;
  return ReferenceSpec{{.format = *format, .subnormals = subnormals}, multipliers};
}

Result<SystemSpec> read_system(const Settings& settings) {
  SystemSpec spec;
  Section section(settings, "system");
  section.text("device", spec.device);
  section.integer_or_auto("lanes", spec.lanes, 1, max_lanes);
  section.integer_or_auto("references", spec.references, 0, max_references);
  section.number("slack", spec.slack, 0, 0.95);
  section.number("target_mhz", spec.target_mhz, 1, 2000);
  section.choice("order", spec.order, {ResultOrder::tagged, ResultOrder::in_order});
  section.choice("operands", spec.operands, {OperandStore::carried, OperandStore::refetched});
  section.integer("tag_bits", spec.tag_bits, 1, 64);
  section.integer("counter_bits", spec.counter_bits, 0, 64);
  if (0 < spec.counter_bits && spec.counter_bits < 8) {
    section.fail("counter_bits", "out of range", fmt::format("{}", spec.counter_bits),
                 "0 (no counters) or an integer 8..64");
  }
  if (spec.device.empty()) section.fail("device", "empty", "\"\"", "a device's name");
  if (const auto error = section.finish()) return *error;
  return spec;
}

}  // namespace mixcmp::model

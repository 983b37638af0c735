#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "model/base/common/check.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/number/double.hpp"
#include "model/base/settings/section.hpp"
#include "model/comparison/expression/name.hpp"
#include "model/cost/devices/device.hpp"
#include "model/lane/error/exactness.hpp"
#include "model/scene/sections.hpp"

namespace mixcmp::scene {
namespace {

/// Checks that a Verilog identifier may begin with the prefix.
void check_prefix(settings::Section& section, const std::string& prefix) {
  constexpr std::size_t longest = 32;
  if (prefix.size() <= longest && name_problem(prefix + "x").empty()) return;
  section.fail(
      "prefix", "does not begin a Verilog name", in_quotes(prefix),
      fmt::format("letters, digits and '_', no digit nor verilator first, at most {}", longest));
}

/// Reads the memory of carried operands, and the number of beats in which they leave.
void read_requests(settings::Section& section, SystemSpec& spec) {
  section.choice("operand_memory", spec.operand_memory,
                 {OperandMemory::logic, OperandMemory::block});
  section.integer_or_auto("request_beats", spec.request_beats, settings::limits::request_beats);
  const int beats = spec.request_beats.value_or(1);
  if (!std::has_single_bit(static_cast<unsigned>(beats))) {
    section.fail("request_beats", "not a power of two", fmt::format("{}", beats),
                 "1, 2, 4, 8, 16 or \"auto\"");
  }
}

/// Reads the counters' width and the access to them, which must not contradict each other.
void read_counters(settings::Section& section, SystemSpec& spec) {
  const auto is_given = [&](const char* key) { return section.find(key) != nullptr; };
  section.integer_or_zero("counter_bits", spec.counter_bits, settings::limits::counter_bits,
                          "no counters");
  if (spec.counter_bits == 0) spec.counters = CounterAccess::none;
  section.choice("counters", spec.counters,
                 {CounterAccess::none, CounterAccess::ports, CounterAccess::axi_lite});
  const std::string bits = fmt::format("{}", spec.counter_bits);
  if (spec.counters == CounterAccess::none) {
    if (is_given("counter_bits") && spec.counter_bits > 0) {
      section.fail("counter_bits", "contradicts counters = \"none\"", bits, "0");
    }
    spec.counter_bits = 0;
  } else if (spec.counter_bits == 0) {
    section.fail("counters", "contradicts counter_bits = 0", in_quotes(to_string(spec.counters)),
                 "\"none\"");
  } else if (spec.counters == CounterAccess::axi_lite &&
             !settings::limits::read_counter_bits.allow(spec.counter_bits)) {
    section.fail(
        "counter_bits", "too narrow for counters = \"axi_lite\"", bits,
        fmt::format("an integer {}", settings::to_string(settings::limits::read_counter_bits)));
  }
}

bool all_fixed(std::span<const std::optional<OperandFormat>> formats) {
  return std::all_of(formats.begin(), formats.end(),
                     [](const std::optional<OperandFormat>& format) {
                       return format && format->fixed() != nullptr;
                     });
}

Error no_exact_reference(const settings::Section& section, const Error& error) {
  return section.mistake("format", "no reference is exact: " + error.message, error.received,
                         error.accepted + ", or a format such as s53e11");
}

/// The formats of all inputs; `why` says in an error why an input needs one.
Result<std::vector<OperandFormat>> all_formats(const settings::Section& section,
                                               const std::vector<std::string>& inputs,
                                               const InputDeclarations& declared, const char* why) {
  std::vector<OperandFormat> formats;
  for (std::size_t input = 0; input < inputs.size(); ++input) {
    const std::optional<OperandFormat>& format = declared.formats[input];
    if (!format) {
      return section.mistake("format", fmt::format("{} each input needs a format", why),
                             "none for " + inputs[input],
                             "a format such as uint10 or binary32, or a reference in one such as "
                             "s53e11");
    }
    formats.push_back(*format);
  }
  return formats;
}

/// The format of a reference that rounds nothing in any formulation.
Result<FloatFormat> read_exact_format(const settings::Section& section,
                                      std::span<const Graph> graphs,
                                      const InputDeclarations& declared) {
  MIXCMP_TRY(formats, all_formats(section, graphs.front().inputs(), declared,
                                  "for a reference that rounds nothing"));
  int precision = settings::limits::reference_precision.least, exponent_bits = 0;
  for (const Graph& graph : graphs) {
    const auto format = error::exact_format(graph, formats, declared.ranges, declared.grids);
    if (!format.ok()) return no_exact_reference(section, format.error());
    precision = std::max(precision, format->precision());
    exponent_bits = std::max(exponent_bits, format->exponent_bits());
  }
  return FloatFormat::make(precision, exponent_bits);
}

/// The floating-point format of the operands beside a reference in fixed point.
Result<FloatFormat> read_operands_format(const settings::Section& section,
                                         const std::vector<std::string>& inputs,
                                         const InputDeclarations& declared) {
  MIXCMP_TRY(formats, all_formats(section, inputs, declared, "with references in fixed point"));
  const FloatFormat held = format_holding(formats);
  return FloatFormat::make(std::max(held.precision(), settings::limits::reference_precision.least),
                           held.exponent_bits());
}

/// Refuses fused sums that may cut digits in a format in which composed sums round nothing.
Result<Done> check_exact_sums(const settings::Section& section, std::span<const Graph> graphs,
                              const InputDeclarations& declared, const Arithmetic& reference) {
  if (reference.sums == Sums::composed) return Done{};
  for (const Graph& graph : graphs) {
    TypedGraph typed = reference_graph(graph, reference);
    for (const auto& format : declared.formats) typed.arriving.push_back(*format);
    const std::vector<bool> exact = error::exact_nodes(typed, declared.ranges, declared.grids);
    if (std::find(exact.begin(), exact.end(), false) == exact.end()) continue;
    return section.mistake("sums", "a fused sum may cut digits, and format = \"exact\" keeps all",
                           "\"fused\"", "\"composed\"");
  }
  return Done{};
}

/// Refuses a reference in floating point where f or g applies a function.
Result<Done> check_functions(const settings::Section& section, std::span<const Graph> graphs,
                             const std::string& received) {
  for (const Graph& graph : graphs) {
    const std::optional<Function> function = graph.first_function();
    if (!function) continue;
    return section.mistake("format",
                           "a reference in floating point has no " + applied_text(*function, "x"),
                           received, "qW such as q40");
  }
  return Done{};
}

void check_fixed_reference(settings::Section& section, const FixedPoint& format) {
  if (format.is_plain() && settings::limits::fixed_bits.allow(format.bits)) return;
  section.fail(
      "format",
      format.is_plain() ? "out of range" : "a reference has neither guard digits nor blocks",
      in_quotes(format.name()),
      fmt::format("qW with W {}", settings::to_string(settings::limits::fixed_bits)));
}

}  // namespace

void use_device(SystemSpec& system, const std::string& device) {
  system.device = device;
  if (system.has_own_target) return;
  const auto found = devices::find_device(device);
  if (found.ok()) system.target_mhz = found->delays.target_mhz;
}

void read_structure(settings::Section& section, ReferenceStructureSpec& structure) {
  section.choice("multipliers", structure.multipliers, {Multipliers::embedded, Multipliers::logic});
  section.integer_or_auto("initiation_interval", structure.initiation_interval,
                          settings::limits::initiation_interval);
  if (section.find("target_mhz") == nullptr) return;
  section.integer("target_mhz", structure.target_mhz.emplace(), settings::limits::target_mhz);
}

Result<ReferenceSpec> read_reference(const settings::Settings& settings,
                                     std::span<const Graph> graphs,
                                     const InputDeclarations& declared) {
  settings::Section section(settings, "reference");
  std::optional<FloatFormat> format;
  Subnormals subnormals = Subnormals::gradual;
  Sums sums = Sums::composed;
  const settings::Setting* given = section.find("format");
  const auto* word = given == nullptr ? nullptr : std::get_if<std::string>(&given->value);
  std::optional<FixedPoint> fixed_point = word == nullptr ? std::nullopt : FixedPoint::parse(*word);
  const bool is_exact =
      given == nullptr ? all_fixed(declared.formats) : word != nullptr && *word == "exact";
  if (!fixed_point && word != nullptr)
    MIXCMP_DO(check_functions(section, graphs, in_quotes(*word)));
  if (given == nullptr) MIXCMP_DO(check_functions(section, graphs, "none"));
  if (is_exact) {
    MIXCMP_TRY(exact, read_exact_format(section, graphs, declared));
    format = exact;
  } else if (fixed_point) {
    MIXCMP_TRY(of_operands, read_operands_format(section, graphs.front().inputs(), declared));
    format = of_operands;
    check_fixed_reference(section, *fixed_point);
  } else {
    section.require("format");
    constexpr settings::Limits precisions = settings::limits::reference_precision;
    section.format(
        "format", format, precisions,
        "\"exact\", qW such as q40, " + FloatFormat::accepted(precisions.least, precisions.most));
  }
  section.choice("subnormals", subnormals, {Subnormals::flush, Subnormals::gradual});
  section.choice("sums", sums, {Sums::composed, Sums::fused});
  ReferenceStructureSpec structure;
  read_structure(section, structure);
  if (const auto error = section.finish()) return *error;
  const Arithmetic arithmetic = {.format = *format, .subnormals = subnormals, .sums = sums};
  if (is_exact) MIXCMP_DO(check_exact_sums(section, graphs, declared, arithmetic));
  return ReferenceSpec{arithmetic, fixed_point, structure};
}

settings::Limits lane_limits(const settings::Settings& settings) {
  EngineKind kind = EngineKind::none;
  settings::Section section(settings, "engine");  // read_engine reports mistakes in it
  section.choice("kind", kind, {EngineKind::none, EngineKind::pairwise, EngineKind::arg_min});
  int lanes_per_group = 1;
  settings::Section system(settings, "system");  // read_system reports mistakes in it
  system.integer("lanes_per_group", lanes_per_group, settings::limits::lanes_per_group);
  switch (kind) {
    case EngineKind::none: return settings::limits::lanes_in_groups(lanes_per_group);
    case EngineKind::pairwise: return settings::limits::engine_lanes;
    case EngineKind::arg_min: return settings::limits::lanes;
  }
  MIXCMP_CHECK(false);
}

Result<SystemSpec> read_system(const settings::Settings& settings) {
  SystemSpec spec;
  settings::Section section(settings, "system");
  const bool names_device = section.find("device") != nullptr;
  section.text("device", spec.device);
  section.integer_or_auto("lanes", spec.lanes, lane_limits(settings));
  section.integer_or_auto("references", spec.references, settings::limits::references);
  section.number("slack", spec.slack, 0, 0.95);
  spec.has_own_target = section.find("target_mhz") != nullptr;
  section.number("target_mhz", spec.target_mhz, settings::limits::target_mhz.least,
                 settings::limits::target_mhz.most);
  section.integer("lanes_per_group", spec.lanes_per_group, settings::limits::lanes_per_group);
  section.integer("input_registers", spec.input_registers, settings::limits::input_registers);
  section.choice("order", spec.order, {ResultOrder::tagged, ResultOrder::in_order});
  section.choice("operands", spec.operands, {OperandStore::carried, OperandStore::refetched});
  read_requests(section, spec);
  section.integer("tag_bits", spec.tag_bits, settings::limits::tag_bits);
  read_counters(section, spec);
  section.text("prefix", spec.prefix);
  check_prefix(section, spec.prefix);
  if (spec.device.empty()) section.fail("device", "empty", "\"\"", "a device's name");
  if (const auto error = section.finish()) return *error;
  if (names_device) use_device(spec, spec.device);
  return spec;
}

}  // namespace mixcmp::scene

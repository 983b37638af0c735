#include "model/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "model/common/nearest.hpp"
#include "model/common/quote.hpp"
#include "model/data/sphere_family.hpp"
#include "model/error/exponent_range.hpp"
#include "model/expression/name.hpp"
#include "model/expression/text.hpp"
#include "model/golden/arithmetic.hpp"
#include "model/scene/input_ranges.hpp"
#include "model/scene/section.hpp"

namespace mixcmp::model {
namespace {

constexpr int min_reference_precision = 11;
constexpr int min_reduced_precision = 4, max_reduced_precision = 52;
constexpr std::int64_t max_items = 1 << 24;
constexpr double largest_number = 1e30;

struct Comparison {
  std::string name;
  std::string f;
  std::string g;
};

Result<Done> check_section_names(const Settings& settings) {
  const std::vector<std::string> names = {"comparison", "let",    "inputs", "reference",
                                          "reduced",    "system", "data"};
  for (const Setting& entry : settings.root.entries) {
    if (std::find(names.begin(), names.end(), entry.key) != names.end()) continue;
    const bool is_section = std::holds_alternative<Setting::Table>(entry.value);
    return mistake_at(settings, entry, entry.key,
                      is_section ? "unknown section" : "a key outside of any section", entry.key,
                      list_with_nearest(entry.key, names));
  }
  return Done{};
}

Result<Comparison> read_comparison(const Settings& settings) {
  Comparison comparison;
  Section section(settings, "comparison");
  section.require("name");
  section.require("f");
  section.require("g");
  section.text("name", comparison.name);
  section.text("f", comparison.f);
  section.text("g", comparison.g);
  const std::string problem = name_problem(comparison.name);
  if (!problem.empty()) {
    section.fail("name", problem, fmt::format("\"{}\"", comparison.name),
                 std::string(accepted_names()));
  }
  if (const auto error = section.finish()) return *error;
  return comparison;
}

Result<std::vector<LetDefinition>> read_lets(const Settings& settings) {
  Section section(settings, "let");
  std::vector<LetDefinition> lets;
  for (const Setting& entry : section.entries()) {
    const std::string problem = is_function_name(entry.key)
                                    ? fmt::format("{} is a function", entry.key)
                                    : name_problem(entry.key);
    if (!problem.empty()) {
      section.fail(entry.key, problem, fmt::format("\"{}\"", entry.key),
                   std::string(accepted_names()) + ", no function");
    }
    section.text(entry.key, lets.emplace_back(LetDefinition{.name = entry.key}).text);
  }
  if (const auto error = section.finish()) return *error;
  return lets;
}

/// Moves an expression's error to its place in the file. Where the text does not stand there as it
/// is (escapes, --set), the message tells the position in the text instead.
Error locate(const Settings& settings, const Setting& setting, Error error) {
  const auto column = static_cast<std::size_t>(error.column);
  const std::string& source = settings.source;
  const auto& text = std::get<std::string>(setting.value);
  error.file = setting.line > 0 ? settings.path.string() : "--set";
  error.line = setting.line;
  error.column = 0;
  std::size_t line_start = 0;
  for (int line = 1; line < setting.line; ++line) line_start = source.find('\n', line_start) + 1;
  const std::size_t quote = source.find_first_of("\"'", source.find('=', line_start));
  const std::size_t begin = quote == std::string::npos ? quote : source.find(text, quote + 1);
  const auto lines_between = [&](std::size_t from, std::size_t to) {
    return static_cast<int>(std::count(source.begin() + static_cast<long>(from),
                                       source.begin() + static_cast<long>(to), '\n'));
  };
  const bool stands_there =
      setting.line > 0 && begin != std::string::npos &&
      setting.line + lines_between(line_start, begin + text.size()) <= setting.end_line;
  if (!stands_there) {
    error.message += fmt::format(" at character {} of the text", column);
    return error;
  }
  const std::size_t place = begin + column - 1;
  error.line += lines_between(line_start, place);
  const std::size_t newline = place == 0 ? std::string::npos : source.rfind('\n', place - 1);
  error.column = static_cast<int>(newline == std::string::npos ? place + 1 : place - newline);
  return error;
}

/// Parses the string at section.key; errors come back with their place in the file.
Result<NodeId> parse_setting(const Settings& settings, Graph& graph, const std::string& section,
                             const std::string& key, std::span<const LetDefinition> lets,
                             std::set<std::string>& used_lets) {
  const Setting* table = settings.root.find(section);
  const Setting* setting = std::get<Setting::Table>(table->value).find(key);
  const Result<NodeId> node =
      parse_expression(graph, std::get<std::string>(setting->value), lets, &used_lets);
  if (node.ok()) return node;
  Error error = node.error();
  if (error.field.empty()) {
    error.field = fmt::format("{}.{}", section, key);
    return locate(settings, *setting, error);
  }
  const std::string let = error.field.substr(std::string_view("let.").size());
  const auto& let_table = std::get<Setting::Table>(settings.root.find("let")->value);
  return locate(settings, *let_table.find(let), error);
}

/// f and g in one graph; lets that neither needs are parsed too, for their mistakes.
Result<Graph> read_graph(const Settings& settings, std::span<const LetDefinition> lets,
                         std::vector<std::string>& notes) {
  Graph graph;
  std::set<std::string> used_lets;
  MIXCMP_TRY(f, parse_setting(settings, graph, "comparison", "f", lets, used_lets));
  MIXCMP_TRY(g, parse_setting(settings, graph, "comparison", "g", lets, used_lets));
  graph.compare(f, g);
  for (const LetDefinition& let : lets) {
    if (used_lets.contains(let.name)) continue;
    Graph scratch;
    std::set<std::string> ignored;
    MIXCMP_TRY(node, parse_setting(settings, scratch, "let", let.name, lets, ignored));
    MIXCMP_CHECK(node >= 0);
    notes.push_back(fmt::format("let {} is not used by f or g", let.name));
  }
  if (graph.inputs().empty()) {
    const Section section(settings, "comparison");
    return section.mistake("f", "f and g name no input", "constants only",
                           "at least one input name");
  }
  return graph;
}

struct ReferenceSpec {
  Arithmetic arithmetic;
  Multipliers multipliers = Multipliers::embedded;
};

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

/// The 17 of "s17".
std::optional<int> precision_alone(const std::string& word) {
  const bool shaped = word.size() >= 2 && word.size() <= 4 && word[0] == 's' &&
                      word.find_first_not_of("0123456789", 1) == std::string::npos;
  return shaped ? std::optional(std::stoi(word.substr(1))) : std::nullopt;
}

void read_reduced_format(Section& section, FloatFormat reference, ReducedSpec& spec) {
  std::optional<FloatFormat>& target = spec.format;
  const Setting* setting = section.find("format");
  const auto* word = setting == nullptr ? nullptr : std::get_if<std::string>(&setting->value);
  const std::optional<int> precision = word == nullptr ? std::nullopt : precision_alone(*word);
  if (precision && *precision >= min_reduced_precision && *precision <= max_reduced_precision) {
    target = FloatFormat::make(*precision, reference.exponent_bits()).value();
    spec.exponent_bits_from_ranges = true;
  } else if (word == nullptr || *word != "auto") {
    section.format("format", target);
  }
  if (!target) return;
  const int highest = std::min(max_reduced_precision, reference.precision());
  if (target->precision() < min_reduced_precision || target->precision() > highest) {
    section.fail(
        "format", "precision out of range", target->name(),
        fmt::format("precision {}..{}, at most the reference's", min_reduced_precision, highest));
  }
}

void read_error_bound(Section& section, std::optional<ErrorBoundKind>& target) {
  std::string word = "auto";
  section.text("error_bound", word);
  for (const ErrorBoundKind kind :
       {ErrorBoundKind::relative, ErrorBoundKind::running, ErrorBoundKind::constant}) {
    if (word == to_string(kind)) target = kind;
  }
  if (target || word == "auto") return;
  section.fail("error_bound", "not a choice", fmt::format("\"{}\"", word),
               "auto, relative, running, constant");
}

void read_relative_error(Section& section, const std::string& key,
                         std::optional<mpq_class>& target) {
  section.exact(key, target);
  if (target && (*target < 0 || *target >= 1)) {
    section.fail(key, "out of range", to_text(*target), "a number of at least 0 and below 1");
  }
}

Result<ReducedSpec> read_reduced(const Settings& settings, FloatFormat reference,
                                 std::vector<std::string>& notes) {
  ReducedSpec spec;
  Section section(settings, "reduced");
  read_reduced_format(section, reference, spec);
  section.choice("bound", spec.bound, {BoundKind::certified, BoundKind::profiled});
  read_error_bound(section, spec.error_bound);
  section.integer("bound_digits", spec.bound_digits, 1, 8);
  section.choice("inputs", spec.inputs, {LaneInputs::rounded, LaneInputs::exact});
  section.choice("rounding", spec.rounding, {Rounding::nearest_even, Rounding::toward_zero});
  section.choice("subnormals", spec.subnormals, {Subnormals::flush, Subnormals::gradual});
  section.choice("multipliers", spec.multipliers, {Multipliers::embedded, Multipliers::logic});
  read_relative_error(section, "relative_error_f", spec.relative_error_f);
  read_relative_error(section, "relative_error_g", spec.relative_error_g);
  if (const auto error = section.finish()) return *error;
  const bool errors_given = spec.relative_error_f || spec.relative_error_g;
  if (errors_given && spec.bound == BoundKind::certified) {
    notes.emplace_back(
        "reduced.relative_error_f and _g are not used: a certified bound proves its own");
  }
  return spec;
}

/// A profiled lane checks no range, so that its exponents must reach as far as the reference's.
void choose_exponent_bits(ReducedSpec& reduced, const Graph& graph, FloatFormat reference,
                          const std::vector<std::optional<Range>>& ranges) {
  if (reduced.bound == BoundKind::profiled) return;
  const Arithmetic arithmetic{*reduced.format, reduced.rounding, reduced.subnormals};
  const int bits = lane_exponent_bits(graph, reference, arithmetic, reduced.inputs, ranges);
  reduced.format = FloatFormat::make(reduced.format->precision(), bits).value();
}

Result<SystemSpec> read_system(const Settings& settings) {
  SystemSpec spec;
  Section section(settings, "system");
  section.text("device", spec.device);
  section.integer_or_auto("lanes", spec.lanes, 1, 128);
  section.integer_or_auto("references", spec.references, 0, 16);
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

void read_data_file(Section& section, const std::filesystem::path& scene, DataSpec& spec) {
  std::string file;
  section.text("file", file);
  if (section.find("file") == nullptr) return;
  const std::array<std::string_view, 3> readable = {".pdb", ".csv", ".npy"};
  spec.file = scene.parent_path() / file;
  if (std::find(readable.begin(), readable.end(), spec.file.extension()) == readable.end()) {
    section.fail("file", "not a data file by its ending", fmt::format("\"{}\"", file),
                 "a file that ends in .pdb, .csv or .npy");
  }
}

void check_family(Section& section, const DataSpec& spec) {
  const bool given = section.find("family") != nullptr;
  if (spec.items != "sphere_family") {
    if (!given) return;
    section.fail("family", "only of items = \"sphere_family\"", in_quotes(spec.family),
                 "no family here");
    return;
  }
  const std::vector<std::string> names = sphere_family_names();
  if (!given) {
    section.fail("family", "required", "nothing", accepted_sphere_families(""));
  } else if (std::find(names.begin(), names.end(), spec.family) == names.end()) {
    section.fail("family", "not a family of sphere pairs", in_quotes(spec.family),
                 accepted_sphere_families(spec.family));
  }
  if (spec.all_pairs) {
    section.fail("pairs", "the rows of a family are pairs already", "\"all\"", "no pairs here");
  }
}

void check_data_source(Section& section, const DataSpec& spec, std::vector<std::string>& notes) {
  const bool items = section.find("items") != nullptr;
  const bool file = section.find("file") != nullptr;
  if (items == file) {
    section.fail("", items ? "two sources of data" : "no source of data",
                 items ? "items and file" : "neither items nor file",
                 "items = \"uniform_spheres\", or file = a .pdb, .csv or .npy file");
  }
  const bool family = spec.items == "sphere_family";
  if (items && !family && spec.items != "uniform_spheres") {
    section.fail("items", "not a choice", fmt::format("\"{}\"", spec.items),
                 "uniform_spheres, sphere_family");
  }
  check_family(section, spec);
  for (const char* key : {"count", "side", "radius_max", "seed"}) {
    if (section.find(key) == nullptr || !file) continue;
    notes.push_back(fmt::format("data.{} is not used: the data come from a file", key));
  }
  for (const char* key : {"side", "radius_max"}) {
    if (section.find(key) == nullptr || !family) continue;
    notes.push_back(fmt::format("data.{} is not used: a family has its own sizes", key));
  }
}

Result<std::optional<DataSpec>> read_data(const Settings& settings,
                                          std::vector<std::string>& notes) {
  Section section(settings, "data");
  if (settings.root.find("data") == nullptr) return std::optional<DataSpec>();
  DataSpec spec{.line = section.line()};
  std::string pairs;
  section.text("items", spec.items);
  section.text("family", spec.family);
  read_data_file(section, settings.path, spec);
  section.integer("count", spec.count, 1, max_items);
  section.number("side", spec.side, 0, largest_number);
  section.number("radius_max", spec.radius_max, 0, largest_number);
  section.integer("seed", spec.seed, 0, std::numeric_limits<std::int64_t>::max());
  section.text("pairs", pairs);
  spec.all_pairs = pairs == "all";
  if (section.find("pairs") != nullptr && !spec.all_pairs) {
    section.fail("pairs", "not a choice", fmt::format("\"{}\"", pairs), "all");
  }
  check_data_source(section, spec, notes);
  if (const auto error = section.finish()) return *error;
  return std::optional<DataSpec>(spec);
}

/// Notes constants that the reference format only approximates; one that it cannot hold at all is a
/// mistake in the choice of format.
Result<Done> check_constants(const Settings& settings, const Graph& graph,
                             const Arithmetic& reference, std::vector<std::string>& notes) {
  const FloatFormat format = reference.format;
  for (const Node& node : graph.nodes()) {
    if (node.operation != Operation::constant) continue;
    const Bits bits = golden::from_rational(format, node.value);
    const bool vanishes = format.is_zero(bits) ||
                          (reference.subnormals == Subnormals::flush && format.is_subnormal(bits));
    if (format.is_infinite(bits) || (vanishes && node.value != 0)) {
      const Section section(settings, "reference");
      return section.mistake("format",
                             fmt::format("it cannot hold the constant {}", to_text(node.value)),
                             format.name(), "a format with more exponent bits");
    }
    const mpq_class off = golden::to_rational(format, bits) - node.value;
    if (off == 0) continue;
    notes.push_back(fmt::format("constant {} is inexact in {}: rounded, off by {}",
                                to_text(node.value), format.name(), to_text(off)));
  }
  return Done{};
}

/// Notes ends of ranges that data of the same decimal miss, being rounded to the reference format.
void note_missed_ends(const std::vector<std::optional<Range>>& ranges, FloatFormat format,
                      std::vector<std::string>& notes) {
  for (const std::optional<Range>& range : ranges) {
    if (!range) continue;
    for (const mpq_class& end : {range->low, range->high}) {
      const Bits bits = golden::from_rational(format, end);
      if (format.is_infinite(bits)) continue;
      const mpq_class rounded = golden::to_rational(format, bits);
      if (range->low <= rounded && rounded <= range->high) continue;
      const std::string note = fmt::format(
          "the range end {} rounds out of its range in {}: data of just that value are out of "
          "range",
          to_text(end), format.name());
      if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
    }
  }
}

}  // namespace

std::vector<bool> Scene::nonnegative_inputs() const {
  std::vector<bool> nonnegative;
  for (const std::optional<Range>& range : ranges) {
    nonnegative.push_back(range && range->low >= 0);
  }
  return nonnegative;
}

Result<Scene> load_scene(const std::filesystem::path& path,
                         std::span<const std::string> overrides) {
  MIXCMP_TRY(settings, read_settings(path, overrides));
  std::vector<std::string> notes;
  MIXCMP_TRY(names_checked, check_section_names(settings));
  MIXCMP_TRY(comparison, read_comparison(settings));
  MIXCMP_TRY(lets, read_lets(settings));
  MIXCMP_TRY(graph, read_graph(settings, lets, notes));
  MIXCMP_TRY(declared, read_inputs(settings, graph.inputs()));
  MIXCMP_TRY(reference_spec, read_reference(settings));
  const Arithmetic reference = reference_spec.arithmetic;
  MIXCMP_TRY(constants_checked, check_constants(settings, graph, reference, notes));
  note_missed_ends(declared.ranges, reference.format, notes);
  MIXCMP_TRY(reduced, read_reduced(settings, reference.format, notes));
  if (reduced.exponent_bits_from_ranges) {
    choose_exponent_bits(reduced, graph, reference.format, declared.ranges);
  }
  MIXCMP_TRY(system, read_system(settings));
  MIXCMP_TRY(data, read_data(settings, notes));
  return Scene{.path = path,
               .name = comparison.name,
               .f_text = comparison.f,
               .g_text = comparison.g,
               .graph = std::move(graph),
               .ranges = std::move(declared.ranges),
               .grids = std::move(declared.grids),
               .reference = reference,
               .reference_multipliers = reference_spec.multipliers,
               .reduced = std::move(reduced),
               .system = std::move(system),
               .data = std::move(data),
               .notes = std::move(notes)};
}

}  // namespace mixcmp::model

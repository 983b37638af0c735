#include "generator/faces/cli/characterise_options.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <thread>

#include "model/base/common/check.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/number/bound.hpp"
#include "model/base/settings/bound_name.hpp"
#include "model/plan/profile/profile.hpp"
#include "model/scene/lane_bound.hpp"

namespace mixcmp::cli {
namespace {

using measured::ComponentKind;
using scene::Multipliers;

Error mistake(const std::string& option, std::string message, std::string_view received,
              std::string accepted) {
  return {.field = option,
          .message = std::move(message),
          .received = in_quotes(received),
          .accepted = std::move(accepted)};
}

std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> list;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');) list.push_back(word);
  return list;
}

std::optional<int> number(std::string_view text) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, failed] = std::from_chars(text.data(), end, value);
  return failed == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

/// Reads "both", embedded multipliers and logic, or a list of the three kinds.
Result<std::vector<Multipliers>> multiplier_kinds(const std::string& text) {
  if (text == "both") return std::vector<Multipliers>{Multipliers::embedded, Multipliers::logic};
  std::vector<Multipliers> kinds;
  for (const std::string& word : words(text)) {
    std::optional<Multipliers> found;
    for (const Multipliers kind :
         {Multipliers::embedded, Multipliers::logic, Multipliers::memory}) {
      if (word == to_string(kind)) found = kind;
    }
    if (!found || std::find(kinds.begin(), kinds.end(), *found) != kinds.end()) {
      return mistake("--multipliers", found ? "given twice" : "not a choice", word,
                     "both, embedded, logic, memory, or several, such as logic,memory");
    }
    kinds.push_back(*found);
  }
  if (kinds.empty()) {
    return mistake("--multipliers", "not a choice", text, "both, embedded, logic, memory");
  }
  return kinds;
}

/// Reads "exact,rounded,20", each kind once. As many digits as the reference has are exact inputs.
Result<std::vector<LaneInputs>> kinds_of_inputs(const std::string& text, FloatFormat reference) {
  const int most = reference.precision();
  MIXCMP_TRY(chosen, parse_inputs("--inputs", words(text), most));
  std::vector<LaneInputs> kinds;
  for (const LaneInputs each : chosen) {
    const LaneInputs kind = each.in_lane(0, most);
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
  }
  return kinds;
}

/// Refuses a query that gives no lane: memories are only for lanes in fixed point.
Result<Done> check_memories(const components::ComponentQuery& query) {
  const bool memory_alone = query.multipliers == std::vector{Multipliers::memory};
  const bool any_fixed_point =
      std::any_of(query.bounds.begin(), query.bounds.end(),
                  [](const Bound& bound) { return bound.is_fixed_point(); });
  if (!memory_alone || any_fixed_point) return Done{};
  return mistake("--multipliers", "only lanes in fixed point read squares from memories", "memory",
                 "embedded, logic, or --bounds with fixed_norm or another of fixed point");
}

/// The kinds of components in the systems of a scene: those of an engine, or of lanes with streams.
std::set<ComponentKind> parts_of_system(const scene::Scene& scene) {
  std::set<ComponentKind> parts = {ComponentKind::lane, ComponentKind::reference,
                                   ComponentKind::reference_port};
  switch (scene.system.engine.kind) {
    case scene::EngineKind::none:
      parts.insert({ComponentKind::fifo, ComponentKind::crossbar});
      if (scene.second_tier) parts.insert(ComponentKind::second_lane);
      return parts;
    case scene::EngineKind::pairwise:
      parts.insert({ComponentKind::segment, ComponentKind::conversion, ComponentKind::engine});
      return parts;
    case scene::EngineKind::arg_min:
      parts.insert({ComponentKind::segment, ComponentKind::conversion, ComponentKind::engine,
                    ComponentKind::operand_memory, ComponentKind::crossbar});
      return parts;
  }
  MIXCMP_CHECK(false);
}

Result<std::set<ComponentKind>> component_kinds(const std::string& text,
                                                const scene::Scene& scene) {
  std::set<ComponentKind> possible = parts_of_system(scene);
  if (text.empty()) return possible;
  possible.insert(ComponentKind::unit);
  std::set<ComponentKind> kinds;
  for (const std::string& word : words(text)) {
    const auto found = std::find_if(possible.begin(), possible.end(),
                                    [&](ComponentKind kind) { return word == to_string(kind); });
    if (found == possible.end()) {
      std::vector<std::string_view> accepted;
      for (const ComponentKind kind : possible) accepted.push_back(to_string(kind));
      return mistake("--components", "not a component of this scene's systems", word,
                     fmt::format("{}", fmt::join(accepted, ", ")));
    }
    kinds.insert(*found);
  }
  return kinds;
}

Result<std::optional<components::LaneExponents>> exponents(const std::string& word) {
  using Choice = std::optional<components::LaneExponents>;
  if (word.empty()) return Choice();
  if (word == "reference") return Choice(components::LaneExponents::reference);
  if (word == "ranges") return Choice(components::LaneExponents::ranges);
  return mistake("--exponents", "not a choice", word, "reference, ranges");
}

/// The numbers of "7" or "4-9".
Result<std::pair<int, int>> interval(const std::string& option, const std::string& word,
                                     settings::Limits allowed) {
  const std::size_t dash = std::min(word.find('-'), word.size());
  const std::optional<int> first = number(std::string_view(word).substr(0, dash));
  const std::optional<int> last =
      dash == word.size() ? first : number(std::string_view(word).substr(dash + 1));
  if (first && last && allowed.allow(*first) && *first <= *last && allowed.allow(*last)) {
    return std::pair(*first, *last);
  }
  return mistake(
      option, "not a number or an interval of numbers in range", word,
      fmt::format("numbers {} and intervals, such as {}-{},{}", to_string(allowed), allowed.least,
                  std::min(allowed.least + 2, allowed.most), allowed.most));
}

/// The crossbars of a quick table: `optimise` interpolates between them.
constexpr std::string_view quick_ports = "1,8,32,64";

/// The intervals that are measured where the scene's is "auto": a reference that is not folded, one
/// with few units, and about the smallest one.
const std::vector<int> usual_intervals = {1, 4, 16};

Result<std::vector<int>> initiation_intervals(const std::string& text, const scene::Scene& scene) {
  if (!text.empty()) {
    return number_list("--initiation-intervals", text, settings::limits::initiation_interval);
  }
  const std::optional<int> interval = scene.reference_structure.initiation_interval;
  return interval ? std::vector<int>{*interval} : usual_intervals;
}

/// The targets where the scene names none for references: the system's, and half as much again. The
/// registers of the second cost little, and a reference must not limit the clock.
std::vector<std::optional<int>> usual_targets(const scene::Scene& scene) {
  const int more = static_cast<int>(std::lround(1.5 * scene.system.target_mhz));
  if (!settings::limits::target_mhz.allow(more)) return {std::nullopt};
  return {std::nullopt, more};
}

Result<std::vector<std::optional<int>>> reference_targets(const CharacteriseCommand& command,
                                                          const scene::Scene& scene) {
  using Targets = std::vector<std::optional<int>>;
  if (!command.reference_targets.empty()) {
    MIXCMP_TRY(targets, number_list("--reference-targets", command.reference_targets,
                                    settings::limits::target_mhz));
    return Targets(targets.begin(), targets.end());
  }
  const std::optional<int> target = scene.reference_structure.target_mhz;
  return target || command.area_only ? Targets{target} : usual_targets(scene);
}

std::vector<std::string> names_of_counted_bounds() {
  std::vector<std::string> names;
  for (const Bound& bound : counted_bounds()) names.push_back(to_string(bound));
  return names;
}

Result<components::ComponentQuery> query_of(const CharacteriseCommand& command,
                                            const scene::Scene& scene) {
  const settings::Limits allowed = settings::lane_precisions(scene.reference.format);
  components::ComponentQuery query;
  const std::string precisions = command.precisions.empty()
                                     ? fmt::format("{}-{}", allowed.least, allowed.most)
                                     : command.precisions;
  MIXCMP_TRY(numbers, number_list("--precisions", precisions, allowed));
  query.precisions = numbers;
  if (command.bounds.empty()) {
    query.bounds = scene::counted_bounds_of(scene);
  } else {
    MIXCMP_TRY(choices, parse_bounds("--bounds", words(command.bounds)));
    query.bounds = choices;
  }
  MIXCMP_TRY(inputs, kinds_of_inputs(command.inputs, scene.reference.format));
  query.inputs = inputs;
  MIXCMP_TRY(multipliers, multiplier_kinds(command.multipliers));
  query.multipliers = multipliers;
  MIXCMP_DO(check_memories(query));
  MIXCMP_TRY(intervals, initiation_intervals(command.initiation_intervals, scene));
  query.initiation_intervals = intervals;
  MIXCMP_TRY(targets, reference_targets(command, scene));
  query.reference_targets = targets;
  const bool few_ports = command.quick && command.ports == CharacteriseCommand().ports;
  MIXCMP_TRY(ports, number_list("--ports", few_ports ? std::string(quick_ports) : command.ports,
                                components::measured_ports));
  query.crossbars = ports;
  MIXCMP_TRY(kinds, component_kinds(command.components, scene));
  query.kinds = kinds;
  MIXCMP_TRY(chosen, exponents(command.exponents));
  query.exponents = chosen;
  return query;
}

/// Adds the option for a vendor's reports. It excludes the options that only a measurement needs.
void add_import_option(const Verb& verb, CharacteriseCommand& command) {
  const Option import = verb.option(
      "--import", command.reports,
      "measure nothing: take areas and a clock from the reports that the scripts of generate "
      "--project vivado or quartus leave, utilisation_by_instance.rpt and timing.rpt, or "
      "TOP.fit.rpt and TOP.sta.rpt (docs/choosing.md)");
  for (const char* other : {"--precisions", "--bounds", "--inputs", "--multipliers", "--exponents",
                            "--components", "--initiation-intervals", "--reference-targets",
                            "--ports", "--quick", "--area-only", "--seeds", "--jobs", "--store"}) {
    import.excludes(other);
  }
}

}  // namespace

Result<std::vector<int>> number_list(const std::string& option, const std::string& text,
                                     settings::Limits allowed) {
  std::set<int> numbers;
  for (const std::string& word : words(text)) {
    MIXCMP_TRY(ends, interval(option, word, allowed));
    for (int k = ends.first; k <= ends.second; ++k) numbers.insert(k);
  }
  return std::vector<int>(numbers.begin(), numbers.end());
}

void add_characterise_options(const Verb& verb, CharacteriseCommand& command) {
  add_scene_options(verb, command.scene,
                    {"--format", "--bound", "--inputs", "--lanes", "--references"});
  verb.option(
      "--precisions", command.precisions,
      fmt::format("of lanes: {}-{} or 8,12,17 (default: all that the scene can have)",
                  settings::limits::lane_precision.least, settings::limits::lane_precision.most));
  verb.option("--bounds", command.bounds,
              fmt::format("of lanes: {} (default: {}; also {} where an input has a grid)",
                          settings::bound_names(), fmt::join(names_of_counted_bounds(), ","),
                          to_string(grid_bound)));
  verb.option("--inputs", command.inputs,
              "of lanes: exact, rounded, digits that operands are rounded to, 20 (default: " +
                  command.inputs + ")");
  verb.option("--multipliers", command.multipliers,
              "embedded, logic or memory (only lanes in fixed point), or several: logic,memory "
              "(default: both, embedded and logic)");
  verb.option("--exponents", command.exponents,
              "exponent bits of lanes: reference, or ranges for the fewest that the declared "
              "ranges allow (default: as reduced.format says)");
  verb.option("--initiation-intervals", command.initiation_intervals,
              "of references, in cycles: 16 or 1,4,16 (default: as reference.initiation_interval "
              "says; 1,4,16 where that is \"auto\")");
  verb.option(
      "--reference-targets", command.reference_targets,
      "MHz that the registers of references are placed for: 400,600 (default: as "
      "reference.target_mhz says; without one the system's and, where clocks are asked for, "
      "half as much again)");
  verb.option("--components", command.components,
              "what to measure: lane, second_lane, fifo, crossbar; of an engine segment, "
              "conversion, engine, operand_memory; reference, reference_port; unit (default: all "
              "that the scene's systems have)");
  verb.option("--ports", command.ports,
              "lanes at one reference's crossbar (default: " + command.ports + ")");
  verb.flag("--quick", command.quick,
            "of these lanes the few that a rough model of areas and the rates on the data find "
            "promising, and crossbars of " +
                std::string(quick_ports) + " lanes unless --ports says otherwise");
  verb.flag("--area-only", command.area_only, "no clocks");
  verb.option("--seeds", command.seeds, "of the router (default: 3)")
      .check(within(settings::limits::seeds));
  verb.option("--jobs", command.jobs, "at a time (default: one a processor)")
      .check(within(settings::limits::threads));
  verb.option("-o,--output", command.output,
              "the table (default: characterisation/SCENE-DEVICE.csv beside the scene)");
  verb.option("--store", command.store,
              "results of all scenes, so that nothing is measured twice (default: "
              "$XDG_CACHE_HOME/mixcmp/characterisation.sqlite)");
  add_import_option(verb, command);
}

Result<components::CharacteriseOptions> characterise_options(const CharacteriseCommand& command,
                                                             const scene::Scene& scene) {
  components::CharacteriseOptions options;
  MIXCMP_TRY(query, query_of(command, scene));
  options.query = std::move(query);
  options.synthesis.effort = command.area_only ? characterise::TimingEffort::area_only
                                               : characterise::TimingEffort::timing;
  options.synthesis.seeds = command.seeds;
  options.workers =
      command.jobs > 0 ? command.jobs : std::max(1u, std::thread::hardware_concurrency());
  if (command.store.empty()) {
    MIXCMP_TRY(path, characterise::default_store_path());
    options.store = path;
  } else {
    options.store = std::filesystem::absolute(command.store);  // SQLite keeps ":memory:" in no file
  }
  return options;
}

const GroupForm& characterise_group() {
  static const GroupForm form{
      .name = "characterise",
      .options = {"precisions", "bounds", "inputs", "multipliers", "exponents",
                  "initiation_intervals", "reference_targets", "components", "ports", "seeds"},
      .flags = {"quick", "area_only"}};
  return form;
}

Result<CharacteriseCommand> characterise_command(const SuiteRun& run) {
  CharacteriseCommand command;
  std::vector<std::string> words = {run.scene.string()};
  words.insert(words.end(), run.options.begin(), run.options.end());
  const auto parsed =
      parse_words(words, [&](const Verb& verb) { add_characterise_options(verb, command); });
  if (!parsed.ok()) return mistake_in(run, parsed.error());
  return command;
}

CommandLine characterise_command_line(const CharacteriseCommand& command) {
  const CharacteriseCommand usual;
  std::vector<std::string> reports;
  for (const std::filesystem::path& report : command.reports) reports.push_back(report.filename());
  return command_line("characterise", command.scene)
      .add("--precisions", command.precisions, usual.precisions)
      .add("--bounds", command.bounds, usual.bounds)
      .add("--inputs", command.inputs, usual.inputs)
      .add("--multipliers", command.multipliers, usual.multipliers)
      .add("--exponents", command.exponents, usual.exponents)
      .add("--initiation-intervals", command.initiation_intervals, usual.initiation_intervals)
      .add("--reference-targets", command.reference_targets, usual.reference_targets)
      .add("--components", command.components, usual.components)
      .add("--ports", command.ports, usual.ports)
      .add("--seeds", std::to_string(command.seeds), std::to_string(usual.seeds))
      .add_all("--import", reports)
      .add_flag("--quick", command.quick)
      .add_flag("--area-only", command.area_only);
}

}  // namespace mixcmp::cli

#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/base/common/place.hpp"
#include "model/base/number/lane_format.hpp"
#include "model/base/number/operand_format.hpp"
#include "model/base/settings/limits.hpp"
#include "model/comparison/data/data_spec.hpp"
#include "model/comparison/expression/parser.hpp"
#include "model/comparison/expression/typed_graph.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "model/scene/engine.hpp"
#include "model/scene/scene_source.hpp"

namespace mixcmp::scene {

/// Order in which results of one lane leave.
enum class ResultOrder {
  tagged,    ///< results may overtake a recomputed one
  in_order,  ///< a reorder buffer per lane
};

/// The source of a recomputation's operands.
enum class OperandStore {
  carried,    ///< kept in a memory of the system
  refetched,  ///< fetched from the user's memory by tag
};

/// The kind of memory in which carried operands wait.
enum class OperandMemory {
  logic,  ///< chosen by synthesis; on most devices look-up tables
  block,  ///< block memories
};

/// The way in which a system's counters are read.
enum class CounterAccess {
  none,      ///< there are no counters
  ports,     ///< each counter is an output of the top
  axi_lite,  ///< software reads them all on an AXI4-Lite port
};

/// How the multipliers of a datapath are built.
enum class Multipliers {
  embedded,  ///< the device's multiplier blocks, if synthesis finds any
  logic,     ///< rows of carry chains, on any device
  memory,    ///< in fixed-point lanes: squares are read from block memories, products are logic
};
inline constexpr std::array all_multipliers = {Multipliers::embedded, Multipliers::logic,
                                               Multipliers::memory};

/// The words of scene files, options and reports.
std::string_view to_string(ResultOrder order);
std::string_view to_string(OperandStore store);
std::string_view to_string(OperandMemory memory);
std::string_view to_string(CounterAccess access);
std::string_view to_string(Multipliers multipliers);
/// The word of `multipliers`; empty if there is no value.
std::string_view to_string(const std::optional<Multipliers>& multipliers);

struct ReducedSpec {
  std::optional<FloatFormat> format;      ///< none: "auto", or fixed point
  std::optional<FixedPoint> fixed_point;  ///< written as "q13", "block13", "q13g3"
  /// Written as "exact": `fixed_point` has the fewest bits with which the lane has no error.
  bool is_exact = false;
  /// Written as "s17": the format has the fewest exponent bits that the ranges allow.
  bool exponent_bits_from_ranges = false;
  bool is_profiled = false;              ///< `bound`: by errors measured on data, without a proof
  std::optional<BoundKind> error_bound;  ///< kind of a certified bound; none: "auto"
  int bound_digits = 4;                  ///< digits of a running bound, 1..8; 1: only exponents
  LaneInputs inputs = LaneInputs::exact;
  Rounding rounding = Rounding::nearest_even;
  Subnormals subnormals = Subnormals::flush;
  Multipliers multipliers = Multipliers::embedded;
  /// The paper's RE_f and RE_g; none: measured on the scene's data.
  std::optional<mpq_class> relative_error_f;
  std::optional<mpq_class> relative_error_g;

  std::string format_name() const;            ///< "s17e8", "q13", "block13" or "auto"
  std::string_view bound_word() const;        ///< "certified" or "profiled"
  std::string_view error_bound_word() const;  ///< such as "running", or "auto"
  /// `inputs` with this reference, by the only name that they have in this lane. Fixed point has no
  /// choice of inputs: its operands are taken unchanged.
  LaneInputs inputs_beside(FloatFormat reference) const;
};

inline constexpr int max_lanes = settings::limits::lanes.most;
inline constexpr int max_references = settings::limits::references.most;

/// Lanes of one kind.
struct LaneGroupSpec {
  std::optional<int> count;  ///< none: "auto"
  ReducedSpec reduced;
  Place place;
};

/// How a scene asks for references to be built. Their results do not depend on it.
struct ReferenceStructureSpec {
  Multipliers multipliers = Multipliers::embedded;
  /// Cycles from one comparison to the next, 1..64; none: "auto"
  std::optional<int> initiation_interval = 1;
  std::optional<int> target_mhz;  ///< for placing its registers; none: the system's
};

/// References of one kind; all have the scene's reference format.
struct ReferenceGroupSpec {
  std::optional<int> count;  ///< none: "auto"
  ReferenceStructureSpec structure;
};

struct SystemSpec {
  std::string device = "virtex6-lx760";
  std::optional<int> lanes;       ///< p_L without [[lanes]]; none: "auto"
  std::optional<int> references;  ///< p_H without [[references]]; none: "auto"; 0: undecided
                                  ///< comparisons are reported as such
  double slack = 0.2;             ///< R_S: share of the device that is left unused
  double target_mhz = 200;
  bool has_own_target = false;  ///< false: target_mhz is that of the device's family
  int lanes_per_group = 1;  ///< lanes in lock step, 1..64; in an engine 1: it has its own groups
  int input_registers = 0;  ///< between the operands' ports and a lane, 0..2; 0 in an engine
  ResultOrder order = ResultOrder::tagged;
  OperandStore operands = OperandStore::carried;
  OperandMemory operand_memory = OperandMemory::logic;  ///< for carried operands
  /// Beats of a request for carried operands, a power of two; none: "auto"
  std::optional<int> request_beats;
  int tag_bits = 32;                              ///< 1..64
  int counter_bits = 32;                          ///< 0 (no counters) or 8..64; 16..64 for axi_lite
  CounterAccess counters = CounterAccess::ports;  ///< `none` if counter_bits is 0
  std::string prefix = "mixcmp_";  ///< begins the name of every generated module but the top
  /// The engine around the system. An engine sets `operands` and `tag_bits`; an arg_min engine also
  /// sets `order`: see with_engine.
  EngineSpec engine;
};

/// Puts the system on another device, whose family's target_mhz it takes unless it has its own. An
/// unknown device changes no target: find_device reports it where the device is used.
void use_device(SystemSpec& system, const std::string& device);

/// The system with an engine around it. A pairwise engine's memory holds the operands of a
/// recomputation, and a tag names two items in it. An arg_min engine needs verdicts in order.
SystemSpec with_engine(SystemSpec system, const EngineSpec& engine);

/// The keys and values of a plan's [plan] section, as text for display. They have no other effect.
struct PlanNotes {
  std::filesystem::path path;
  std::vector<std::pair<std::string, std::string>> values;
};

inline constexpr std::size_t max_parts = 64;  ///< most parts of a comparison

/// The expressions of one part, as written, each on one line.
struct PartText {
  std::string f;
  std::string g;
};

/// One validated scene file, or a plan with its scene. docs/scene_file.md is the user's view of it.
struct Scene {
  std::filesystem::path path;
  std::vector<std::string> settings;  ///< "section.key=value": the overrides applied
  std::string name;                   ///< comparison.name and the variant's; names the modules
  std::string variant;                ///< the chosen [[variant]] or move; empty: only [comparison]
  /// Names of all variants, or of the formulations that mixcmp finds by itself (moves.hpp): scenes
  /// with [[variant]] have none of those.
  std::vector<std::string> variants;
  bool variants_are_moves = false;
  std::vector<PartText> parts;      ///< one per part of the graph
  std::vector<LetDefinition> lets;  ///< those that f and g need, as written, each on one line
  Graph graph;
  std::vector<std::optional<Range>> ranges;     ///< one per graph input
  std::vector<std::optional<mpq_class>> grids;  ///< one per graph input: a power of two
  std::vector<bool> data_ranges;  ///< one per graph input: its range is that of its data
  /// One per graph input: the format in which it arrives, all of whose numbers `reference.format`
  /// holds. The graph knows those in floating point that differ from `reference.format`.
  std::vector<OperandFormat> operand_formats;
  /// The model of references, which rounds to nearest even, and the format of operands.
  Arithmetic reference;
  /// References compute in fixed point of so many bits, written as "q40". None: in the format of
  /// `reference`, or exactly where operands arrive in fixed point.
  std::optional<FixedPoint> reference_fixed_point;
  ReferenceStructureSpec reference_structure;  ///< used if there is no [[references]]
  ReducedSpec reduced;
  std::vector<LaneGroupSpec> lanes;  ///< [[lanes]]; empty: system.lanes times `reduced`
  /// [second_tier]: the lanes that are asked before a reference is. None: undecided comparisons go
  /// to a reference at once.
  std::optional<ReducedSpec> second_tier;
  /// Their number in a system of streams; none: "auto". An engine has one for each group.
  std::optional<int> second_tier_count;
  bool leaves_out_second_tier = false;  ///< second_tier.format is "none"; not of an arg-min engine
  std::vector<ReferenceGroupSpec> references;  ///< [[references]]; empty: system.references
  SystemSpec system;
  std::optional<data::DataSpec> data;
  std::optional<PlanNotes> plan;  ///< none if the scene was read without one
  /// Remarks for the user: inexact constants, unused ranges, ...
  std::vector<std::string> notes;

  /// The texts of f (or g) of all parts on one line, separated by semicolons.
  std::string f_text() const;
  std::string g_text() const;

  bool has_fixed_operands() const;       ///< whether any input arrives in fixed point
  bool has_only_fixed_operands() const;  ///< whether all inputs do
  LaneFormat format_of_reference() const;
  /// Why no lane may be in floating point; none if one may be.
  std::optional<std::string> why_no_float_lane() const;
  /// Whether the datapath of references is in fixed point.
  bool has_fixed_references() const { return reference_fixed_point || has_only_fixed_operands(); }
  /// Whether any input in floating point is promised to hold only multiples of a grid.
  bool has_promised_grids() const;

  /// Tells for each input whether its declared range excludes negative values.
  std::vector<bool> nonnegative_inputs() const;

  /// Groups as in [[lanes]], or the one group of [reduced] and system.lanes.
  std::vector<LaneGroupSpec> lane_groups() const;
  /// Groups as in [[references]], or the one group of [reference] and system.references; with p_H =
  /// 0 that is one group of 0 references.
  std::vector<ReferenceGroupSpec> reference_groups() const;
  std::optional<int> lane_count() const;       ///< p_L; none: "auto"
  std::optional<int> reference_count() const;  ///< p_H; none: "auto"
  /// The scene with one group of lanes, as in [reduced], and one group of references. Measurements
  /// of a single datapath start from it.
  Scene with_one_kind() const;
};

/// Reads a scene, or a plan with its scene. `overrides` are "section.key=value" settings with TOML
/// values (a bare word counts as a string). They are applied before validation, and errors in them
/// name "--set" instead of a line.
Result<Scene> load_scene(const SceneSource& source, std::span<const std::string> overrides);

}  // namespace mixcmp::scene

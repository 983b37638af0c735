#pragma once

#include <array>
#include <compare>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "model/base/number/bound.hpp"
#include "model/base/number/lane_format.hpp"
#include "model/base/number/lane_inputs.hpp"
#include "model/scene/scene.hpp"

/// The components of systems, each with the properties on which its hardware depends. A type with
/// `count` has a number of equal parts; components that differ only in it are sizes of each other.
namespace mixcmp::measured {

/// The names of the types below in tables and options, in the order in which tables list them.
enum class ComponentKind {
  unit,
  lane,
  reference,
  fifo,
  crossbar,
  reference_port,
  second_lane,
  segment,
  conversion,
  engine,
  operand_memory,
};
std::string_view to_string(ComponentKind kind);

inline constexpr std::array component_kinds = {
    ComponentKind::unit,        ComponentKind::lane,          ComponentKind::reference,
    ComponentKind::fifo,        ComponentKind::crossbar,      ComponentKind::reference_port,
    ComponentKind::second_lane, ComponentKind::segment,       ComponentKind::conversion,
    ComponentKind::engine,      ComponentKind::operand_memory};

/// One floating-point or bound unit; for information only.
struct Unit {
  static constexpr ComponentKind kind = ComponentKind::unit;
  std::string name;  ///< its template and formats

  friend auto operator<=>(const Unit&, const Unit&) = default;
};

/// One reduced datapath by itself; in an engine without the conversion.
struct Lane {
  static constexpr ComponentKind kind = ComponentKind::lane;
  LaneFormat format;
  std::optional<LaneInputs> inputs;  ///< in floating point
  Bound bound;
  std::optional<scene::Multipliers> multipliers;  ///< none in a datapath without a product

  friend bool operator==(const Lane&, const Lane&) = default;
  /// By the formats' names: "s12e8" comes before "s8e8".
  friend std::strong_ordering operator<=>(const Lane& a, const Lane& b);
};

/// One reference datapath by itself.
struct Reference {
  static constexpr ComponentKind kind = ComponentKind::reference;
  LaneFormat format;                              ///< in floating or in fixed point
  std::optional<scene::Multipliers> multipliers;  ///< none in a datapath without a product
  Sums sums = Sums::composed;
  int initiation_interval = 1;    ///< in cycles
  std::optional<int> target_mhz;  ///< if other than the table's

  friend bool operator==(const Reference&, const Reference&) = default;
  /// By the formats' names, as for lanes.
  friend std::strong_ordering operator<=>(const Reference& a, const Reference& b);
};

/// The scoreboard or reorder buffer around one lane or group of lanes.
struct Fifo {
  static constexpr ComponentKind kind = ComponentKind::fifo;
  int slots = 0;
  static constexpr int Fifo::*count = &Fifo::slots;

  friend auto operator<=>(const Fifo&, const Fifo&) = default;
};

/// One reference's share of the crossbar when it serves so many lanes or groups.
struct Crossbar {
  static constexpr ComponentKind kind = ComponentKind::crossbar;
  int lanes = 0;
  static constexpr int Crossbar::*count = &Crossbar::lanes;

  friend auto operator<=>(const Crossbar&, const Crossbar&) = default;
};

/// The streams around one reference.
struct ReferencePort {
  static constexpr ComponentKind kind = ComponentKind::reference_port;
  Reference reference;

  friend auto operator<=>(const ReferencePort&, const ReferencePort&) = default;
};

/// In a system of streams: a lane of its second tier with its slots.
struct SecondLane {
  static constexpr ComponentKind kind = ComponentKind::second_lane;
  Lane lane;
  int slots = 0;
  static constexpr int SecondLane::*count = &SecondLane::slots;

  friend auto operator<=>(const SecondLane&, const SecondLane&) = default;
};

/// In an engine: lanes with all logic that only they use. Lanes of a pairwise engine work in lock
/// step and share that logic; a lane of an arg-min engine has its own.
struct Segment {
  static constexpr ComponentKind kind = ComponentKind::segment;
  Lane lane;
  int lanes = 0;
  static constexpr int Segment::*count = &Segment::lanes;

  friend auto operator<=>(const Segment&, const Segment&) = default;
};

/// In an engine: computes the words of items and rows when they come in.
struct Conversion {
  static constexpr ComponentKind kind = ComponentKind::conversion;
  Lane lane;

  friend auto operator<=>(const Conversion&, const Conversion&) = default;
};

/// In an engine with so many segments: all other logic, except crossbar and references.
struct Engine {
  static constexpr ComponentKind kind = ComponentKind::engine;
  Lane lane;
  int segments = 0;
  static constexpr int Engine::*count = &Engine::segments;

  friend auto operator<=>(const Engine&, const Engine&) = default;
};

/// In an arg-min engine: full rows and candidates for so many references.
struct OperandMemory {
  static constexpr ComponentKind kind = ComponentKind::operand_memory;
  int references = 0;
  static constexpr int OperandMemory::*count = &OperandMemory::references;

  friend auto operator<=>(const OperandMemory&, const OperandMemory&) = default;
};

/// Identifies a synthesised component in a table. Tables are sorted by it.
using ComponentKey = std::variant<Unit, Lane, Reference, Fifo, Crossbar, ReferencePort, SecondLane,
                                  Segment, Conversion, Engine, OperandMemory>;

ComponentKind kind_of(const ComponentKey& key);
/// The lane on which a component depends; null if it depends on none.
const Lane* lane_of(const ComponentKey& key);
Lane* lane_of(ComponentKey& key);
/// The reference on which a component depends; null if it depends on none.
const Reference* reference_of(const ComponentKey& key);
Reference* reference_of(ComponentKey& key);
/// The key of the same component if its datapath has no product.
ComponentKey without_multipliers(ComponentKey key);
/// The number of a component's parts: slots, lanes, segments, references; none for other kinds.
std::optional<int> count_of(const ComponentKey& key);

/// A component that has a number of equal parts.
template <class Component>
concept Counted = requires {
  Component::count;
};

}  // namespace mixcmp::measured

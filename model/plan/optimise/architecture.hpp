#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/base/settings/settings.hpp"
#include "model/scene/scene.hpp"

/// The choices around lanes and references: what stands between them and the user.
namespace mixcmp::optimise {

/// The keys that a scene leaves open: neither the file nor --set gives them, or they are "auto".
struct OpenKeys {
  bool operands = false;
  bool operand_memory = false;
  bool request_beats = false;
  bool lanes_per_group = false;
  bool counters = false;  ///< neither system.counters nor system.counter_bits is given
  bool initiation_interval = false;
  bool references = false;  ///< their number
  bool engine = false;      ///< there is no [engine]
  bool engine_lanes_per_group = false;
  bool report_streams = false;
};
OpenKeys open_keys(const settings::Settings& settings);

/// One choice of all these keys, with the values of those that are given.
struct Architecture {
  scene::OperandStore operands = scene::OperandStore::carried;
  scene::OperandMemory operand_memory = scene::OperandMemory::logic;
  std::optional<int> request_beats;
  int lanes_per_group = 1;  ///< of streams, or of a pairwise engine
  int report_streams = 1;   ///< of a pairwise engine
  scene::CounterAccess counters = scene::CounterAccess::ports;

  friend bool operator==(const Architecture&, const Architecture&) = default;
};

/// The architectures among which a plan of this scene chooses. The scene's engine is the one that
/// they surround; open keys get each of their usual values, others keep the scene's.
std::vector<Architecture> architectures_of(const scene::Scene& scene, const OpenKeys& open);

/// The scene with this architecture, and with an open interval of references.
scene::Scene with_architecture(scene::Scene scene, const Architecture& architecture,
                               const OpenKeys& open);

/// The settings ("section.key=value") of the open keys that make this architecture of the scene.
std::vector<std::string> settings_of(const Architecture& architecture, const scene::Scene& scene,
                                     const OpenKeys& open);

/// What the user's side of a system is, in words: "operands carried, counters", "pairwise engine,
/// no counters". Systems of one interface can replace each other.
std::string interface_of(const scene::Scene& scene);

/// Whether system `a` has the interface of system `b`, or that with fewer streams of reports.
bool asks_no_more(const scene::SystemSpec& a, const scene::SystemSpec& b);

}  // namespace mixcmp::optimise

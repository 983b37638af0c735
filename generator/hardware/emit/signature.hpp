#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/hardware/rtl/module.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::emit {

/// A port of the top module.
struct SignaturePort {
  std::string name;
  rtl::Direction direction = rtl::Direction::input;
  int width = 1;

  bool is_clock_or_reset() const { return name == "aclk" || name == "aresetn"; }
  /// Whether the port belongs to the AXI4-Lite port of the counters.
  bool is_counter_bus() const { return name.starts_with("s_axi_"); }
};

/// Counters of one kind, as software reads them.
struct SignatureCounters {
  std::string name;
  int count = 1;
  int offset = 0;  ///< bytes; 8 more for each further counter, the low word of 32 bits first
};

/// The greatest length of a module's name that every tool takes. Verilator replaces longer names by
/// hashes. It then finds neither the top that it was given nor a file of the module's name. IEEE
/// 1364 lets tools stop at 1024. No lower limit is known of Vivado, Quartus, Icarus or Yosys. File
/// systems take names of 255 bytes, so there is room for any extension of the module's file.
inline constexpr std::size_t longest_module_name = 127;

/// The name of a test bench is that of the outermost module with this suffix.
inline constexpr std::string_view bench_suffix = "_tb";

/// The name of a channel is that of its datapath's module with this suffix.
inline constexpr std::string_view channel_suffix = "_channel";

/// Lanes of one kind.
struct SignatureLanes {
  int count = 0;
  std::string module;  ///< the channel: one lane with its scoreboard or reorder buffer
  std::string format;  ///< "s17e8" or, in fixed point, "q13"
  int latency_cycles = 0;
  bool certified = false;
  std::string decision;  ///< when a lane decides, in words
  LaneInputs inputs = LaneInputs::exact;
  scene::Multipliers multipliers = scene::Multipliers::embedded;
};

/// References of one kind.
struct SignatureReferences {
  int count = 0;
  std::string module;  ///< the channel: one reference behind the crossbar
  std::string format;  ///< "s53e11" or, in fixed point, "q9"
  int latency_cycles = 0;
  int initiation_interval_cycles = 1;
  scene::Multipliers multipliers = scene::Multipliers::embedded;
};

/// The engine around the system: it generates the comparisons that the system's lanes take.
struct SignatureEngine {
  scene::EngineKind kind = scene::EngineKind::none;
  std::string top;                   ///< the module; the system is inside
  int capacity = 0;                  ///< the most items of a set, or candidates
  int index_bits = 0;                ///< width of an item's or candidate's number
  std::vector<std::string> columns;  ///< an item's, side by side in tdata, the first lowest
  std::vector<OperandFormat> column_formats;
  int item_bytes = 0;               ///< bytes of an item, padded
  std::vector<std::string> report;  ///< pairwise: the verdicts whose pairs are reported
  scene::ReportForm report_as = scene::ReportForm::pairs;  ///< pairwise
  int report_streams = 1;                     ///< pairwise: streams m_axis side by side
  int report_lanes = 1;                       ///< pairwise: flags of a beat of a bitmap
  int report_bytes = 0;                       ///< pairwise: tdata of one stream
  std::vector<std::string> row_columns = {};  ///< arg_min: a row's, packed like `columns`
  std::vector<OperandFormat> row_column_formats = {};
  int row_bytes = 0;  ///< arg_min: bytes of a row, padded
  int tag_bits = 0;   ///< arg_min: width of a row's tag
  std::vector<SignaturePort> ports;
};

/// The run of `mixcmp verify` that is on record for a design and a simulator.
struct SignatureSimulation {
  std::string simulator;
  std::uint64_t comparisons = 0;
  std::uint64_t recomputations = 0;
  bool passed = false;
};

/// The properties of a generated system that a testbench or an integrator needs; printed as
/// <top>.json.
struct Signature {
  std::string top;
  std::string generator_version;
  std::string spec_hash;  ///< hash of everything that decides the output's bytes
  FloatFormat reference_format;
  Sums reference_sums = Sums::composed;
  bool certified = false;                      ///< whether all lanes are
  std::vector<scene::PartText> parts = {};     ///< f and g of each part, as the scene writes them
  Combination combination = Combination::all;  ///< meaningful only if there are several parts
  std::vector<LetDefinition> lets = {};        ///< those that f and g need
  std::vector<std::string> inputs;             ///< side by side in tdata, the first lowest
  std::vector<OperandFormat> input_formats;    ///< one per input
  int lanes = 0;  ///< p_L: every per-lane port is a vector of `lanes` fields, lane 0 lowest
  /// Lanes that share handshakes, tag and counters: these ports have a field for each group.
  int lanes_per_group = 1;
  int references = 0;  ///< p_H
  /// Lanes are numbered through their groups, in order. References are numbered in the same way.
  std::vector<SignatureLanes> lane_groups;
  std::vector<SignatureReferences> reference_groups;  ///< empty: p_H = 0
  int tdata_bytes = 0;  ///< operands of one comparison, padded to whole bytes
  int tag_bits = 0;
  int counter_bits = 0;
  /// The address map of the counters on the AXI4-Lite port s_axi; empty if the counters are ports,
  /// or if there are none.
  std::vector<SignatureCounters> counter_map = {};
  int slots = 0;            ///< comparisons that may be inside one lane's channel
  int input_registers = 0;  ///< between the ports of operands and each lane
  int request_beats = 1;    ///< beats of a request of carried operands
  scene::ResultOrder order = scene::ResultOrder::tagged;
  scene::OperandStore operands = scene::OperandStore::carried;
  double target_mhz = 0;
  /// The ports in the order of the module's header. The clock is aclk; aresetn is synchronous and
  /// active low; the initiation interval of a lane is one cycle.
  std::vector<SignaturePort> ports;
  /// The lanes of a second tier: behind a crossbar, or one behind each group of a pairwise engine.
  std::optional<SignatureLanes> second_tier = {};
  std::optional<SignatureEngine> engine;
  std::vector<std::string> files;  ///< Verilog, in compile order, relative to the signature
  /// Verilog that Yosys takes in place of some of `files` on the design's device.
  std::vector<std::string> cells;
  /// Files for other tools, relative to the signature (generator/project).
  std::vector<std::string> project = {};
  /// The runs of this very design that were on record when `mixcmp generate` wrote the files.
  std::vector<SignatureSimulation> simulations = {};
};

/// The number of groups of lanes in lock step. A lane without a group counts as one.
inline int group_count(const Signature& signature) {
  return signature.lanes / signature.lanes_per_group;
}

/// The number of streams m_refetch and s_refetch of a system: first those of its references, then
/// those of its second tier. 0 if operands are carried.
int refetch_streams(const Signature& signature);

/// Whether the counters are outputs of the top.
inline bool has_counter_ports(const Signature& signature) {
  return signature.counter_bits > 0 && signature.counter_map.empty();
}

/// Bits of an address on s_axi; 0 without it.
int counter_address_bits(const Signature& signature);
/// The number of references whose answers are counted.
int counted_answers(const Signature& signature);

nlohmann::ordered_json to_json(const SignatureSimulation& run);
/// Reads the output of to_json. Other JSON gives nothing.
std::optional<SignatureSimulation> simulation_in(const nlohmann::ordered_json& json);

std::string to_json(const Signature& signature);
/// Reads the file that to_json was printed to. Errors name the file and the field.
Result<Signature> read_signature(const std::filesystem::path& path);

}  // namespace mixcmp::emit

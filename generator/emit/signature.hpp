#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/scene/scene.hpp"

namespace mixcmp::gen {

/// A port of the top module.
struct SignaturePort {
  std::string name;
  std::string direction;  ///< "input" or "output"
  int width = 1;
};

/// What a testbench or an integrator must know of a generated system; printed as <top>.json.
struct Signature {
  std::string top;
  std::string channel_module;    ///< one lane with its scoreboard; instantiated p_L times
  std::string reference_module;  ///< instantiated p_H times; empty where p_H = 0
  std::string generator_version;
  std::string spec_hash;  ///< of everything that decides the output's bytes
  model::FloatFormat lane_format;
  model::FloatFormat reference_format;
  bool certified = false;
  std::vector<std::string> inputs;  ///< input k is tdata[k * width +: width]
  int lanes = 0;        ///< p_L: every per-lane port is a vector of `lanes` fields, lane 0 lowest
  int references = 0;   ///< p_H
  int tdata_bytes = 0;  ///< operands of one comparison, padded to whole bytes
  int tag_bits = 0;
  int counter_bits = 0;
  int slots = 0;  ///< comparisons that may be inside one lane's channel
  int lane_latency_cycles = 0;
  int reference_latency_cycles = 0;
  model::ResultOrder order = model::ResultOrder::tagged;
  model::OperandStore operands = model::OperandStore::carried;
  double target_mhz = 0;
  /// In the order of the module's header. The clock is aclk; aresetn is synchronous and active low;
  /// the initiation interval of a lane is one cycle.
  std::vector<SignaturePort> ports;
  std::vector<std::string> files;  ///< Verilog, in compile order, relative to the signature
};

std::string to_json(const Signature& signature);
/// Errors name the file and the field.
model::Result<Signature> read_signature(const std::filesystem::path& path);

}  // namespace mixcmp::gen

#pragma once

#include <string>
#include <vector>

#include "generator/hardware/emit/signature.hpp"

namespace mixcmp::verilator_tb {

/// The top module that is simulated, and the harness that drives it.
struct Bench {
  std::string top;
  const char* main;   ///< the harness's source with the function main
  std::string model;  ///< text of system_model.hpp: the top's numbers, and its ports in the model
  std::vector<emit::SignaturePort> ports;
};

Bench bench_of(const emit::Signature& signature);

}  // namespace mixcmp::verilator_tb

#pragma once

#include <string>

#include "generator/emit/signature.hpp"

namespace mixcmp::verilator_tb {

/// The top module that is simulated, and the harness that drives it.
struct Bench {
  std::string top;
  const char* main;   ///< the harness's source with the function main
  std::string ports;  ///< text of system_ports.hpp: constants and ports of the top
};

Bench bench_of(const emit::Signature& signature);

}  // namespace mixcmp::verilator_tb

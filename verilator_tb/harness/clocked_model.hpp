#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "clocked_block.hpp"
#include "settings.hpp"
#include "system_ports.hpp"
#include "verilated.h"

#if VM_TRACE
#include "verilated_fst_c.h"
#endif

namespace mixcmp::harness {

/// The verilated model with its clock and its waves.
class ClockedModel {
public:
  ClockedModel(const Settings& settings, int count, char** words) {
    context_.commandArgs(count, words);
    context_.randReset(2);
    context_.randSeed(static_cast<int>(settings.seed % 0x7fffffff + 1));
    model_ = std::make_unique<system::Model>(&context_);
  }

  ~ClockedModel() {
    model_->final();
#if VM_TRACE
    if (trace_) trace_->close();
#endif
    clocked_blocks().clear();  // before the context, to which their models belong
  }

  system::Model& model() {
    return *model_;
  }
  /// Whether an output is neither 0 nor 1 where that matters: Verilator has no such values.
  bool has_unknown() const {
    return false;
  }

  /// Lowers the clock. Inputs are changed while it is high, outputs are read while it is low.
  void settle(std::uint64_t cycle) {
    model_->aclk = 0;
    evaluate(2 * cycle);
  }
  void rise(std::uint64_t cycle) {
    model_->aclk = 1;
    evaluate(2 * cycle + 1);
  }

  void open_trace([[maybe_unused]] const std::string& path) {
#if VM_TRACE
    if (path.empty()) return;
    context_.traceEverOn(true);
    model_->eval();  // makes the blocks
    trace_ = std::make_unique<VerilatedFstC>();
    model_->trace(trace_.get(), 99);
    for (const auto& block : clocked_blocks()) block->trace(trace_.get());
    trace_->open(path.c_str());
#endif
  }

private:
  void evaluate([[maybe_unused]] std::uint64_t time) {
    model_->eval();
#if VM_TRACE
    if (trace_) trace_->dump(time);
#endif
  }

  VerilatedContext context_;
  std::unique_ptr<system::Model> model_;
#if VM_TRACE
  std::unique_ptr<VerilatedFstC> trace_;
#endif
};

}  // namespace mixcmp::harness

// The model that Verilator makes of a system.

#include "clocked_model.hpp"

#include "blocks.hpp"
#include "clocked_block.hpp"
#include "system_model.hpp"
#include "verilated.h"

#if VM_TRACE
#include "verilated_fst_c.h"
#endif

namespace mixcmp::harness {

struct ClockedModel::Model {
  VerilatedContext context;
  std::unique_ptr<Vsystem> top;
#if VM_TRACE
  std::unique_ptr<VerilatedFstC> trace;
#endif

  void evaluate([[maybe_unused]] std::uint64_t time) {
    top->eval();
#if VM_TRACE
    if (trace) trace->dump(time);
#endif
  }
};

ClockedModel::ClockedModel(const Settings& settings, int count, char** words)
    : model_(std::make_unique<Model>()) {
  model_->context.commandArgs(count, words);
  model_->context.randReset(2);
  model_->context.randSeed(static_cast<int>(settings.seed % 0x7fffffff + 1));
  model_->top = std::make_unique<Vsystem>(&model_->context);
}

ClockedModel::~ClockedModel() {
  model_->top->final();
#if VM_TRACE
  if (model_->trace) model_->trace->close();
#endif
  clocked_blocks().clear();  // before the context, to which their models belong
}

template <>
system::TopPorts ClockedModel::ports() {
  return system::ports_of(*model_->top);
}

const std::set<std::uint32_t>& ClockedModel::unknown_streams() const {
  static const std::set<std::uint32_t> none;
  return none;
}

void ClockedModel::settle(std::uint64_t cycle) {
  model_->top->aclk = 0;
  model_->evaluate(2 * cycle);
}

void ClockedModel::rise(std::uint64_t cycle) {
  model_->top->aclk = 1;
  model_->evaluate(2 * cycle + 1);
}

void ClockedModel::open_trace([[maybe_unused]] const std::string& path) {
#if VM_TRACE
  if (path.empty()) return;
  model_->context.traceEverOn(true);
  model_->top->eval();  // makes the blocks
  model_->trace = std::make_unique<VerilatedFstC>();
  model_->top->trace(model_->trace.get(), 99);
  for (const auto& block : clocked_blocks()) block->trace(model_->trace.get());
  model_->trace->open(path.c_str());
#endif
}

}  // namespace mixcmp::harness

#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "svdpi.h"
#include "verilated.h"

#if VM_TRACE
#include "verilated_fst_c.h"
#endif

namespace mixcmp::harness {

/// One instance of a module that was verilated by itself; its stub in the system calls clock() at
/// every rising edge.
class ClockedBlock {
public:
  explicit ClockedBlock(std::string scope) : scope_(std::move(scope)) {}
  virtual ~ClockedBlock() = default;

  /// One cycle: `d` are the inputs before the edge, `q` becomes the outputs behind it.
  virtual void clock(const svBitVecVal* d, svBitVecVal* q) = 0;

  /// Passes on the inputs with the clock low. clock() does so itself. A simulator with waves also
  /// calls this at falling edges, where its waves are taken.
  virtual void settle(const svBitVecVal* d) = 0;

#if VM_TRACE
  virtual void trace(VerilatedFstC* waves) = 0;
#endif

protected:
  [[noreturn]] void refuse() const {
    std::fprintf(stderr, "%s: an output depends on an input of the same cycle\n", scope_.c_str());
    std::abort();
  }

  std::string scope_;
};

/// `Model` has the ports aclk, d (all inputs) and q (all outputs).
template <class Model>
class VerilatedBlock : public ClockedBlock {
public:
  explicit VerilatedBlock(const std::string& scope)
      : ClockedBlock(scope), model_(Verilated::threadContextp(), scope.c_str()) {
    model_.aclk = 0;
    model_.eval();
  }
  ~VerilatedBlock() override { model_.final(); }

  void settle(const svBitVecVal* d) override {
    const auto before = model_.q;
    std::memcpy(&model_.d, d, sizeof model_.d);
    model_.aclk = 0;
    model_.eval();
    // In the first cycle, inputs that never change reach the outputs for the first time.
    if (clocked_ && std::memcmp(&before, &model_.q, sizeof before) != 0) refuse();
  }

  void clock(const svBitVecVal* d, svBitVecVal* q) override {
    settle(d);
    clocked_ = true;
    model_.aclk = 1;
    model_.eval();
    std::memcpy(q, &model_.q, sizeof model_.q);
  }

#if VM_TRACE
  void trace(VerilatedFstC* waves) override {
    model_.trace(waves, 99);
  }
#endif

private:
  Model model_;
  bool clocked_ = false;
};

/// All blocks of the simulator, in the order in which their stubs made them.
inline std::vector<std::unique_ptr<ClockedBlock>>& clocked_blocks() {
  static std::vector<std::unique_ptr<ClockedBlock>> blocks;
  return blocks;
}

#if VM_TRACE
/// Whether waves have a scope for each word of a model's name, as with Verilator 5.006. Later
/// versions (5.032) make a scope of only the last word.
template <class Waves>
constexpr bool words_are_scopes = !requires {
  &Waves::pushPrefix;
};
#endif

/// Makes the block of the stub that is calling.
template <class Model>
ClockedBlock* make_block() {
  std::string scope = svGetNameFromScope(svGetScope());
#if VM_TRACE
  if (words_are_scopes<VerilatedFst>) std::replace(scope.begin(), scope.end(), '.', ' ');
#endif
  clocked_blocks().push_back(std::make_unique<VerilatedBlock<Model>>(scope));
  return clocked_blocks().back().get();
}

}  // namespace mixcmp::harness

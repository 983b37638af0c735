// The model of a system in an event-driven simulator.

#include "clocked_model.hpp"
#include "system_model.hpp"

namespace mixcmp::harness {

struct ClockedModel::Model {
  Vsystem top;

  void evaluate(std::uint8_t clock) {
    top.aclk[0] = clock;
    top.eval();
  }
};

ClockedModel::ClockedModel(const Settings&, int, char**) : model_(std::make_unique<Model>()) {}
ClockedModel::~ClockedModel() = default;

template <>
system::TopPorts ClockedModel::ports() {
  return system::ports_of(model_->top);
}

const std::set<std::uint32_t>& ClockedModel::unknown_streams() const {
  return model_->top.unknown_streams();
}

void ClockedModel::settle(std::uint64_t) {
  model_->evaluate(0);
}

void ClockedModel::rise(std::uint64_t) {
  model_->evaluate(1);
}

void ClockedModel::open_trace(const std::string&) {}

}  // namespace mixcmp::harness

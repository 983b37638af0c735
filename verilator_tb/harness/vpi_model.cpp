// The system task through which an event-driven simulator and the harness take turns.

#include "vpi_model.hpp"

#include <vpi_user.h>

#include <algorithm>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

/// The harness's main function, which the build renames.
int harness_main(int count, char** words);

namespace mixcmp::harness {

/// The simulator's side of the exchange.
class VpiExchange {
public:
  /// It is never destroyed: std::exit, by which either thread ends the process where something is
  /// wrong, would otherwise wait for ever until the other thread leaves the condition variable.
  static VpiExchange& instance() {
    static auto& exchange = *new VpiExchange;
    return exchange;
  }

  /// Called by the simulator.
  void exchange() {
    if (harness_.joinable()) {
      if (model_ != nullptr) read_outputs();
    } else {
      start_harness();
    }
    pass_to(Turn::harness);
    wait_for(Turn::simulator);
    if (status_) {
      harness_.join();
      vpip_set_return_value(*status_);  // the exit code of vvp
      vpi_control(vpiFinish, 0);
    } else {
      write_inputs();
    }
  }

  /// Called by the harness.
  void take_turn(VpiModel& model) {
    model_ = &model;
    pass_to(Turn::simulator);
    wait_for(Turn::harness);
  }

private:
  enum class Turn { simulator, harness };

  void start_harness() {
    harness_ = std::thread([this] {
      wait_for(Turn::harness);
      s_vpi_vlog_info info{};
      vpi_get_vlog_info(&info);
      status_ = harness_main(info.argc, info.argv);
      pass_to(Turn::simulator);
    });
  }

  void pass_to(Turn turn) {
    {
      const std::lock_guard lock(mutex_);
      turn_ = turn;
    }
    changed_.notify_all();
  }

  void wait_for(Turn turn) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return turn_ == turn; });
  }

  static vpiHandle handle_of(const VpiModel::Port& port) {
    const std::string name = std::string("bench.") + port.name;
    const vpiHandle handle = vpi_handle_by_name(name.c_str(), nullptr);
    if (handle != nullptr) return handle;
    vpi_printf("no %s\n", name.c_str());
    std::exit(EXIT_FAILURE);
  }

  const std::vector<vpiHandle>& handles() {
    if (handles_.empty()) {
      for (const VpiModel::Port& port : model_->ports_) handles_.push_back(handle_of(port));
    }
    return handles_;
  }

  static int words_of(const VpiModel::Port& port) { return (port.width + 31) / 32; }

  void write_inputs() {
    for (std::size_t k = 0; k < handles().size(); ++k) {
      const VpiModel::Port& port = model_->ports_[k];
      if (port.is_output) continue;
      std::vector<s_vpi_vecval> words(static_cast<std::size_t>(words_of(port)));
      for (std::size_t word = 0; word < words.size(); ++word) {
        words[word].bval = 0;
        std::memcpy(&words[word].aval, port.bytes + 4 * word, 4);
      }
      s_vpi_value value{};
      value.format = vpiVectorVal;
      value.value.vector = words.data();
      vpi_put_value(handles_[k], &value, nullptr, vpiNoDelay);
    }
  }

  using BitNumbers = std::vector<int>;  ///< from the lowest bit up

  void read_outputs() {
    std::vector<BitNumbers> unknown(handles().size());
    const VpiModel::Port* valid = nullptr;
    for (std::size_t k = 0; k < handles().size(); ++k) {
      const VpiModel::Port& port = model_->ports_[k];
      if (port.is_output) unknown[k] = read(port, handles_[k]);
      if (port.name == std::string_view("m_axis_tvalid")) valid = &port;
    }
    model_->has_unknown_ = false;
    for (std::size_t k = 0; k < unknown.size(); ++k) {
      if (matters(model_->ports_[k], unknown[k], valid)) model_->has_unknown_ = true;
    }
  }

  /// Tells whether one of a port's unknown bits is in a handshake, or in the payload of a stream
  /// with a valid beat. Each stream has one bit of `valid`, and an equal share of a payload's bits.
  static bool matters(const VpiModel::Port& port, const BitNumbers& unknown,
                      const VpiModel::Port* valid) {
    const std::string_view name = port.name;
    if (name.ends_with("_tvalid") || name.ends_with("_tready")) return !unknown.empty();
    if (!name.starts_with("m_axis_") || valid == nullptr) return false;
    const int bits_of_a_stream = port.width / valid->width;
    return std::any_of(unknown.begin(), unknown.end(), [&](int bit) {
      const int stream = bit / bits_of_a_stream;
      return (valid->bytes[stream / 8] >> stream % 8 & 1) != 0;
    });
  }

  /// Reads an output, and returns which of its bits are neither 0 nor 1. An x reads as 1, a z as 0.
  static BitNumbers read(const VpiModel::Port& port, vpiHandle handle) {
    s_vpi_value value{};
    value.format = vpiVectorVal;
    vpi_get_value(handle, &value);
    BitNumbers unknown;
    for (int word = 0; word < words_of(port); ++word) {
      const auto bits = static_cast<std::uint32_t>(value.value.vector[word].bval);
      for (int bit = 0; bit < 32 && bits >> bit != 0; ++bit) {
        if ((bits >> bit & 1) != 0) unknown.push_back(32 * word + bit);
      }
      std::memcpy(port.bytes + 4 * word, &value.value.vector[word].aval, 4);
    }
    return unknown;
  }

  std::thread harness_;
  std::mutex mutex_;
  std::condition_variable changed_;
  Turn turn_ = Turn::simulator;
  std::optional<int> status_;  ///< the harness's return value, once it has ended
  VpiModel* model_ = nullptr;
  std::vector<vpiHandle> handles_;
};

VpiModel::VpiModel(std::vector<Port> ports) : ports_(std::move(ports)) {}

void VpiModel::eval() {
  VpiExchange::instance().take_turn(*this);
}

}  // namespace mixcmp::harness

namespace {

PLI_INT32 exchange(PLI_BYTE8*) {
  mixcmp::harness::VpiExchange::instance().exchange();
  return 0;
}

void register_task() {
  char name[] = "$mixcmp_exchange";
  s_vpi_systf_data task{};
  task.type = vpiSysTask;
  task.tfname = name;
  task.calltf = exchange;
  vpi_register_systf(&task);
}

}  // namespace

extern "C" {
void (*vlog_startup_routines[])() = {register_task, nullptr};
}

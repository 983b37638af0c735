// The system task through which an event-driven simulator and the harness take turns.

#include "vpi_model.hpp"

#include <ucontext.h>
#include <vpi_user.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

/// The harness's main function, which the build renames.
int harness_main(int count, char** words);

namespace mixcmp::harness {

/// The simulator's side of the exchange.
class VpiExchange {
public:
  /// It is never destroyed: the harness may end the process on its own stack, which is in here.
  static VpiExchange& instance() {
    static auto& exchange = *new VpiExchange;
    return exchange;
  }

  /// Called by the simulator.
  void exchange() {
    if (stack_.empty()) start_harness();
    if (model_ != nullptr) read_outputs();
    swapcontext(&simulator_, &harness_);
    if (status_) {
      vpip_set_return_value(*status_);  // the exit code of vvp
      vpi_control(vpiFinish, 0);
    } else {
      write_inputs();
    }
  }

  /// Called by the harness.
  void take_turn(VpiModel& model) {
    model_ = &model;
    swapcontext(&harness_, &simulator_);
  }

private:
  static constexpr std::size_t stack_size = std::size_t{1} << 20;

  void start_harness() {
    stack_.resize(stack_size);
    getcontext(&harness_);
    harness_.uc_stack.ss_sp = stack_.data();
    harness_.uc_stack.ss_size = stack_.size();
    harness_.uc_link = &simulator_;
    makecontext(
        &harness_, [] { instance().run_harness(); }, 0);
  }

  void run_harness() {
    s_vpi_vlog_info info{};
    vpi_get_vlog_info(&info);
    status_ = harness_main(info.argc, info.argv);
  }

  static vpiHandle handle_of(const VpiModel::Port& port) {
    const std::string name = std::string("testbench.") + port.name;
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
    for (std::size_t k = 0; k < handles().size(); ++k) {
      if (model_->ports_[k].is_output) unknown[k] = read(model_->ports_[k], handles_[k]);
    }
    model_->unknown_streams_.clear();
    for (std::size_t k = 0; k < unknown.size(); ++k) {
      if (!unknown[k].empty()) note(model_->ports_[k], unknown[k]);
    }
  }

  static bool is_handshake(std::string_view port) {
    return port.ends_with("_tvalid") || port.ends_with("_tready");
  }

  /// Notes the streams for which a port's unknown bits matter. A stream has one bit of each
  /// handshake, and an equal share of a payload's bits.
  void note(const VpiModel::Port& port, const BitNumbers& unknown) {
    const VpiModel::Port* const valid = is_handshake(port.name) ? nullptr : valid_of(port);
    if (valid == nullptr && !is_handshake(port.name)) return;
    const int bits_of_a_stream = valid == nullptr ? 1 : port.width / valid->width;
    for (const int bit : unknown) {
      const int stream = bit / bits_of_a_stream;
      if (valid != nullptr && (valid->bytes[stream / 8] >> stream % 8 & 1) == 0) continue;
      model_->unknown_streams_.insert(static_cast<std::uint32_t>(stream));
    }
  }

  /// The tvalid of an output that is a stream's payload; null for other outputs.
  const VpiModel::Port* valid_of(const VpiModel::Port& output) const {
    const std::string_view name = output.name;
    const std::size_t payload = name.rfind("_t");
    if (!name.starts_with("m_") || payload == std::string_view::npos) return nullptr;
    const std::string valid = std::string(name.substr(0, payload)) + "_tvalid";
    const auto found = std::find_if(model_->ports_.begin(), model_->ports_.end(),
                                    [&](const VpiModel::Port& port) { return port.name == valid; });
    return found == model_->ports_.end() ? nullptr : &*found;
  }

  /// Reads an output, and returns which of its bits are neither 0 nor 1.
  static BitNumbers read(const VpiModel::Port& port, vpiHandle handle) {
    s_vpi_value value{};
    value.format = vpiVectorVal;
    vpi_get_value(handle, &value);
    const bool is_zero = is_handshake(port.name) && port.name != std::string_view("m_axis_tvalid");
    BitNumbers unknown;
    for (int word = 0; word < words_of(port); ++word) {
      const s_vpi_vecval& bits = value.value.vector[word];
      const auto x_or_z = static_cast<std::uint32_t>(bits.bval);
      for (int bit = 0; bit < 32 && x_or_z >> bit != 0; ++bit) {
        if ((x_or_z >> bit & 1) != 0) unknown.push_back(32 * word + bit);
      }
      const auto ones = static_cast<std::uint32_t>(bits.aval);
      const std::uint32_t read = is_zero ? ones & ~x_or_z : ones;
      std::memcpy(port.bytes + 4 * word, &read, 4);
    }
    return unknown;
  }

  std::vector<char> stack_;  ///< of the harness
  ucontext_t simulator_ = {};
  ucontext_t harness_ = {};
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

#include "generator/hardware/rtl/counter_port.hpp"

#include <algorithm>
#include <bit>

#include "generator/hardware/rtl/connections.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::rtl {
namespace {

int number_of(const std::vector<Counters>& counters) {
  int number = 0;
  for (const Counters& each : counters) number += each.count;
  return number;
}

/// Bits that name one of the counters.
int counter_index_bits(const std::vector<Counters>& counters) {
  return std::max(1,
                  static_cast<int>(std::bit_width(static_cast<unsigned>(number_of(counters) - 1))));
}

std::vector<Port> bus_ports(int address_bits) {
  std::vector<Port> ports;
  add_input(ports, address_bits, "s_axi_awaddr");
  add_input(ports, 3, "s_axi_awprot");
  add_input(ports, 1, "s_axi_awvalid");
  add_output(ports, 1, "s_axi_awready");
  add_input(ports, 32, "s_axi_wdata");
  add_input(ports, 4, "s_axi_wstrb");
  add_input(ports, 1, "s_axi_wvalid");
  add_output(ports, 1, "s_axi_wready");
  add_output(ports, 2, "s_axi_bresp");
  add_output(ports, 1, "s_axi_bvalid");
  add_input(ports, 1, "s_axi_bready");
  add_input(ports, address_bits, "s_axi_araddr");
  add_input(ports, 3, "s_axi_arprot");
  add_input(ports, 1, "s_axi_arvalid");
  add_output(ports, 1, "s_axi_arready");
  add_output(ports, 32, "s_axi_rdata");
  add_output(ports, 2, "s_axi_rresp");
  add_output(ports, 1, "s_axi_rvalid");
  add_input(ports, 1, "s_axi_rready");
  return ports;
}

/// Takes the port of this name out of `ports`.
Port take_port(std::vector<Port>& ports, const std::string& name) {
  const auto found =
      std::find_if(ports.begin(), ports.end(), [&](const Port& port) { return port.name == name; });
  MIXCMP_CHECK(found != ports.end());
  Port port = *found;
  ports.erase(found);
  return port;
}

Instance port_instance(const std::vector<Counters>& counters, const SystemShape& shape,
                       const std::vector<Port>& bus) {
  std::vector<Operand> counts;  // the first counter lowest
  for (const Counters& each : counters) counts.insert(counts.begin(), net(each.name));
  std::vector<Connection> connections = clock_and_reset();
  connections.push_back({"counts", concatenation(std::move(counts))});
  for (const Port& port : bus) connections.push_back(by_name(port.name));
  return {"counter_port",
          "counter_port",
          {{"COUNTERS", number_of(counters)},
           {"NARROW_BITS", shape.counter_bits},
           {"WIDTH", shape.read_counter_bits},
           {"INDEX_BITS", counter_index_bits(counters)}},
          std::move(connections)};
}

}  // namespace

std::vector<CounterOffset> counter_offsets(const std::vector<Counters>& counters) {
  std::vector<CounterOffset> offsets;
  int first = 0;
  for (const Counters& each : counters) {
    offsets.push_back({each, counter_stride * first});
    first += each.count;
  }
  return offsets;
}

int counter_address_bits(const std::vector<Counters>& counters) {
  return counter_index_bits(counters) + std::countr_zero(static_cast<unsigned>(counter_stride));
}

int narrow_counter_bits(const std::vector<Counters>& counters, int events_per_cycle) {
  const int round_cycles = 2 * number_of(counters);
  const int most = events_per_cycle * (round_cycles + 1);
  return static_cast<int>(std::bit_width(static_cast<unsigned>(most)));
}

std::vector<Counters> answer_counters(const SystemShape& shape) {
  if (!shape.counts_answers()) return {};
  return {{"answers", shape.references}};
}

std::vector<Counters> system_counters(const SystemShape& shape) {
  if (shape.counter_bits == 0) return {};
  std::vector<Counters> counters = {{"comparisons", shape.channels()},
                                    {"recomputations", shape.channels()},
                                    {"stalls", shape.channels()}};
  for (Counters& answers : answer_counters(shape)) counters.push_back(std::move(answers));
  return counters;
}

void add_counters(const std::vector<Counters>& counters, const SystemShape& shape,
                  std::vector<Port>& ports) {
  for (const Counters& each : counters) {
    add_output(ports, each.count * shape.counter_bits, each.name, true);
  }
}

Module with_counter_port(Module top, const std::vector<Counters>& counters,
                         const SystemShape& shape) {
  std::vector<ModuleItem> items = {
      Comment{"Narrow counters that wrap. Software reads their counts on s_axi."}};
  for (const Counters& each : counters) {
    const Port port = take_port(top.ports, each.name);
    items.push_back(Wire{port.width, port.name, nullptr, port.vector});
  }
  const std::vector<Port> bus = bus_ports(counter_address_bits(counters));
  top.ports.insert(top.ports.end(), bus.begin(), bus.end());
  top.items.insert(top.items.begin(), items.begin(), items.end());
  top.items.push_back(port_instance(counters, shape, bus));
  return top;
}

}  // namespace mixcmp::rtl

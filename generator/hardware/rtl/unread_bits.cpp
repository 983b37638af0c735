#include "generator/hardware/rtl/unread_bits.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "model/base/common/check.hpp"

namespace mixcmp::rtl {
namespace {

std::vector<Operand> unread(const std::string& name, int bits,
                            const std::vector<BitRange>& ranges) {
  std::vector<bool> read(static_cast<std::size_t>(bits), false);
  for (const BitRange& range : ranges) {
    std::fill_n(read.begin() + range.low, std::min(range.width, bits - range.low), true);
  }
  std::vector<Operand> slices;
  for (int low = 0; low < bits;) {
    int high = low;
    while (high + 1 < bits && read[high + 1] == read[low]) ++high;
    if (!read[low]) slices.push_back(slice(name, high, low));
    low = high + 1;
  }
  return slices;
}

/// A wire that reads these bits and has no other use.
Wire consumer(std::string name, std::vector<Operand> bits) {
  bits.insert(bits.begin(), literal(1, 0));
  return {1, std::move(name), all_bits(concatenation(std::move(bits)))};
}

/// Tells whether a connection is the output of a delay line.
bool is_delayed_value(const Instance& instance, const Connection& connection) {
  return instance.module == "delay_line" && connection.port == "q";
}

/// Tells whether a connection drives its net. Units drive "y".
bool is_driver(const Instance& instance, const Connection& connection) {
  return is_delayed_value(instance, connection) || connection.port == "y";
}

int width_of_delay(const Instance& instance) {
  const auto width =
      std::find_if(instance.parameters.begin(), instance.parameters.end(),
                   [](const Parameter& parameter) { return parameter.name == "WIDTH"; });
  MIXCMP_CHECK(width != instance.parameters.end());
  return static_cast<int>(std::get<long long>(width->value));
}

/// The bits that items read, by the names of nets.
class Reads {
public:
  void add(const std::vector<ModuleItem>& items) {
    for (const ModuleItem& item : items) {
      std::visit([&](const auto& each) { add(each); }, item);
    }
  }

  const std::vector<BitRange>& of(const std::string& net) { return ranges_[net]; }

private:
  void add(const Comment&) {}
  void add(const PhaseFlag&) {}
  void add(const Wire& wire) { add(wire.value); }
  void add(const Assignment& assignment) { add(assignment.value); }
  void add(const HeldValue& held) { add(held.value); }
  void add(const std::shared_ptr<const ForGenerate>& loop) { add(loop->items); }
  void add(const PhaseRegisters& registers) {
    for (const PhaseCase& each : registers.cases) add(each.values);
  }
  void add(const Instance& instance) {
    for (const Connection& connection : instance.connections) {
      if (!is_driver(instance, connection)) add(connection.value);
    }
  }

  void add(const std::vector<Operand>& operands) {
    for (const Operand& operand : operands) add(operand);
  }
  void add(const Operand& operand) {
    if (operand != nullptr) std::visit([&](const auto& node) { add(node); }, operand->node);
  }
  void add(const Net& net) { ranges_[net.name].push_back({0, whole}); }
  void add(const IndexedSlice& slice) { ranges_[slice.name].push_back({0, whole}); }
  void add(const Slice& slice) {
    ranges_[slice.name].push_back({slice.low, slice.high - slice.low + 1});
  }
  void add(const Literal&) {}
  void add(const Zeros&) {}
  void add(const Concatenation& concatenation) { add(concatenation.parts); }
  void add(const Not& node) { add(node.operand); }
  void add(const Or& node) { add(node.operands); }
  void add(const AndReduce& node) { add(node.operand); }

  static constexpr int whole = std::numeric_limits<int>::max();

  std::map<std::string, std::vector<BitRange>> ranges_;
};

}  // namespace

void consume_unread(const std::string& name, int bits, const std::vector<BitRange>& read,
                    std::vector<ModuleItem>& items) {
  std::vector<Operand> unused = unread(name, bits, read);
  if (!unused.empty()) items.push_back(consumer("unused_" + name, std::move(unused)));
}

void consume_unread_bits(std::vector<ModuleItem>& items,
                         const std::map<std::string, int>& read_in_part, NamePool& pool) {
  Reads reads;
  reads.add(items);
  std::vector<ModuleItem> consumed;
  const auto consume = [&](const std::string& name, int width) {
    std::vector<Operand> unused = unread(name, width, reads.of(name));
    if (unused.empty()) return;
    consumed.emplace_back(consumer(pool.unique("unused_" + name), std::move(unused)));
  };
  for (const auto& [name, width] : read_in_part) consume(name, width);
  for (const ModuleItem& item : items) {
    const auto* instance = std::get_if<Instance>(&item);
    if (instance == nullptr) continue;
    for (const Connection& connection : instance->connections) {
      if (!is_delayed_value(*instance, connection)) continue;
      consume(std::get<Net>(connection.value->node).name, width_of_delay(*instance));
    }
  }
  items.insert(items.end(), consumed.begin(), consumed.end());
}

}  // namespace mixcmp::rtl

#include "generator/emit/signature.hpp"

#include <fmt/core.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

namespace mixcmp::gen {

namespace {

using Json = nlohmann::ordered_json;

template <class Value>
struct Name {
  Value value;
  const char* text;
};

constexpr std::array orders = {Name<model::ResultOrder>{model::ResultOrder::tagged, "tagged"},
                               Name<model::ResultOrder>{model::ResultOrder::in_order, "in_order"}};
constexpr std::array stores = {
    Name<model::OperandStore>{model::OperandStore::carried, "carried"},
    Name<model::OperandStore>{model::OperandStore::refetched, "refetched"}};

template <class Value, std::size_t count>
const char* text_of(const std::array<Name<Value>, count>& names, Value value) {
  for (const auto& name : names) {
    if (name.value == value) return name.text;
  }
  MIXCMP_CHECK(false);
  return nullptr;
}

/// Takes fields out of a JSON object; the first one that does not fit is kept as the error.
class Reader {
public:
  Reader(const Json& object, std::string file) : object_(object), file_(std::move(file)) {}

  template <class T>
  T read(const char* field, const char* accepted) {
    if (object_.is_object() && object_.contains(field)) {
      try {
        return object_.at(field).get<T>();
      } catch (const Json::exception&) {
      }
    }
    refuse(field, accepted);
    return {};
  }

  std::string text(const char* field) { return read<std::string>(field, "a string"); }

  int number(const char* field, int low, int high) {
    const std::string accepted = fmt::format("an integer in {}..{}", low, high);
    const auto value = read<std::int64_t>(field, accepted.c_str());
    if (value >= low && value <= high) return static_cast<int>(value);
    refuse(field, accepted);
    return low;
  }

  model::FloatFormat format(const char* field) {
    auto parsed = model::FloatFormat::parse(text(field));
    if (parsed.ok()) return *parsed;
    refuse(field, "a format such as \"s17e8\"");
    return *model::FloatFormat::make(model::FloatFormat::min_precision,
                                     model::FloatFormat::min_exponent_bits);
  }

  template <class Value, std::size_t count>
  Value choice(const char* field, const std::array<Name<Value>, count>& names) {
    const std::string received = text(field);
    std::string accepted;
    for (const auto& name : names) {
      if (received == name.text) return name.value;
      accepted += fmt::format("{}\"{}\"", accepted.empty() ? "" : ", ", name.text);
    }
    refuse(field, accepted);
    return names[0].value;
  }

  std::vector<SignaturePort> ports(const char* field) {
    std::vector<SignaturePort> ports;
    for (const Json& entry : read<std::vector<Json>>(field, "a list of ports")) {
      try {
        ports.push_back({entry.at("name"), entry.at("direction"), entry.at("width")});
      } catch (const Json::exception&) {
        refuse(field, "ports of name, direction and width");
      }
    }
    return ports;
  }

  const std::optional<model::Error>& error() const { return error_; }

private:
  void refuse(const char* field, const std::string& accepted) {
    if (error_) return;
    const bool present = object_.is_object() && object_.contains(field);
    error_ = model::Error{.file = file_,
                          .field = field,
                          .message = present ? "not as a signature has it" : "missing",
                          .received = present ? object_.at(field).dump() : "",
                          .accepted = accepted};
  }

  const Json& object_;
  std::string file_;
  std::optional<model::Error> error_;
};

Json ports_to_json(const std::vector<SignaturePort>& ports) {
  Json list = Json::array();
  for (const SignaturePort& port : ports) {
    list.push_back({{"name", port.name}, {"direction", port.direction}, {"width", port.width}});
  }
  return list;
}

}  // namespace

std::string to_json(const Signature& s) {
  const Json json = {{"top", s.top},
                     {"channel_module", s.channel_module},
                     {"reference_module", s.reference_module},
                     {"generator_version", s.generator_version},
                     {"spec_hash", s.spec_hash},
                     {"lane_format", s.lane_format.name()},
                     {"reference_format", s.reference_format.name()},
                     {"certified", s.certified},
                     {"inputs", s.inputs},
                     {"lanes", s.lanes},
                     {"references", s.references},
                     {"tdata_bytes", s.tdata_bytes},
                     {"tag_bits", s.tag_bits},
                     {"counter_bits", s.counter_bits},
                     {"slots", s.slots},
                     {"lane_latency_cycles", s.lane_latency_cycles},
                     {"reference_latency_cycles", s.reference_latency_cycles},
                     {"order", text_of(orders, s.order)},
                     {"operands", text_of(stores, s.operands)},
                     {"target_mhz", s.target_mhz},
                     {"clock", "aclk"},
                     {"reset", "aresetn, synchronous, active low"},
                     {"initiation_interval_cycles", 1},
                     {"ports", ports_to_json(s.ports)},
                     {"files", s.files}};
  return json.dump(2) + "\n";
}

model::Result<Signature> read_signature(const std::filesystem::path& path) {
  std::ifstream stream(path);
  if (!stream) {
    return model::Error{.file = path.string(), .message = "cannot read the system's signature"};
  }
  const Json json = Json::parse(stream, nullptr, false);
  if (json.is_discarded()) {
    return model::Error{.file = path.string(), .message = "not JSON"};
  }
  Reader reader(json, path.string());
  constexpr int many = 1 << 30;
  Signature signature{
      .top = reader.text("top"),
      .channel_module = reader.text("channel_module"),
      .reference_module = reader.text("reference_module"),
      .generator_version = reader.text("generator_version"),
      .spec_hash = reader.text("spec_hash"),
      .lane_format = reader.format("lane_format"),
      .reference_format = reader.format("reference_format"),
      .certified = reader.read<bool>("certified", "true or false"),
      .inputs = reader.read<std::vector<std::string>>("inputs", "a list of names"),
      .lanes = reader.number("lanes", 1, 128),
      .references = reader.number("references", 0, 16),
      .tdata_bytes = reader.number("tdata_bytes", 1, many),
      .tag_bits = reader.number("tag_bits", 1, 64),
      .counter_bits = reader.number("counter_bits", 0, 64),
      .slots = reader.number("slots", 1, many),
      .lane_latency_cycles = reader.number("lane_latency_cycles", 0, many),
      .reference_latency_cycles = reader.number("reference_latency_cycles", 0, many),
      .order = reader.choice("order", orders),
      .operands = reader.choice("operands", stores),
      .target_mhz = reader.read<double>("target_mhz", "a number"),
      .ports = reader.ports("ports"),
      .files = reader.read<std::vector<std::string>>("files", "a list of Verilog files")};
  if (reader.error()) return *reader.error();
  return signature;
}

}  // namespace mixcmp::gen

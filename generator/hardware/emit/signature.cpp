#include "generator/hardware/emit/signature.hpp"

#include <fmt/core.h>

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "model/base/common/file.hpp"
#include "model/base/number/lane_format.hpp"

namespace mixcmp::emit {

namespace {

using Json = nlohmann::ordered_json;

template <class Value>
struct Name {
  Value value;
  const char* text;
};

constexpr std::array orders = {Name<scene::ResultOrder>{scene::ResultOrder::tagged, "tagged"},
                               Name<scene::ResultOrder>{scene::ResultOrder::in_order, "in_order"}};
constexpr std::array stores = {
    Name<scene::OperandStore>{scene::OperandStore::carried, "carried"},
    Name<scene::OperandStore>{scene::OperandStore::refetched, "refetched"}};

constexpr std::array multipliers_names = {
    Name<scene::Multipliers>{scene::Multipliers::embedded, "embedded"},
    Name<scene::Multipliers>{scene::Multipliers::logic, "logic"},
    Name<scene::Multipliers>{scene::Multipliers::memory, "memory"}};

constexpr std::array sums_names = {Name<Sums>{Sums::composed, "composed"},
                                   Name<Sums>{Sums::fused, "fused"}};

constexpr std::array combinations = {Name<Combination>{Combination::all, "all"},
                                     Name<Combination>{Combination::any, "any"}};

constexpr std::array directions = {Name<rtl::Direction>{rtl::Direction::input, "input"},
                                   Name<rtl::Direction>{rtl::Direction::output, "output"}};

constexpr std::array engine_kinds = {
    Name<scene::EngineKind>{scene::EngineKind::pairwise, "pairwise"},
    Name<scene::EngineKind>{scene::EngineKind::arg_min, "arg_min"}};

constexpr std::array report_forms = {Name<scene::ReportForm>{scene::ReportForm::pairs, "pairs"},
                                     Name<scene::ReportForm>{scene::ReportForm::bitmap, "bitmap"},
                                     Name<scene::ReportForm>{scene::ReportForm::count, "count"}};

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
  /// `path`: the text before a field's name in errors.
  Reader(const Json& object, std::string file, std::string path = {})
      : object_(object), file_(std::move(file)), path_(std::move(path)) {}

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

  int number(const char* field, settings::Limits limits) {
    return number(field, limits.least, limits.most);
  }

  int number(const char* field, int low, int high) {
    const std::string accepted = fmt::format("an integer in {}..{}", low, high);
    const auto value = read<std::int64_t>(field, accepted.c_str());
    if (value >= low && value <= high) return static_cast<int>(value);
    refuse(field, accepted);
    return low;
  }

  /// A number that divides `whole`.
  int divisor(const char* field, settings::Limits limits, int whole) {
    const int value = number(field, limits);
    if (whole % value != 0) refuse(field, fmt::format("a divisor of {}", whole));
    return value;
  }

  /// The format of a lane: "s17e8", "q13" or "block13".
  std::string lane_format(const char* field) {
    std::string name = text(field);
    if (!LaneFormat::parse(name).ok()) refuse(field, "a format: \"s17e8\", \"q13\", \"block13\"");
    return name;
  }
  /// The inputs of a lane: "rounded", "exact" or a number of digits, "20".
  LaneInputs lane_inputs(const char* field) {
    const auto inputs =
        LaneInputs::parse(text(field), FloatFormat::min_precision, FloatFormat::max_precision);
    if (inputs.ok()) return *inputs;
    refuse(field, inputs.error().accepted);
    return LaneInputs::exact;
  }
  FloatFormat format(const char* field) {
    auto parsed = FloatFormat::parse(text(field));
    if (parsed.ok()) return *parsed;
    refuse(field, "a format such as \"s17e8\"");
    return *FloatFormat::make(FloatFormat::min_precision, FloatFormat::min_exponent_bits);
  }

  /// The formats of operands: "s53e11", "uint10".
  std::vector<OperandFormat> operand_formats(const char* field) {
    std::vector<OperandFormat> formats;
    for (const auto& name : read<std::vector<std::string>>(field, "a list of formats")) {
      const Result<OperandFormat> format = OperandFormat::parse(name);
      if (!format.ok()) refuse(field, "formats such as \"s53e11\", \"uint10\"");
      if (format.ok()) formats.push_back(*format);
    }
    return formats;
  }

  /// Refuses a list of formats that does not have one for each name.
  void require_formats(const char* field, const std::vector<std::string>& names,
                       const std::vector<OperandFormat>& formats) {
    if (formats.size() != names.size()) refuse(field, fmt::format("{} formats", names.size()));
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

  /// Reads a list of objects, each entry by `read_group`.
  template <class Group>
  std::vector<Group> groups(const char* field, Group (*read_group)(Reader&)) {
    std::vector<Group> groups;
    const auto entries = read<std::vector<Json>>(field, "a list of objects");
    for (std::size_t k = 0; k < entries.size(); ++k) {
      Reader entry(entries[k], file_, fmt::format("{}[{}].", field, k));
      groups.push_back(read_group(entry));
      if (!error_) error_ = entry.error();
    }
    return groups;
  }

  /// Reads an object by `read_part`; nullopt if the field is absent.
  template <class Part>
  std::optional<Part> part(const char* field, Part (*read_part)(Reader&)) {
    if (!object_.is_object() || !object_.contains(field)) return std::nullopt;
    Reader entry(object_.at(field), file_, fmt::format("{}{}.", path_, field));
    Part part = read_part(entry);
    if (!error_) error_ = entry.error();
    return part;
  }

  const std::optional<Error>& error() const { return error_; }

private:
  void refuse(const char* field, const std::string& accepted) {
    if (error_) return;
    const bool present = object_.is_object() && object_.contains(field);
    error_ = Error{.file = file_,
                   .field = path_ + field,
                   .message = present ? "not as a signature has it" : "missing",
                   .received = present ? object_.at(field).dump() : "",
                   .accepted = accepted};
  }

  const Json& object_;
  std::string file_;
  std::string path_;
  std::optional<Error> error_;
};

Json ports_to_json(const std::vector<SignaturePort>& ports) {
  Json list = Json::array();
  for (const SignaturePort& port : ports) {
    list.push_back({{"name", port.name},
                    {"direction", text_of(directions, port.direction)},
                    {"width", port.width}});
  }
  return list;
}

Json to_json(const SignatureLanes& group) {
  return {{"count", group.count},
          {"module", group.module},
          {"format", group.format},
          {"latency_cycles", group.latency_cycles},
          {"certified", group.certified},
          {"decision", group.decision},
          {"inputs", to_string(group.inputs)},
          {"multipliers", text_of(multipliers_names, group.multipliers)}};
}

Json to_json(const SignatureReferences& group) {
  return {{"count", group.count},
          {"module", group.module},
          {"format", group.format},
          {"latency_cycles", group.latency_cycles},
          {"initiation_interval_cycles", group.initiation_interval_cycles},
          {"multipliers", text_of(multipliers_names, group.multipliers)}};
}

Json names_of(const std::vector<OperandFormat>& formats) {
  Json names = Json::array();
  for (const OperandFormat& format : formats) names.push_back(format.name());
  return names;
}

Json to_json(const SignatureEngine& engine) {
  Json json = {{"kind", text_of(engine_kinds, engine.kind)},
               {"top", engine.top},
               {"capacity", engine.capacity},
               {"index_bits", engine.index_bits},
               {"columns", engine.columns},
               {"column_formats", names_of(engine.column_formats)},
               {"item_bytes", engine.item_bytes}};
  if (engine.kind == scene::EngineKind::arg_min) {
    json["row_columns"] = engine.row_columns;
    json["row_column_formats"] = names_of(engine.row_column_formats);
    json["row_bytes"] = engine.row_bytes;
    json["tag_bits"] = engine.tag_bits;
  } else {
    json["report"] = engine.report;
    json["report_as"] = text_of(report_forms, engine.report_as);
    json["report_streams"] = engine.report_streams;
    json["report_lanes"] = engine.report_lanes;
    json["report_bytes"] = engine.report_bytes;
  }
  json["ports"] = ports_to_json(engine.ports);
  return json;
}

Json to_json(const scene::PartText& part) {
  return {{"f", part.f}, {"g", part.g}};
}

Json to_json(const LetDefinition& let) {
  return {{"name", let.name}, {"text", let.text}};
}

Json to_json(const SignatureCounters& counters) {
  return {{"name", counters.name}, {"count", counters.count}, {"offset", counters.offset}};
}

template <class Group>
Json groups_to_json(const std::vector<Group>& groups) {
  Json list = Json::array();
  for (const Group& group : groups) list.push_back(to_json(group));
  return list;
}

constexpr int many = 1 << 30;

SignaturePort read_port(Reader& reader) {
  return {.name = reader.text("name"),
          .direction = reader.choice("direction", directions),
          .width = reader.number("width", 1, many)};
}

scene::PartText read_part(Reader& reader) {
  return {.f = reader.text("f"), .g = reader.text("g")};
}

LetDefinition read_let(Reader& reader) {
  return {.name = reader.text("name"), .text = reader.text("text")};
}

SignatureCounters read_counters(Reader& reader) {
  return {.name = reader.text("name"),
          .count = reader.number("count", 1, many),
          .offset = reader.number("offset", 0, many)};
}

SignatureLanes read_lanes(Reader& reader) {
  return {.count = reader.number("count", settings::limits::engine_lanes),
          .module = reader.text("module"),
          .format = reader.lane_format("format"),
          .latency_cycles = reader.number("latency_cycles", 0, many),
          .certified = reader.read<bool>("certified", "true or false"),
          .decision = reader.text("decision"),
          .inputs = reader.lane_inputs("inputs"),
          .multipliers = reader.choice("multipliers", multipliers_names)};
}

SignatureReferences read_references(Reader& reader) {
  return {.count = reader.number("count", 1, settings::limits::references.most),
          .module = reader.text("module"),
          .format = reader.text("format"),
          .latency_cycles = reader.number("latency_cycles", 0, many),
          .initiation_interval_cycles =
              reader.number("initiation_interval_cycles", settings::limits::initiation_interval),
          .multipliers = reader.choice("multipliers", multipliers_names)};
}

SignatureEngine read_engine(Reader& reader) {
  SignatureEngine engine = {
      .kind = reader.choice("kind", engine_kinds),
      .top = reader.text("top"),
      .capacity = reader.number("capacity", settings::limits::engine_capacity),
      .index_bits = reader.number("index_bits", 1, 16),
      .columns = reader.read<std::vector<std::string>>("columns", "a list of names"),
      .column_formats = reader.operand_formats("column_formats"),
      .item_bytes = reader.number("item_bytes", 1, many),
      .report = {},
      .ports = reader.groups("ports", read_port)};
  reader.require_formats("column_formats", engine.columns, engine.column_formats);
  if (engine.kind == scene::EngineKind::arg_min) {
    engine.row_columns = reader.read<std::vector<std::string>>("row_columns", "a list of names");
    engine.row_column_formats = reader.operand_formats("row_column_formats");
    reader.require_formats("row_column_formats", engine.row_columns, engine.row_column_formats);
    engine.row_bytes = reader.number("row_bytes", 1, many);
    engine.tag_bits = reader.number("tag_bits", settings::limits::tag_bits);
  } else {
    engine.report = reader.read<std::vector<std::string>>("report", "a list of verdicts");
    engine.report_as = reader.choice("report_as", report_forms);
    engine.report_streams = reader.number("report_streams", settings::limits::report_streams);
    engine.report_lanes = reader.number("report_lanes", settings::limits::lanes_per_group);
    engine.report_bytes = reader.number("report_bytes", 1, many);
  }
  return engine;
}

}  // namespace

Json to_json(const SignatureSimulation& run) {
  return {{"simulator", run.simulator},
          {"comparisons", run.comparisons},
          {"recomputations", run.recomputations},
          {"passed", run.passed}};
}

std::optional<SignatureSimulation> simulation_in(const Json& json) {
  try {
    return SignatureSimulation{.simulator = json.at("simulator"),
                               .comparisons = json.at("comparisons"),
                               .recomputations = json.at("recomputations"),
                               .passed = json.at("passed")};
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

int counter_address_bits(const Signature& signature) {
  const std::vector<SignaturePort>& ports =
      signature.engine ? signature.engine->ports : signature.ports;
  for (const SignaturePort& port : ports) {
    if (port.name == "s_axi_araddr") return port.width;
  }
  return 0;
}

int refetch_streams(const Signature& signature) {
  const bool refetches = signature.operands == scene::OperandStore::refetched;
  if (!refetches || signature.references == 0 || signature.engine) return 0;
  return signature.references + (signature.second_tier ? signature.second_tier->count : 0);
}

int counted_answers(const Signature& signature) {
  for (const SignatureCounters& counters : signature.counter_map) {
    if (counters.name == "answers") return counters.count;
  }
  return 0;
}

std::string to_json(const Signature& s) {
  Json json = {{"top", s.top},
               {"generator_version", s.generator_version},
               {"spec_hash", s.spec_hash},
               {"reference_format", s.reference_format.name()},
               {"reference_sums", text_of(sums_names, s.reference_sums)},
               {"certified", s.certified},
               {"parts", groups_to_json(s.parts)},
               {"combine", text_of(combinations, s.combination)},
               {"lets", groups_to_json(s.lets)},
               {"inputs", s.inputs},
               {"input_formats", names_of(s.input_formats)},
               {"lanes", s.lanes},
               {"lanes_per_group", s.lanes_per_group},
               {"references", s.references},
               {"lane_groups", groups_to_json(s.lane_groups)},
               {"reference_groups", groups_to_json(s.reference_groups)},
               {"tdata_bytes", s.tdata_bytes},
               {"tag_bits", s.tag_bits},
               {"counter_bits", s.counter_bits},
               {"slots", s.slots},
               {"input_registers", s.input_registers},
               {"request_beats", s.request_beats},
               {"order", text_of(orders, s.order)},
               {"operands", text_of(stores, s.operands)},
               {"target_mhz", s.target_mhz},
               {"clock", "aclk"},
               {"reset", "aresetn, synchronous, active low"},
               {"initiation_interval_cycles", 1},
               {"ports", ports_to_json(s.ports)}};
  if (!s.counter_map.empty()) json["counter_map"] = groups_to_json(s.counter_map);
  if (s.second_tier) json["second_tier"] = to_json(*s.second_tier);
  if (s.engine) json["engine"] = to_json(*s.engine);
  json["files"] = s.files;
  if (!s.cells.empty()) json["cells"] = s.cells;
  if (!s.project.empty()) json["project"] = s.project;
  json["simulations"] = groups_to_json(s.simulations);
  return json.dump(2) + "\n";
}

Result<Signature> read_signature(const std::filesystem::path& path) {
  MIXCMP_TRY(text, read_file(path));
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) {
    return Error{.file = path.string(), .message = "not JSON"};
  }
  Reader reader(json, path.string());
  const int lanes = reader.number("lanes", settings::limits::engine_lanes);
  Signature signature{
      .top = reader.text("top"),
      .generator_version = reader.text("generator_version"),
      .spec_hash = reader.text("spec_hash"),
      .reference_format = reader.format("reference_format"),
      .reference_sums = reader.choice("reference_sums", sums_names),
      .certified = reader.read<bool>("certified", "true or false"),
      .parts = reader.groups("parts", read_part),
      .combination = reader.choice("combine", combinations),
      .lets = reader.groups("lets", read_let),
      .inputs = reader.read<std::vector<std::string>>("inputs", "a list of names"),
      .input_formats = reader.operand_formats("input_formats"),
      .lanes = lanes,
      .lanes_per_group =
          reader.divisor("lanes_per_group", settings::limits::lanes_per_group, lanes),
      .references = reader.number("references", settings::limits::references),
      .lane_groups = reader.groups("lane_groups", read_lanes),
      .reference_groups = reader.groups("reference_groups", read_references),
      .tdata_bytes = reader.number("tdata_bytes", 1, many),
      .tag_bits = reader.number("tag_bits", settings::limits::tag_bits),
      .counter_bits = reader.number("counter_bits", 0, settings::limits::counter_bits.most),
      .slots = reader.number("slots", 1, many),
      .input_registers = reader.number("input_registers", settings::limits::input_registers),
      .request_beats = reader.number("request_beats", settings::limits::request_beats),
      .order = reader.choice("order", orders),
      .operands = reader.choice("operands", stores),
      .target_mhz = reader.read<double>("target_mhz", "a number"),
      .ports = reader.groups("ports", read_port),
      .second_tier = reader.part("second_tier", read_lanes),
      .engine = reader.part("engine", read_engine),
      .files = reader.read<std::vector<std::string>>("files", "a list of Verilog files"),
      .cells = {}};
  if (json.contains("counter_map")) {
    signature.counter_map = reader.groups("counter_map", read_counters);
  }
  if (json.contains("cells")) {
    signature.cells = reader.read<std::vector<std::string>>("cells", "a list of Verilog files");
  }
  if (json.contains("project")) {
    signature.project = reader.read<std::vector<std::string>>("project", "a list of files");
  }
  reader.require_formats("input_formats", signature.inputs, signature.input_formats);
  if (reader.error()) return *reader.error();
  return signature;
}

}  // namespace mixcmp::emit

#include <fmt/core.h>

#include "generator/project/builders.hpp"

namespace mixcmp::project {
namespace {

bool refetches(const emit::Signature& signature) {
  return emit::refetch_streams(signature) > 0;
}

/// Values for a test bench whose lanes are in groups. With single lanes they leave its text as it
/// is.
void add_group_values(const emit::Signature& s, Values& values) {
  const bool is_grouped = s.lanes_per_group > 1;
  values["GROUPED"] = is_grouped ? "yes" : "";
  values["UNGROUPED"] = is_grouped ? "" : "yes";
  values["LANES_PER_GROUP"] = std::to_string(s.lanes_per_group);
  values["COUNTED"] = is_grouped ? "GROUPS" : "LANES";
  values["GROUP_PREFIX"] = is_grouped ? "group_" : "";
  values["OF_GROUPS"] = is_grouped ? "[::LANES_PER_GROUP]" : "";
  values["STREAM_OF_LANE"] = is_grouped ? "lane // LANES_PER_GROUP" : "lane";
  // A refetched operand is asked for by the tag of its word and the number of its lane, so that
  // each comparison needs a tag of its own.
  values["COMPARISONS_PER_TAG"] = refetches(s) ? "1" : "LANES_PER_GROUP";
}

/// The values of the signature by the names that both test benches give them.
Values signature_values(const ProjectSpec& spec, const std::string& comment) {
  const emit::Signature& s = spec.signature;
  Values values = common_values(spec, comment);
  const auto number = [&values](const char* name, auto value) {
    values[name] = std::to_string(value);
  };
  number("LANES", s.lanes);
  number("REFETCH_STREAMS", emit::refetch_streams(s));
  number("TDATA_BITS", 8 * s.tdata_bytes);
  number("TAG_BITS", s.tag_bits);
  number("IN_ORDER", s.order == scene::ResultOrder::in_order ? 1 : 0);
  number("REFETCHES", refetches(s) ? 1 : 0);
  number("COUNT", spec.vectors.size());
  add_group_values(s, values);
  return values;
}

GeneratedFile verilog_testbench(const ProjectSpec& spec) {
  Values values = signature_values(spec, "//");
  values["DUT"] = spec.signature.top;
  add_counter_values(spec.signature, spec.signature.ports, values);
  values["REFETCHED"] = refetches(spec.signature) ? "yes" : "";
  return file_from(fmt::format("testbench/{}_tb.v", spec.signature.top), "testbench.v", values);
}

/// One line for each vector: the expected word, an underscore, and the operands, all hexadecimal.
/// $readmemh leaves out underscores and comments.
GeneratedFile vector_file(const ProjectSpec& spec) {
  std::string text = fmt::format("{}\n// m_axis_tdata that is expected _ s_axis_tdata\n",
                                 common_values(spec, "//").at("PROVENANCE"));
  for (const emit::TestVector& vector : spec.vectors) {
    text += fmt::format("{:02x}_{}\n", vector.expected.bits(), hexadecimal(vector.tdata));
  }
  return {.name = fmt::format("testbench/{}_tb.hex", spec.signature.top), .text = std::move(text)};
}

}  // namespace

std::string hexadecimal(const std::vector<std::uint8_t>& bytes) {
  std::string text;
  for (auto byte = bytes.rbegin(); byte != bytes.rend(); ++byte) {
    text += fmt::format("{:02x}", *byte);
  }
  return text;
}

std::vector<GeneratedFile> testbench_files(const ProjectSpec& spec) {
  Values values = signature_values(spec, "#");
  values["SOURCES"] = source_list(spec, " \\\n  $(SYSTEM)/", "");
  add_counter_values(spec.signature, spec.signature.ports, values);
  return {verilog_testbench(spec), vector_file(spec),
          file_from(fmt::format("cocotb/test_{}.py", spec.signature.top), "cocotb_test.py", values),
          file_from("cocotb/Makefile", "cocotb_makefile", values)};
}

}  // namespace mixcmp::project

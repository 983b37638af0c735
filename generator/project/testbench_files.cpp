#include <fmt/core.h>

#include "generator/project/builders.hpp"

namespace mixcmp::project {
namespace {

constexpr const char* counter_nets =
    "  wire [LANES*COUNTER_BITS-1:0] comparisons;\n"
    "  wire [LANES*COUNTER_BITS-1:0] recomputations;\n"
    "  wire [LANES*COUNTER_BITS-1:0] stalls;";
constexpr const char* counter_connections =
    "      .comparisons(comparisons),\n"
    "      .recomputations(recomputations),\n"
    "      .stalls(stalls),";
constexpr const char* counter_pause =
    "        // Half way, lanes with idle cycles have taken different numbers of comparisons.\n"
    "        if (!has_paused && (left_count >= COUNT / 2)) pausing = 1'b1;\n"
    "        if (pausing && (left_count == taken_count) && !stopped) begin\n"
    "          check_counters;\n"
    "          pausing = 1'b0;\n"
    "          has_paused = 1'b1;\n"
    "        end";
constexpr const char* refetch_nets =
    "  localparam TAG_FIELD = 8 * ((TAG_BITS + 7) / 8);\n"
    "  wire [REFERENCES-1:0]            m_refetch_tvalid;\n"
    "  wire [REFERENCES-1:0]            m_refetch_tready;\n"
    "  wire [REFERENCES*TAG_FIELD-1:0]  m_refetch_tdata;\n"
    "  wire [REFERENCES-1:0]            s_refetch_tvalid;\n"
    "  wire [REFERENCES-1:0]            s_refetch_tready;\n"
    "  wire [REFERENCES*TDATA_BITS-1:0] s_refetch_tdata;";
constexpr const char* refetch_connections =
    "      .m_refetch_tvalid(m_refetch_tvalid),\n"
    "      .m_refetch_tready(m_refetch_tready),\n"
    "      .m_refetch_tdata(m_refetch_tdata),\n"
    "      .s_refetch_tvalid(s_refetch_tvalid),\n"
    "      .s_refetch_tready(s_refetch_tready),\n"
    "      .s_refetch_tdata(s_refetch_tdata),";

bool refetches(const emit::Signature& signature) {
  return signature.operands == scene::OperandStore::refetched && signature.references > 0;
}

/// The values of the signature by the names that both test benches give them.
Values signature_values(const ProjectSpec& spec, const std::string& comment) {
  const emit::Signature& s = spec.signature;
  Values values = common_values(spec, comment);
  const auto number = [&values](const char* name, auto value) {
    values[name] = std::to_string(value);
  };
  number("LANES", s.lanes);
  number("REFERENCES", s.references);
  number("TDATA_BITS", 8 * s.tdata_bytes);
  number("TAG_BITS", s.tag_bits);
  number("COUNTER_BITS", s.counter_bits);
  number("IN_ORDER", s.order == scene::ResultOrder::in_order ? 1 : 0);
  number("REFETCHED", refetches(s) ? 1 : 0);
  number("COUNT", spec.vectors.size());
  return values;
}

GeneratedFile verilog_testbench(const ProjectSpec& spec) {
  const emit::Signature& s = spec.signature;
  Values values = signature_values(spec, "//");
  const auto block = [&values](const char* name, bool is_there, const std::string& text) {
    values[name] = is_there ? text : "";
  };
  const bool counts = s.counter_bits > 0;
  block("COUNTER_NETS", counts, counter_nets);
  block("COUNTER_CONNECTIONS", counts, counter_connections);
  block("COUNTER_CHECK", counts, fill_template("testbench_counters.v", {}));
  block("COUNTER_CALL", counts, "    if (!stopped) check_counters;");
  block("COUNTER_PAUSE", counts, counter_pause);
  block("REFETCH_NETS", refetches(s), refetch_nets);
  block("REFETCH_CONNECTIONS", refetches(s), refetch_connections);
  block("REFETCH_MEMORY", refetches(s), fill_template("testbench_refetch.v", {}));
  return file_from(fmt::format("testbench/{}_tb.v", s.top), "testbench.v", values);
}

/// One line for each vector: the expected word, an underscore, and the operands, all hexadecimal.
/// $readmemh leaves out underscores and comments.
GeneratedFile vector_file(const ProjectSpec& spec) {
  std::string text = fmt::format("{}\n// m_axis_tdata that is expected _ s_axis_tdata\n",
                                 common_values(spec, "//").at("PROVENANCE"));
  for (const TestVector& vector : spec.vectors) {
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
  return {verilog_testbench(spec), vector_file(spec),
          file_from(fmt::format("cocotb/test_{}.py", spec.signature.top), "cocotb_test.py", values),
          file_from("cocotb/Makefile", "cocotb_makefile", values)};
}

}  // namespace mixcmp::project

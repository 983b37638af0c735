#include "verilator_tb/bench.hpp"

#include <fmt/core.h>

#include <initializer_list>

namespace mixcmp::verilator_tb {

namespace {

/// Prints system_ports.hpp: the constants and ports of one top, for its harness.
class PortsHeader {
public:
  PortsHeader& constant(const char* type, const char* name, int value) {
    constants_ += fmt::format("inline constexpr {} {} = {};\n", type, name, value);
    return *this;
  }
  PortsHeader& ports(std::initializer_list<const char*> names) {
    for (const char* name : names)
      bindings_ += fmt::format("  ports.{0} = Port(model.{0});\n", name);
    return *this;
  }
  std::string text(const char* type) const {
    return fmt::format(
        "#pragma once\n\n#include \"Vsystem.h\"\n#include \"ports.hpp\"\n\n"
        "namespace mixcmp::harness::system {{\n\nusing Model = Vsystem;\n\n{}\n"
        "inline {} bind(Model& model) {{\n  {} ports;\n{}  return ports;\n}}\n\n"
        "}}  // namespace mixcmp::harness::system\n",
        constants_, type, type, bindings_);
  }

private:
  std::string constants_;
  std::string bindings_;
};

std::string system_ports(const emit::Signature& s) {
  const bool refetched = s.operands == scene::OperandStore::refetched && s.references > 0;
  PortsHeader header;
  header.constant("int", "lanes", s.lanes)
      .constant("int", "references", s.references)
      .constant("int", "tdata_bytes", s.tdata_bytes)
      .constant("int", "tag_bits", s.tag_bits)
      .constant("int", "counter_bits", s.counter_bits)
      .constant("int", "slots", s.slots)
      .constant("bool", "in_order", s.order == scene::ResultOrder::in_order ? 1 : 0)
      .constant("bool", "refetched", refetched ? 1 : 0)
      .ports({"aclk", "aresetn", "s_axis_tvalid", "s_axis_tready", "s_axis_tdata", "s_axis_tuser",
              "m_axis_tvalid", "m_axis_tready", "m_axis_tdata", "m_axis_tuser"});
  if (s.counter_bits > 0) header.ports({"comparisons", "recomputations", "stalls"});
  if (refetched) {
    header.ports({"m_refetch_tvalid", "m_refetch_tready", "m_refetch_tdata", "s_refetch_tvalid",
                  "s_refetch_tready", "s_refetch_tdata"});
  }
  return header.text("Ports");
}

std::string pairwise_ports(const emit::Signature& s, const emit::SignatureEngine& engine) {
  PortsHeader header;
  const bool bitmap = engine.report_as == scene::ReportForm::bitmap;
  header.constant("int", "lanes", s.lanes)
      .constant("int", "item_bytes", engine.item_bytes)
      .constant("int", "index_bits", engine.index_bits)
      .constant("int", "counter_bits", s.counter_bits)
      .constant("int", "output_streams", engine.report_streams)
      .constant("int", "report_bytes", engine.report_bytes)
      .constant("int", "flag_bits", bitmap ? engine.report_lanes : 0)
      .ports({"aresetn", "s_axis_tvalid", "s_axis_tready", "s_axis_tdata", "s_axis_tuser",
              "s_axis_tlast", "m_axis_tvalid", "m_axis_tready", "m_axis_tdata", "m_axis_tuser",
              "m_axis_tlast"});
  if (s.counter_bits > 0) {
    header.ports({"reports", "recomputations", "busy_cycles", "stalled_cycles"});
  }
  return header.text("PairwisePorts");
}

std::string arg_min_ports(const emit::Signature& s, const emit::SignatureEngine& engine) {
  PortsHeader header;
  header.constant("int", "lanes", s.lanes)
      .constant("int", "item_bytes", engine.item_bytes)
      .constant("int", "row_bytes", engine.row_bytes)
      .constant("int", "index_bits", engine.index_bits)
      .constant("int", "tag_bits", engine.tag_bits)
      .constant("int", "counter_bits", s.counter_bits)
      .constant("int", "output_streams", 1)
      .ports({"aresetn", "s_candidate_tvalid", "s_candidate_tready", "s_candidate_tdata",
              "s_candidate_tlast", "s_axis_tvalid", "s_axis_tready", "s_axis_tdata", "s_axis_tuser",
              "s_axis_tlast", "m_axis_tvalid", "m_axis_tready", "m_axis_tdata", "m_axis_tuser",
              "m_axis_tlast", "overrun"});
  if (s.counter_bits > 0) {
    header.ports({"comparisons", "recomputations", "stalls", "rows", "stalled_cycles"});
  }
  return header.text("ArgMinPorts");
}

}  // namespace

Bench bench_of(const emit::Signature& s) {
  const auto kind = s.engine ? s.engine->kind : scene::EngineKind::none;
  switch (kind) {
    case scene::EngineKind::none: return {s.top, "simulator.cpp", system_ports(s)};
    case scene::EngineKind::pairwise:
      return {s.engine->top, "pairwise.cpp", pairwise_ports(s, *s.engine)};
    case scene::EngineKind::arg_min:
      return {s.engine->top, "arg_min.cpp", arg_min_ports(s, *s.engine)};
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::verilator_tb

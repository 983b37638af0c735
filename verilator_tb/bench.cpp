#include "verilator_tb/bench.hpp"

#include <fmt/core.h>

#include <initializer_list>

namespace mixcmp::verilator_tb {

namespace {

/// Prints system_model.hpp: the numbers of one top, and its ports in the model.
class ModelHeader {
public:
  explicit ModelHeader(const emit::Signature& signature) {
    constant("int", "lanes", signature.lanes);
    constant("int", "counter_bits", signature.counter_bits);
    constant("std::size_t", "counted_answers", static_cast<int>(emit::counted_answers(signature)));
    constant("int", "counter_address_bits", emit::counter_address_bits(signature));
    add_counter_map(signature);
  }

  ModelHeader& constant(const char* type, const char* name, int value) {
    constants_ += fmt::format("const {} {} = {};\n", type, name, value);
    return *this;
  }
  ModelHeader& ports(std::initializer_list<const char*> names) {
    for (const char* name : names)
      bindings_ += fmt::format("  ports.{0} = Port(model.{0});\n", name);
    return *this;
  }
  /// Counters that are ports of the top; those on a bus are bound to memory.
  ModelHeader& counters(std::initializer_list<const char*> names) {
    return counter_ports_ ? ports(names) : *this;
  }
  std::string text(const char* type) const {
    return fmt::format(
        "#pragma once\n\n#include \"Vsystem.h\"\n#include \"ports.hpp\"\n#include "
        "\"system.hpp\"\n\n"
        "namespace mixcmp::harness::system {{\n\n{0}\n"
        "using TopPorts = {1};\n\n"
        "inline TopPorts ports_of(Vsystem& model) {{\n  TopPorts ports;\n{2}  return ports;\n}}\n\n"
        "}}  // namespace mixcmp::harness::system\n",
        constants_, type, bindings_);
  }

private:
  /// Memory for the counters that are read on a bus, and where each of them is.
  void add_counter_map(const emit::Signature& signature) {
    counter_ports_ = emit::has_counter_ports(signature);
    if (signature.counter_map.empty()) {
      constants_ += "const std::span<const MappedCounters> counter_map;\n";
      return;
    }
    std::string entries;
    for (const emit::SignatureCounters& counters : signature.counter_map) {
      constants_ += fmt::format("static std::uint8_t {}_read[{}];\n", counters.name,
                                (counters.count * signature.counter_bits + 7) / 8);
      bindings_ += fmt::format("  ports.{0} = Port({0}_read);\n", counters.name);
      entries += fmt::format("    {{{0}, {1}, {2}_read, sizeof {2}_read}},\n", counters.count,
                             counters.offset, counters.name);
    }
    constants_ += fmt::format(
        "static const MappedCounters mapped_counters[] = {{\n{}}};\n"
        "const std::span<const MappedCounters> counter_map = mapped_counters;\n",
        entries);
    for (const char* name :
         {"awaddr", "awvalid", "awready", "wdata", "wstrb", "wvalid", "wready", "bresp", "bvalid",
          "bready", "araddr", "arvalid", "arready", "rdata", "rresp", "rvalid", "rready"}) {
      bindings_ += fmt::format("  ports.bus.{0} = Port(model.s_axi_{0});\n", name);
    }
  }

  bool counter_ports_ = false;
  std::string constants_;
  std::string bindings_;
};

std::string stream_model(const emit::Signature& s) {
  const int refetch_streams = emit::refetch_streams(s);
  ModelHeader header(s);
  header.constant("int", "refetch_streams", refetch_streams)
      .constant("int", "lanes_per_group", s.lanes_per_group)
      .constant("int", "groups", emit::group_count(s))
      .constant("int", "tdata_bytes", s.tdata_bytes)
      .constant("int", "tag_bits", s.tag_bits)
      .constant("int", "slots", s.slots)
      .constant("bool", "in_order", s.order == scene::ResultOrder::in_order ? 1 : 0)
      .ports({"aclk", "aresetn", "s_axis_tvalid", "s_axis_tready", "s_axis_tdata", "s_axis_tuser",
              "m_axis_tvalid", "m_axis_tready", "m_axis_tdata", "m_axis_tuser"});
  header.counters({"comparisons", "recomputations", "stalls"});
  if (refetch_streams > 0) {
    header.ports({"m_refetch_tvalid", "m_refetch_tready", "m_refetch_tdata", "s_refetch_tvalid",
                  "s_refetch_tready", "s_refetch_tdata"});
  }
  return header.text("Ports");
}

std::string pairwise_model(const emit::Signature& s, const emit::SignatureEngine& engine) {
  ModelHeader header(s);
  const bool bitmap = engine.report_as == scene::ReportForm::bitmap;
  header.constant("int", "item_bytes", engine.item_bytes)
      .constant("int", "index_bits", engine.index_bits)
      .constant("int", "output_streams", engine.report_streams)
      .constant("int", "report_bytes", engine.report_bytes)
      .constant("int", "flag_bits", bitmap ? engine.report_lanes : 0)
      .ports({"aresetn", "s_axis_tvalid", "s_axis_tready", "s_axis_tdata", "s_axis_tuser",
              "s_axis_tlast", "m_axis_tvalid", "m_axis_tready", "m_axis_tdata", "m_axis_tuser",
              "m_axis_tlast"});
  header.counters({"reports", "recomputations", "busy_cycles", "stalled_cycles"});
  return header.text("PairwisePorts");
}

std::string arg_min_model(const emit::Signature& s, const emit::SignatureEngine& engine) {
  ModelHeader header(s);
  header.constant("int", "item_bytes", engine.item_bytes)
      .constant("int", "row_bytes", engine.row_bytes)
      .constant("int", "index_bits", engine.index_bits)
      .constant("int", "tag_bits", engine.tag_bits)
      .constant("int", "output_streams", 1)
      .ports({"aresetn", "s_candidate_tvalid", "s_candidate_tready", "s_candidate_tdata",
              "s_candidate_tlast", "s_axis_tvalid", "s_axis_tready", "s_axis_tdata", "s_axis_tuser",
              "s_axis_tlast", "m_axis_tvalid", "m_axis_tready", "m_axis_tdata", "m_axis_tuser",
              "m_axis_tlast", "overrun"});
  header.counters({"comparisons", "recomputations", "stalls", "rows", "stalled_cycles"});
  return header.text("ArgMinPorts");
}

}  // namespace

Bench bench_of(const emit::Signature& s) {
  const auto kind = s.engine ? s.engine->kind : scene::EngineKind::none;
  switch (kind) {
    case scene::EngineKind::none: return {s.top, "simulator.cpp", stream_model(s), s.ports};
    case scene::EngineKind::pairwise:
      return {s.engine->top, "pairwise.cpp", pairwise_model(s, *s.engine), s.engine->ports};
    case scene::EngineKind::arg_min:
      return {s.engine->top, "arg_min.cpp", arg_min_model(s, *s.engine), s.engine->ports};
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::verilator_tb

#include "verilator_tb/build.hpp"

#include <fmt/core.h>

#include <chrono>
#include <initializer_list>
#include <set>

#include "embedded/harness_files.hpp"
#include "model/common/content_hash.hpp"
#include "model/common/file.hpp"
#include "model/common/folder_lock.hpp"
#include "model/common/output_file.hpp"

namespace mixcmp::verilator_tb {

namespace {

namespace fs = std::filesystem;

/// Up to two lanes build as fast in one piece; with more, each kind of channel is verilated once.
bool is_hierarchical(const System& system) {
  return system.signature.lanes > 2;
}

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
  header.constant("int", "lanes", s.lanes)
      .constant("int", "item_bytes", engine.item_bytes)
      .constant("int", "index_bits", engine.index_bits)
      .constant("int", "counter_bits", s.counter_bits)
      .ports({"aresetn", "s_axis_tvalid", "s_axis_tready", "s_axis_tdata", "s_axis_tlast",
              "m_axis_tvalid", "m_axis_tready", "m_axis_tdata", "m_axis_tuser", "m_axis_tlast"});
  if (s.counter_bits > 0) {
    header.ports(
        {"comparisons", "recomputations", "stalls", "reports", "busy_cycles", "stalled_cycles"});
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
      .ports({"aresetn", "s_candidate_tvalid", "s_candidate_tready", "s_candidate_tdata",
              "s_candidate_tlast", "s_axis_tvalid", "s_axis_tready", "s_axis_tdata", "s_axis_tuser",
              "s_axis_tlast", "m_axis_tvalid", "m_axis_tready", "m_axis_tdata", "m_axis_tuser",
              "m_axis_tlast", "overrun"});
  if (s.counter_bits > 0) {
    header.ports({"comparisons", "recomputations", "stalls", "rows", "stalled_cycles"});
  }
  return header.text("ArgMinPorts");
}

/// The top module that is simulated, and the harness that drives it.
struct Bench {
  std::string top;
  const char* main;
  std::string ports;  ///< system_ports.hpp
};

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

std::string hierarchy(const emit::Signature& s) {
  std::string text = "`verilator_config\n";
  std::set<std::string> modules;
  for (const emit::SignatureLanes& group : s.lane_groups) modules.insert(group.module);
  for (const emit::SignatureReferences& group : s.reference_groups) modules.insert(group.module);
  for (const std::string& module : modules) {
    text += fmt::format("hier_block -module \"{}\"\n", module);
  }
  return text;
}

Command verilator_command(const System& system, const Bench& bench, Waves waves, bool ccache) {
  const std::string one_source = "VM_PARALLEL_BUILDS=0 OPT_FAST=-O1";
  Command command = {
      "verilator", "--cc", "--exe", "--build", "-j", "0", "--prefix", "Vsystem", "--top-module",
      bench.top, "--Mdir", "obj",
      // Uninitialised state starts at random, so that state which reset forgets shows itself.
      "--x-initial", "unique", "--x-assign", "unique", "-Wno-fatal", "-O3",
      // This optimisation is wrong in Verilator 5.006 to 5.020 on some widths (its issues 4059,
      // 4841, 4842).
      "-fno-const-bit-op-tree", "--timescale-override", "1ns/1ns", "-CFLAGS", "-std=c++20",
      // One source for each hierarchical block and -O1 build in half the time of many sources and
      // -O2, and what is built is about as fast.
      "-MAKEFLAGS", ccache ? one_source + " OBJCACHE=ccache" : one_source};
  if (waves == Waves::on) command.push_back("--trace-fst");
  if (is_hierarchical(system)) {
    command.insert(command.end(), {"--hierarchical", "hierarchy.vlt"});
  }
  for (const std::string& file : system.signature.files) {
    command.push_back(fs::path(file).filename().string());
  }
  command.emplace_back(bench.main);
  return command;
}

/// The error where a program is missing that Verilator runs to compile what it writes.
std::optional<Error> missing_compiler() {
  for (const char* program : {"make", "g++"}) {
    const auto version = tool_version({program, "--version"}, program);
    if (!version.ok() && version.error().kind == ErrorKind::missing_tool) return version.error();
  }
  return std::nullopt;
}

/// Tells whether ccache is installed and can write its folders.
bool is_ccache_usable() {
  for (const char* setting : {"cache_dir", "temporary_dir"}) {
    const auto folder = capture({"ccache", "--get-config", setting});
    if (!folder.ok() || !folder->succeeded()) return false;
    const std::string path = folder->output.substr(0, folder->output.find('\n'));
    if (!fs::path(path).is_absolute() || !make_writable_folder(path).ok()) return false;
  }
  return true;
}

Result<SourceFiles> gather_inputs(const System& system, const Bench& bench) {
  MIXCMP_TRY(inputs, system_sources(system));
  for (const EmbeddedFile& file : harness_files()) inputs.emplace_back(file.name, file.text);
  inputs.emplace_back("system_ports.hpp", bench.ports);
  inputs.emplace_back("hierarchy.vlt", hierarchy(system.signature));
  return inputs;
}

}  // namespace

std::vector<fs::path> System::sources() const {
  std::vector<fs::path> paths;
  for (const std::string& file : signature.files) paths.push_back(directory / file);
  return paths;
}

Result<System> load_system(const fs::path& directory) {
  std::error_code unreadable;
  std::vector<fs::path> found;
  for (const auto& entry : entries_of(directory, unreadable)) {
    if (entry.path().extension() == ".json") found.push_back(entry.path());
  }
  if (found.size() != 1) {
    return Error{.file = directory.string(),
                 .message = found.empty() ? "no generated system here (no signature, <top>.json)"
                                          : "more than one .json here; which is the signature?",
                 .accepted = "a folder written by mixcmp generate"};
  }
  MIXCMP_TRY(signature, emit::read_signature(found[0]));
  return System{fs::absolute(directory), signature};
}

Result<SourceFiles> system_sources(const System& system) {
  SourceFiles inputs;
  for (const fs::path& source : system.sources()) {
    if (!path_exists(source)) {
      return Error{.file = source.string(),
                   .message = "named by the system's signature, but not there"};
    }
    MIXCMP_TRY(text, read_file(source));
    inputs.emplace_back(source.filename().string(), text);
  }
  return inputs;
}

fs::path work_folder(const fs::path& work, const std::string& name, const std::string& version,
                     const Command& command, const SourceFiles& inputs) {
  ContentHash hash;
  hash.add(version).add(shell_line(command));
  for (const auto& [file, text] : inputs) hash.add(file).add(text);
  return fs::absolute(work) / fmt::format("{}-{}", name, hash.hex().substr(0, 16));
}

Result<Executable> build_simulator(const System& system, const BuildOptions& options) {
  MIXCMP_TRY(version, tool_version({"verilator", "--version"}, "verilator"));
  const Bench bench = bench_of(system.signature);
  MIXCMP_TRY(inputs, gather_inputs(system, bench));
  const bool ccache = is_ccache_usable();
  const Command command = verilator_command(system, bench, options.waves, ccache);
  const fs::path folder = work_folder(options.work_dir, bench.top, version, command, inputs);
  MIXCMP_TRY(lock, FolderLock::take(folder, options.waiting));
  const Executable executable{folder / "obj" / "Vsystem"};
  const fs::path stamp = folder / build_stamp;
  if (fs::exists(stamp) && fs::exists(executable.path)) return executable;

  const auto start = std::chrono::steady_clock::now();
  // A killed compiler or linker leaves half a file newer than its sources, which make would keep.
  std::error_code failure;
  fs::remove_all(folder / "obj", failure);
  if (failure) return cannot_write(folder / "obj", failure.value());
  for (const auto& [name, text] : inputs) {
    MIXCMP_TRY(written, write_file(folder / name, text));
  }
  const auto run = run_tool({.command = command,
                             .directory = folder,
                             .log = folder / "build.log",
                             .progress = options.progress});
  if (!run.ok()) return missing_compiler().value_or(run.error());
  if (!fs::exists(executable.path)) {
    return Error{.file = (folder / "build.log").string(),
                 .message = "verilator ended well and wrote no simulator"};
  }
  MIXCMP_TRY(stamped, write_file(stamp, ""));
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return Executable{executable.path, taken.count()};
}

}  // namespace mixcmp::verilator_tb

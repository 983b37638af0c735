#include "verilator_tb/clocked_block.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>

namespace mixcmp::verilator_tb {

namespace {

using emit::SignaturePort;

std::string range(int width) {
  return width == 1 ? "" : fmt::format("[{}:0] ", width - 1);
}

const char* keyword(const SignaturePort& port) {
  return port.direction == rtl::Direction::input ? "input" : "output";
}

/// The ports of one direction; the widest are first, so that they lie on whole words of d or q.
std::vector<SignaturePort> ports_of(const ClockedBlock& block, rtl::Direction direction) {
  std::vector<SignaturePort> chosen;
  std::copy_if(block.ports.begin(), block.ports.end(), std::back_inserter(chosen),
               [&](const SignaturePort& port) { return port.direction == direction; });
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const auto& a, const auto& b) { return a.width > b.width; });
  return chosen;
}

int total_width(const std::vector<SignaturePort>& ports) {
  int width = 0;
  for (const SignaturePort& port : ports) width += port.width;
  return width;
}

/// {last, ..., first}: the first port in the lowest bits.
std::string concatenation(const std::vector<SignaturePort>& ports) {
  std::string text;
  for (auto port = ports.rbegin(); port != ports.rend(); ++port) {
    text += (text.empty() ? "{" : ", ") + port->name;
  }
  return text + "}";
}

std::string connections(const std::vector<SignaturePort>& ports, const char* vector) {
  std::string text;
  int offset = 0;
  for (const SignaturePort& port : ports) {
    text +=
        fmt::format(",\n    .{}({}[{}:{}])", port.name, vector, offset + port.width - 1, offset);
    offset += port.width;
  }
  return text;
}

bool is_word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
}

bool has_word(std::string_view text, std::string_view word) {
  for (auto at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const auto end = at + word.size();
    const bool begins = at == 0 || !is_word_character(text[at - 1]);
    if (begins && (end == text.size() || !is_word_character(text[end]))) return true;
  }
  return false;
}

std::string stem(const std::string& file) {
  return std::filesystem::path(file).stem().string();
}

const std::string* text_of(const std::string& module, const SourceFiles& sources) {
  for (const auto& [file, text] : sources) {
    if (stem(file) == module) return &text;
  }
  return nullptr;
}

/// The length of the longest name in a block of this module, which is that of a stub's function.
std::size_t longest_name(const std::string& module) {
  return (module + "_settle").size();
}

/// The modules that can be blocks. A reference's channel cannot: its s_request_tready follows
/// m_refetch_tready. A datapath without a register is no block, either.
std::set<std::string> candidates(const emit::Signature& signature) {
  std::set<std::string> modules;
  for (const emit::SignatureLanes& lanes : signature.lane_groups) modules.insert(lanes.module);
  for (const emit::SignatureReferences& references : signature.reference_groups) {
    const std::string& channel = references.module;
    if (references.latency_cycles == 0 || !channel.ends_with(emit::channel_suffix)) continue;
    modules.insert(channel.substr(0, channel.size() - emit::channel_suffix.size()));
  }
  return modules;
}

int reference_count(const emit::Signature& signature) {
  int count = 0;
  for (const auto& references : signature.reference_groups) count += references.count;
  return count;
}

}  // namespace

std::string ClockedBlock::wrapper() const {
  const auto inputs = ports_of(*this, rtl::Direction::input);
  const auto outputs = ports_of(*this, rtl::Direction::output);
  return fmt::format(
      "module {}_block (\n  input  wire aclk,\n  input  wire {}d,\n  output wire {}q\n);\n\n"
      "  {} block (\n    .aclk(aclk){}{}\n  );\n\nendmodule\n",
      module, range(total_width(inputs)), range(total_width(outputs)), module,
      connections(inputs, "d"), connections(outputs, "q"));
}

/// Its own names have a $, which no name of a scene has, and so no port.
std::string ClockedBlock::stub() const {
  const auto inputs = ports_of(*this, rtl::Direction::input);
  const auto outputs = ports_of(*this, rtl::Direction::output);
  std::string header;
  for (const SignaturePort& port : ports) {
    header += fmt::format(",\n  {} wire {}{}", keyword(port), range(port.width), port.name);
  }
  return fmt::format(
      "module {0} (\n  input wire aclk{1}\n);\n\n"
      "  import \"DPI-C\" context function chandle {0}_make();\n"
      "  import \"DPI-C\" function void {0}_clock(\n"
      "    input chandle block, input bit {2}d, output bit {3}q\n  );\n\n"
      "`ifdef SETTLE_BLOCKS\n"
      "  import \"DPI-C\" function void {0}_settle(input chandle block, input bit {2}d);\n"
      "  always @(negedge aclk) {0}_settle(block$, {4});\n`endif\n\n"
      "  chandle block$;\n  reg {3}q$;\n  reg {3}next$;\n\n"
      "  initial block$ = {0}_make();\n\n"
      "  always @(posedge aclk) begin\n    {0}_clock(block$, {4}, next$);\n"
      "    q$ <= next$;\n  end\n\n  assign {5} = q$;\n\nendmodule\n",
      module, header, range(total_width(inputs)), range(total_width(outputs)),
      concatenation(inputs), concatenation(outputs));
}

std::string ClockedBlock::binding() const {
  return fmt::format(
      "extern \"C\" void* {0}_make() {{\n"
      "  return mixcmp::harness::make_block<V{1}>();\n}}\n\n"
      "extern \"C\" void {0}_clock(void* block, const svBitVecVal* d, svBitVecVal* q) {{\n"
      "  static_cast<mixcmp::harness::ClockedBlock*>(block)->clock(d, q);\n}}\n\n"
      "extern \"C\" void {0}_settle(void* block, const svBitVecVal* d) {{\n"
      "  static_cast<mixcmp::harness::ClockedBlock*>(block)->settle(d);\n}}\n",
      module, wrapper_name());
}

std::optional<ClockedBlock> clocked_block(const std::string& module, const std::string& text) {
  static const std::regex port_line(
      R"(  (input|output) +wire +(?:\[(\d+):0\] +)?([A-Za-z_]\w*),?)");
  ClockedBlock block{.module = module, .ports = {}};
  std::istringstream lines(text);
  std::string line;
  while (line != "module " + module + " (") {
    if (!std::getline(lines, line)) return std::nullopt;
  }
  bool clocked = false;
  while (std::getline(lines, line) && line != ");") {
    std::smatch found;
    if (!std::regex_match(line, found, port_line)) return std::nullopt;
    if (found[3] == "aclk") {
      clocked = true;
      continue;
    }
    block.ports.push_back(
        {.name = found[3],
         .direction = found[1] == "input" ? rtl::Direction::input : rtl::Direction::output,
         .width = found[2].matched ? std::stoi(found[2]) + 1 : 1});
  }
  // The stub passes vectors, so both directions need two bits at least.
  for (const auto direction : {rtl::Direction::input, rtl::Direction::output}) {
    if (total_width(ports_of(block, direction)) < 2) return std::nullopt;
  }
  return clocked ? std::optional(block) : std::nullopt;
}

std::vector<ClockedBlock> clocked_blocks(const emit::Signature& signature,
                                         const SourceFiles& sources) {
  std::vector<ClockedBlock> blocks;
  if (emit::group_count(signature) == 1 && reference_count(signature) < 2) return blocks;
  for (const std::string& module : candidates(signature)) {
    const std::string* const text = text_of(module, sources);
    if (text == nullptr || longest_name(module) > emit::longest_module_name) continue;
    if (auto block = clocked_block(module, *text)) blocks.push_back(std::move(*block));
  }
  return blocks;
}

SourceFiles files_of_module(const std::string& module, const SourceFiles& all) {
  std::set<std::string> needed = {module};
  for (std::size_t known = 0; known != needed.size();) {
    known = needed.size();
    for (const auto& [file, text] : all) {
      if (!needed.contains(stem(file))) continue;
      for (const auto& [other, unused] : all) {
        if (!needed.contains(stem(other)) && has_word(text, stem(other)))
          needed.insert(stem(other));
      }
    }
  }
  SourceFiles files;
  std::copy_if(all.begin(), all.end(), std::back_inserter(files),
               [&](const auto& source) { return needed.contains(stem(source.first)); });
  return files;
}

}  // namespace mixcmp::verilator_tb

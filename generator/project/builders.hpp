#pragma once

#include <string>
#include <vector>

#include "generator/project/project.hpp"
#include "generator/project/text_template.hpp"

/// One builder of files for each tool, and the functions that they share.
namespace mixcmp::project {

using emit::GeneratedFile;

/// Values that most templates use: TOP, the system's module; BUILD_TOP, the module to build;
/// VERSION; PROVENANCE, lines that begin with `comment`; TARGET_MHZ, PERIOD_NS and PORT_DELAYS,
/// commands of SDC.
Values common_values(const ProjectSpec& spec, const std::string& comment);

/// Says whether a module with these ports counts, with how many bits, and how a test bench reads
/// the counts.
void add_counter_values(const emit::Signature& signature,
                        const std::vector<emit::SignaturePort>& ports, Values& values);

/// Puts each line between `before` and `after`, and joins them.
std::string joined(const std::vector<std::string>& lines, const std::string& before,
                   const std::string& after);

/// The Verilog files of the system, in compile order, each between `before` and `after`.
std::string source_list(const ProjectSpec& spec, const std::string& before,
                        const std::string& after);

std::string in_capitals(std::string name);

/// A script made from a template, which its user may execute.
GeneratedFile script_from(const std::string& name, const std::string& file, const Values& values);
/// Any other file made from a template.
GeneratedFile file_from(const std::string& name, const std::string& file, const Values& values);

/// The test bench in Verilog, its vectors, and the same test for cocotb.
std::vector<GeneratedFile> testbench_files(const ProjectSpec& spec);
/// The test bench of the engine in Verilog, and its vectors; for a spec that tests_engine().
std::vector<GeneratedFile> engine_testbench_files(const ProjectSpec& spec);

/// The bytes as one hexadecimal number, whose lowest byte is the first.
std::string hexadecimal(const std::vector<std::uint8_t>& bytes);

/// A wrapper with streams of their own where the top has vectors of streams, an instantiation
/// template and VHDL declarations.
std::vector<GeneratedFile> integration_files(const ProjectSpec& spec);

std::vector<GeneratedFile> icarus_files(const ProjectSpec& spec);
std::vector<GeneratedFile> verilator_files(const ProjectSpec& spec);
Result<std::vector<GeneratedFile>> yosys_files(const ProjectSpec& spec);
Result<std::vector<GeneratedFile>> nextpnr_files(const ProjectSpec& spec);
std::vector<GeneratedFile> vivado_files(const ProjectSpec& spec);
std::vector<GeneratedFile> quartus_files(const ProjectSpec& spec);
std::vector<GeneratedFile> fusesoc_files(const ProjectSpec& spec);

}  // namespace mixcmp::project

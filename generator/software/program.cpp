#include "generator/software/program.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <sstream>

#include "generator/software/source.hpp"
#include "model/common/file.hpp"
#include "model/common/output_file.hpp"
#include "model/golden/big_float.hpp"
#include "model/golden/encoding.hpp"
#include "model/profile/operands.hpp"

namespace mixcmp::gen {
namespace {

namespace fs = std::filesystem;

/// Multiply-adds must not be contracted: proofs and golden model round every operation. The other
/// two let g++ vectorise roots and conditions, and change no result.
const model::Command compile_command = {"g++",
                                        "-std=c++20",
                                        "-O3",
                                        "-march=native",
                                        "-ffp-contract=off",
                                        "-fno-math-errno",
                                        "-fno-trapping-math",
                                        "-pthread",
                                        "comparison.cpp",
                                        "-o",
                                        "comparison"};

void write_word(model::OutputFile& file, std::uint64_t word) {
  file.write({reinterpret_cast<const char*>(&word), sizeof word});
}

/// The numbers of items, then the columns as doubles: program/harness.hpp reads them.
model::Result<model::Done> write_data(const fs::path& path, const model::Comparisons& data) {
  const model::OperandSource operands(data);
  const SoftwareColumns columns = software_columns(data);
  MIXCMP_TRY(file, model::OutputFile::open(path));
  write_word(file, data.tables().front().rows());
  write_word(file, data.tables().back().rows());
  for (const std::size_t input : columns.inputs) {
    const std::vector<double>& values = operands.values(input);
    write_word(file, values.size());
    for (const double value : values) write_word(file, std::bit_cast<std::uint64_t>(value));
  }
  return file.commit();
}

/// The lines of one kernel, found or added.
KernelOutput& kernel_of(std::vector<KernelOutput>& kernels, const std::string& name) {
  for (KernelOutput& kernel : kernels) {
    if (kernel.name == name) return kernel;
  }
  kernels.push_back({.name = name});
  return kernels.back();
}

bool read_line(const std::string& line, std::vector<KernelOutput>& kernels) {
  std::istringstream words(line);
  std::string what, name;
  words >> what >> name;
  KernelOutput& kernel = kernel_of(kernels, name);
  if (what == "tally") {
    VerdictCounts& counts = kernel.verdicts;
    words >> counts.less >> counts.equal >> counts.greater >> counts.unordered >> kernel.recomputed;
  } else if (what == "verdicts") {
    words >> kernel.letters;
  } else if (what == "rate") {
    MeasuredRate rate;
    words >> rate.threads >> rate.best_per_s >> rate.processor_share;
    rate.median_per_s = rate.best_per_s;
    kernel.rates.push_back(rate);
  } else {
    return false;
  }
  return !words.fail();
}

model::Result<std::vector<KernelOutput>> parse(const fs::path& log) {
  MIXCMP_TRY(text, model::read_file(log));
  std::istringstream lines(text);
  std::vector<KernelOutput> kernels;
  for (std::string line; std::getline(lines, line);) {
    if (read_line(line, kernels)) continue;
    return model::Error{.file = log.string(),
                        .message = "the comparison printed what it should not",
                        .received = line.substr(0, 200)};
  }
  return kernels;
}

}  // namespace

const model::Command& SoftwareProgram::command() {
  return compile_command;
}

model::Result<SoftwareProgram> SoftwareProgram::compile(const model::Scene& scene,
                                                        const model::Comparisons& data,
                                                        const FloatFilters& filters,
                                                        const BaselineOptions& options) {
  MIXCMP_TRY(compiler, model::tool_version({"g++", "--version"}, "g++"));
  const fs::path& work = options.work;
  MIXCMP_TRY(written,
             model::write_file(work / "comparison.cpp", software_source(scene, data, filters)));
  MIXCMP_TRY(compiled, model::run_tool({.command = compile_command,
                                        .directory = work,
                                        .log = work / "compile.log",
                                        .progress = options.progress}));
  return SoftwareProgram(options, compiler);
}

model::Result<std::vector<KernelOutput>> SoftwareProgram::run(
    const model::Comparisons& data, const model::Command& arguments) const {
  MIXCMP_TRY(written, write_data(options_.work / "data.bin", data));
  model::Command command = {"./comparison", "data.bin"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const fs::path log = options_.work / "run.log";
  MIXCMP_TRY(finished, model::run_tool({.command = command,
                                        .directory = options_.work,
                                        .log = log,
                                        .progress = options_.progress}));
  return parse(log);
}

model::Result<std::vector<KernelOutput>> SoftwareProgram::verdicts(
    const model::Comparisons& data) const {
  return run(data, {"verdicts"});
}

model::Result<std::vector<KernelOutput>> SoftwareProgram::measure(const model::Comparisons& data,
                                                                  unsigned threads) const {
  return run(data, {"measure", std::to_string(threads), std::to_string(options_.rounds),
                    fmt::format("{}", options_.seconds)});
}

}  // namespace mixcmp::gen

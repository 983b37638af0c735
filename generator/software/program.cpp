#include "generator/software/program.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <sstream>

#include "generator/software/source.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/output_file.hpp"
#include "model/comparison/data/operand_source.hpp"

namespace mixcmp::software {
namespace {

namespace fs = std::filesystem;

/// Multiply-adds must not be contracted: proofs and golden model round every operation.
/// -fno-math-errno and -fno-trapping-math let g++ vectorise roots and conditions, and change no
/// result.
const Command compile_command = {"g++",
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

void write_word(OutputFile& file, std::uint64_t word) {
  file.write({reinterpret_cast<const char*>(&word), sizeof word});
}

/// Writes the numbers of items, then the columns as doubles; program/harness.hpp reads them.
Result<Done> write_data(const fs::path& path, const data::Comparisons& data) {
  const data::OperandSource operands(data);
  const SoftwareColumns columns = software_columns(data);
  MIXCMP_TRY(file, OutputFile::open(path));
  write_word(file, data.tables().front().rows());
  write_word(file, data.tables().back().rows());
  for (const std::size_t input : columns.inputs) {
    const std::vector<double>& values = operands.values(input);
    write_word(file, values.size());
    for (const double value : values) write_word(file, std::bit_cast<std::uint64_t>(value));
  }
  return file.commit();
}

/// Finds the output of one kernel, or adds an empty one.
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

Error unusable(const fs::path& log, const char* what, std::string received) {
  return {.file = log.string(),
          .message = fmt::format("the program that g++ made of the comparison {}", what),
          .received = std::move(received)};
}

/// Reads the program's log, whose last line must be "end".
Result<std::vector<KernelOutput>> parse(const fs::path& log) {
  MIXCMP_TRY(text, read_file(log));
  std::istringstream lines(text);
  std::vector<KernelOutput> kernels;
  bool ended = false;
  for (std::string line; std::getline(lines, line);) {
    if (!ended && line == "end") {
      ended = true;
    } else if (ended || !read_line(line, kernels)) {
      return unusable(log, "printed what it should not", line.substr(0, 200));
    }
  }
  if (ended && !kernels.empty()) return kernels;
  return unusable(log, "did not print all", fmt::format("{} kernels", kernels.size()));
}

/// Tells whether the kernel has a rate for every round, on one thread and on all.
bool has_all_rates(const KernelOutput& kernel, unsigned threads, int rounds) {
  const auto measured = [&](unsigned with) {
    return std::count_if(kernel.rates.begin(), kernel.rates.end(),
                         [&](const MeasuredRate& rate) { return rate.threads == with; });
  };
  return measured(1) == rounds && measured(threads) == rounds;
}

}  // namespace

const Command& SoftwareProgram::command() {
  return compile_command;
}

Result<SoftwareProgram> SoftwareProgram::compile(const scene::Scene& scene,
                                                 const data::Comparisons& data,
                                                 const FloatFilters& filters,
                                                 const BaselineOptions& options) {
  MIXCMP_TRY(compiler, tool_version({"g++", "--version"}, "g++"));
  const fs::path& work = options.work;
  std::error_code absent;
  fs::remove(work / "comparison", absent);  // so that no older program is run
  MIXCMP_DO(write_file(work / "comparison.cpp", software_source(scene, data, filters)));
  MIXCMP_DO(run_tool({.command = compile_command,
                      .directory = work,
                      .log = work / "compile.log",
                      .progress = options.progress}));
  if (!fs::exists(work / "comparison")) {
    return Error{.file = (work / "compile.log").string(),
                 .message = "g++ ended well and wrote no program"};
  }
  return SoftwareProgram(options, compiler);
}

Result<std::vector<KernelOutput>> SoftwareProgram::run(const data::Comparisons& data,
                                                       const Command& arguments) const {
  MIXCMP_DO(write_data(options_.work / "data.bin", data));
  Command command = {"./comparison", "data.bin"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const fs::path log = options_.work / "run.log";
  MIXCMP_DO(run_tool(
      {.command = command, .directory = options_.work, .log = log, .progress = options_.progress}));
  return parse(log);
}

Result<std::vector<KernelOutput>> SoftwareProgram::verdicts(const data::Comparisons& data) const {
  MIXCMP_TRY(kernels, run(data, {"verdicts"}));
  for (const KernelOutput& kernel : kernels) {
    if (kernel.letters.size() == data.size()) continue;
    return unusable(options_.work / "run.log", "did not print all",
                    fmt::format("{} verdicts of {}", kernel.letters.size(), data.size()));
  }
  return kernels;
}

Result<std::vector<KernelOutput>> SoftwareProgram::measure(const data::Comparisons& data,
                                                           unsigned threads) const {
  MIXCMP_TRY(kernels,
             run(data, {"measure", std::to_string(threads), std::to_string(options_.rounds),
                        fmt::format("{}", options_.seconds)}));
  for (const KernelOutput& kernel : kernels) {
    if (has_all_rates(kernel, threads, options_.rounds)) continue;
    return unusable(options_.work / "run.log", "did not print all",
                    fmt::format("{} rates of {}", kernel.rates.size(), kernel.name));
  }
  return kernels;
}

}  // namespace mixcmp::software

#include "verilator_tb/icarus.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <sstream>

#include "embedded/icarus_files.hpp"

namespace mixcmp::tb {

namespace {

namespace fs = std::filesystem;

model::Error cannot_write(const fs::path& path) {
  return {.file = path.string(), .message = "cannot write"};
}

/// One line of hexadecimal for each comparison, for $readmemh.
model::Result<model::Done> write_stimulus(const fs::path& path, const Block& block,
                                          std::size_t tdata_bytes) {
  std::ofstream stream(path);
  for (std::size_t k = 0; k < block.comparisons; ++k) {
    std::string line;
    for (std::size_t byte = tdata_bytes; byte-- > 0;) {
      line += fmt::format("{:02x}", block.operands[k * tdata_bytes + byte]);
    }
    stream << line << '\n';
  }
  if (stream.flush()) return model::Done{};
  return cannot_write(path);
}

model::Result<model::Done> write_resets(const fs::path& path, const Block& block) {
  std::ofstream stream(path);
  for (const std::uint64_t position : block.resets) stream << fmt::format("{:x}\n", position);
  stream << "ffffffff\n";  // the end; $readmemh warns about an empty file
  if (stream.flush()) return model::Done{};
  return cannot_write(path);
}

model::Result<model::Done> write_testbench(const fs::path& folder) {
  for (const model::EmbeddedFile& file : icarus_files()) {
    std::ofstream stream(folder / file.name);
    stream << file.text;
    if (!stream.flush()) return cannot_write(folder / file.name);
  }
  return model::Done{};
}

Command compile_command(const System& system, const Block& block,
                        const SimulationOptions& options) {
  const gen::Signature& s = system.signature;
  Command command = {"iverilog",  "-g2001",           "-o", "simulation", "-s",
                     "testbench", "-DSYSTEM=" + s.top};
  if (s.counter_bits > 0) command.push_back("-DCOUNTERS");
  if (s.operands == model::OperandStore::refetched && s.references > 0) {
    command.push_back("-DREFETCHED");
  }
  const auto parameter = [&command](const char* name, std::uint64_t value) {
    command.push_back(fmt::format("-Ptestbench.{}={}", name, value));
  };
  parameter("LANES", static_cast<std::uint64_t>(s.lanes));
  parameter("REFERENCES", static_cast<std::uint64_t>(s.references));
  parameter("TDATA_BYTES", static_cast<std::uint64_t>(s.tdata_bytes));
  parameter("TAG_BITS", static_cast<std::uint64_t>(s.tag_bits));
  parameter("COUNTER_BITS", static_cast<std::uint64_t>(s.counter_bits));
  parameter("SLOTS", static_cast<std::uint64_t>(s.slots));
  parameter("IN_ORDER", s.order == model::ResultOrder::in_order ? 1 : 0);
  parameter("COUNT", block.comparisons);
  parameter("RESETS", block.resets.size());
  parameter("STRESSED", options.traffic == TrafficKind::stressed ? 1 : 0);
  parameter("SEED", options.seed % 0x7fffffff);
  parameter("HANG_CYCLES", options.hang_cycles);
  command.push_back("testbench.v");
  for (const fs::path& source : system.sources()) command.push_back(source.string());
  return command;
}

Command run_command(const SimulationOptions& options) {
  Command command = {"vvp", "-n", "simulation"};
  if (!options.waves.empty()) {
    command.push_back("-fst");
    command.push_back("+waves=" + fs::absolute(options.waves).string());
  }
  for (const std::string& plusarg : options.plusargs) command.push_back("+" + plusarg);
  return command;
}

/// "result lane position tdata accepted left", "violation fault lane position tag cycle",
/// "end" with three pairs of counted and observed, "state n cycles".
bool parse_line(const std::string& line, Answer& answer) {
  std::istringstream words(line);
  std::string kind;
  words >> kind;
  if (kind == "result") {
    wire::Result r{};
    words >> r.lane >> r.position >> std::hex >> r.tdata >> std::dec >> r.cycle_accepted >>
        r.cycle_left;
    answer.results.push_back(r);
  } else if (kind == "violation") {
    std::uint32_t fault = 0;
    std::int64_t position = 0;
    wire::Violation v{};
    words >> fault >> v.lane >> position >> std::hex >> v.tag >> std::dec >> v.cycle;
    v.fault = static_cast<wire::Fault>(fault);
    v.position = position < 0 ? wire::no_position : static_cast<std::uint64_t>(position);
    answer.violations.push_back(v);
  } else if (kind == "end") {
    wire::LaneEnd end{};
    for (int k = 0; k < 3; ++k) words >> end.counted[k] >> end.observed[k];
    answer.lanes.push_back(end);
  } else if (kind == "state") {
    std::uint64_t state = 0;
    words >> state >> answer.cycles;
    answer.state = static_cast<wire::State>(state);
  }
  return !words.fail();
}

model::Result<Answer> read_results(const fs::path& path) {
  std::ifstream stream(path);
  Answer answer;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (parse_line(line, answer)) continue;
    return model::Error{.file = path.string(),
                        .line = number,
                        .message = "the testbench wrote what cannot be read",
                        .received = line};
  }
  if (answer.state != wire::State::running) return answer;
  return model::Error{.file = path.string(), .message = "the simulation ended before its time"};
}

}  // namespace

model::Result<Answer> simulate_in_icarus(const System& system, const Block& block,
                                         const fs::path& work_dir, const SimulationOptions& options,
                                         const Progress& progress) {
  MIXCMP_TRY(version, tool_version("iverilog", "-V", "iverilog"));
  const fs::path folder =
      fs::absolute(work_dir) / fmt::format("{}-icarus-{}", system.signature.top, getpid());
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) return model::Error{.file = folder.string(), .message = failure.message()};
  const auto bytes = static_cast<std::size_t>(system.signature.tdata_bytes);
  MIXCMP_TRY(stimulus, write_stimulus(folder / "stimulus.hex", block, bytes));
  MIXCMP_TRY(resets, write_resets(folder / "resets.hex", block));
  MIXCMP_TRY(testbench, write_testbench(folder));
  MIXCMP_TRY(compiled, run_tool(compile_command(system, block, options), folder,
                                folder / "compile.log", progress));
  MIXCMP_TRY(simulated,
             run_tool(run_command(options), folder, folder / "simulation.log", progress));
  auto answer = read_results(folder / "results.txt");
  if (answer.ok()) fs::remove_all(folder, failure);
  return answer;
}

}  // namespace mixcmp::tb

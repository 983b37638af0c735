#include "verilator_tb/icarus.hpp"

#include <fmt/core.h>

#include <bit>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <sstream>

#include "embedded/icarus_files.hpp"
#include "model/base/common/folder_lock.hpp"
#include "model/base/common/output_file.hpp"

namespace mixcmp::verilator_tb {

namespace {

namespace fs = std::filesystem;

/// The comparisons of a run in words, one for each lane of a group.
struct Words {
  std::uint64_t comparisons;
  std::uint64_t lanes;  ///< of a group

  std::uint64_t count() const { return (comparisons + lanes - 1) / lanes; }
};

/// One line of hexadecimal for each word, for $readmemh. The last word is filled up with its own
/// first comparison.
std::string stimulus_text(const Block& block, const Words& words, std::size_t tdata_bytes) {
  std::string text;
  for (std::uint64_t word = 0; word < words.count(); ++word) {
    const std::uint64_t first = word * words.lanes;
    for (std::uint64_t k = words.lanes; k-- > 0;) {
      const std::uint64_t comparison = first + k < words.comparisons ? first + k : first;
      for (std::size_t byte = tdata_bytes; byte-- > 0;) {
        text += fmt::format("{:02x}", block.operands[comparison * tdata_bytes + byte]);
      }
    }
    text += '\n';
  }
  return text;
}

std::string resets_text(const Block& block, const Words& words) {
  std::string text;
  for (const std::uint64_t position : block.resets) {
    text += fmt::format("{:x}\n", position / words.lanes);
  }
  return text + "ffffffff\n";  // the end; $readmemh warns about an empty file
}

/// Tells the testbench where on a bus it finds the counters, if they are on one.
template <class SetParameter>
void add_counter_map(const emit::Signature& signature, SetParameter set) {
  if (signature.counter_map.empty()) return;
  std::uint64_t first = 0;
  for (const emit::SignatureCounters& counters : signature.counter_map) {
    std::string name = "FIRST_";
    for (const char c : counters.name) {
      name += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    set(name.c_str(), first);
    first += static_cast<std::uint64_t>(counters.count);
  }
  set("MAPPED_COUNTERS", first);
  set("COUNTER_ADDRESS_BITS", static_cast<std::uint64_t>(emit::counter_address_bits(signature)));
}

Command compile_command(const System& system, const Block& block, const Words& words,
                        const SimulationOptions& options) {
  const emit::Signature& s = system.signature;
  Command command = {"iverilog",  "-g2001",           "-o", "simulation", "-s",
                     "testbench", "-DSYSTEM=" + s.top};
  if (s.counter_bits > 0) command.push_back("-DCOUNTERS");
  if (!s.counter_map.empty()) command.push_back("-DCOUNTER_PORT");
  const bool refetched = emit::refetch_streams(s) > 0;
  if (refetched) command.push_back("-DREFETCHED");
  const auto parameter = [&command](const char* name, std::uint64_t value) {
    command.push_back(fmt::format("-Ptestbench.{}={}", name, value));
  };
  parameter("LANES", static_cast<std::uint64_t>(emit::group_count(s)));
  parameter("GROUP", words.lanes);
  if (refetched)
    parameter("NAME_BITS", static_cast<std::uint64_t>(std::bit_width(words.lanes - 1)));
  parameter("REFERENCES", static_cast<std::uint64_t>(s.references));
  parameter("REFETCH_STREAMS",
            static_cast<std::uint64_t>(refetched ? emit::refetch_streams(s) : s.references));
  parameter("TDATA_BYTES", static_cast<std::uint64_t>(s.tdata_bytes));
  parameter("TAG_BITS", static_cast<std::uint64_t>(s.tag_bits));
  parameter("COUNTER_BITS", static_cast<std::uint64_t>(s.counter_bits));
  parameter("SLOTS", static_cast<std::uint64_t>(s.slots));
  parameter("IN_ORDER", s.order == scene::ResultOrder::in_order ? 1 : 0);
  parameter("COUNT", words.count());
  parameter("RESETS", block.resets.size());
  parameter("STRESSED", options.traffic == TrafficKind::stressed ? 1 : 0);
  parameter("SEED", options.seed % 0x7fffffff);
  parameter("HANG_CYCLES", options.hang_cycles);
  add_counter_map(s, parameter);
  command.push_back("testbench.v");
  if (!s.counter_map.empty()) command.push_back("counter_reader.v");
  for (const fs::path& source : system.sources()) {
    command.push_back(source.filename().string());
  }
  return command;
}

/// The link in the work folder through which vvp reaches the folder of the waves: its $dumpfile
/// takes only ASCII names.
constexpr const char* waves_link = "waves";

Result<Done> link_waves(const fs::path& folder, const fs::path& waves) {
  std::error_code failed;
  fs::remove(folder / waves_link, failed);
  fs::create_directory_symlink(fs::absolute(waves).parent_path(), folder / waves_link, failed);
  if (failed) return cannot_write(folder / waves_link, failed.value());
  return Done{};
}

Command run_command(const SimulationOptions& options) {
  Command command = {"vvp", "-n", "simulation"};
  if (!options.waves.empty()) {
    command.push_back("-fst");
    command.push_back("+waves=" + (waves_link / options.waves.filename()).string());
  }
  for (const std::string& plusarg : options.plusargs) command.push_back("+" + plusarg);
  return command;
}

/// Adds the results of a word, but not those of lanes that only filled it up.
void add_results(const harness::wire::Result& word, const std::vector<std::uint32_t>& tdata,
                 const Words& words, Answer& answer) {
  for (std::uint32_t k = 0; k < tdata.size(); ++k) {
    harness::wire::Result result = word;
    result.lane = static_cast<std::uint32_t>(word.lane * words.lanes + k);
    result.position = word.position * words.lanes + k;
    result.tdata = tdata[k];
    if (k == 0 || result.position < words.comparisons) answer.results.push_back(result);
  }
}

/// Adds a violation; a word that was lost or hangs, as one of each of its comparisons.
void add_violation(harness::wire::Violation violation, const Words& words, Answer& answer) {
  if (violation.fault != harness::wire::Fault::unknown_refetch) {  // which names a reference
    violation.lane *= static_cast<std::uint32_t>(words.lanes);
  }
  const bool is_of_a_word = violation.fault == harness::wire::Fault::lost ||
                            violation.fault == harness::wire::Fault::hung;
  answer.violations.push_back(violation);
  for (std::uint64_t k = 1; is_of_a_word && k < words.lanes; ++k) {
    if (++violation.position < words.comparisons) answer.violations.push_back(violation);
  }
}

/// Reads one line of the testbench: "result lane position accepted left tdata ...", "violation
/// fault lane position tag cycle", "end" with three pairs of counted and observed, "answers n" of
/// the next reference, or "state n cycles". With groups of lanes, a lane is a group, a position
/// that of a word, and there is a tdata for each lane.
bool parse_line(const std::string& line, const Words& group, Answer& answer) {
  std::istringstream words(line);
  std::string kind;
  words >> kind;
  if (kind == "result") {
    harness::wire::Result r{};
    words >> r.lane >> r.position >> r.cycle_accepted >> r.cycle_left >> std::hex;
    std::vector<std::uint32_t> tdata(group.lanes);
    for (std::uint32_t& each : tdata) words >> each;
    add_results(r, tdata, group, answer);
  } else if (kind == "violation") {
    std::uint32_t fault = 0;
    std::int64_t position = 0;
    harness::wire::Violation v{};
    words >> fault >> v.lane >> position >> std::hex >> v.tag >> std::dec >> v.cycle;
    v.fault = static_cast<harness::wire::Fault>(fault);
    v.position = position < 0 ? harness::wire::no_position
                              : static_cast<std::uint64_t>(position) * group.lanes;
    add_violation(v, group, answer);
  } else if (kind == "end") {
    harness::wire::CounterValues end{};
    for (int k = 0; k < 3; ++k) words >> end.counted[k] >> end.observed[k];
    answer.groups.push_back(end);
  } else if (kind == "answers") {
    words >> answer.answers.emplace_back();
  } else if (kind == "state") {
    std::uint64_t state = 0;
    words >> state >> answer.cycles;
    if (state > static_cast<std::uint64_t>(harness::wire::State::stopped)) return false;
    answer.state = static_cast<harness::wire::State>(state);
  } else {
    return false;
  }
  return !words.fail();
}

/// Checks the preconditions of the judge: each result belongs to a comparison that was offered, no
/// comparison has two results, and each lane with counters reports them once.
Result<Done> check_results(const Answer& answer, const Block& block,
                           const emit::Signature& signature, const fs::path& path) {
  std::vector<bool> has_left(block.comparisons);
  for (const harness::wire::Result& result : answer.results) {
    const bool known = result.position < block.comparisons &&
                       result.lane < static_cast<std::uint32_t>(signature.lanes);
    if (known && !has_left[result.position]) {
      has_left[result.position] = true;
      continue;
    }
    return Error{.file = path.string(),
                 .message = "the simulator wrote results that cannot be",
                 .received = fmt::format("comparison {} from lane {}{}", result.position,
                                         result.lane, known ? " a second time" : ""),
                 .accepted = fmt::format("each of {} comparisons once, from one of {} lanes",
                                         block.comparisons, signature.lanes)};
  }
  const bool counts = answer.state == harness::wire::State::drained && signature.counter_bits > 0;
  const std::size_t ends = counts ? static_cast<std::size_t>(emit::group_count(signature)) : 0;
  const std::size_t answers =
      counts ? static_cast<std::size_t>(emit::counted_answers(signature)) : 0;
  if (answer.groups.size() == ends && answer.answers.size() == answers) return Done{};
  return Error{.file = path.string(),
               .message = "the simulator wrote counters that cannot be",
               .received = fmt::format("those of {} lanes or groups", answer.groups.size()),
               .accepted = fmt::format("those of {}", ends)};
}

Result<Answer> read_results(const fs::path& path, const Words& words) {
  std::ifstream stream(path);
  Answer answer;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    const bool is_whole = !stream.eof();  // a full disk may have cut off its end
    if (is_whole && parse_line(line, words, answer)) continue;
    return Error{.file = path.string(),
                 .line = number,
                 .message = "the testbench wrote what cannot be read",
                 .received = line};
  }
  if (answer.state != harness::wire::State::running) return answer;
  return Error{.file = path.string(), .message = "the simulation ended before its time"};
}

}  // namespace

Error naming_the_package(Error error, const std::string& program) {
  if (error.kind != ErrorKind::missing_tool) return error;
  // Since iverilog ran already, apt-get takes the package for installed.
  error.accepted = program + ", on Debian: apt-get install --reinstall iverilog";
  return error;
}

Result<Answer> simulate_in_icarus(const System& system, const Block& block,
                                  const fs::path& work_dir, const SimulationOptions& options,
                                  const Progress& progress, const Waiting& waiting) {
  MIXCMP_TRY(version, tool_version({"iverilog", "-V"}, "iverilog"));
  MIXCMP_TRY(inputs, system_sources(system));
  const auto bytes = static_cast<std::size_t>(system.signature.tdata_bytes);
  for (const EmbeddedFile& file : icarus_files()) inputs.emplace_back(file.name, file.text);
  const Words words{block.comparisons,
                    static_cast<std::uint64_t>(system.signature.lanes_per_group)};
  inputs.emplace_back("stimulus.hex", stimulus_text(block, words, bytes));
  inputs.emplace_back("resets.hex", resets_text(block, words));
  const Command command = compile_command(system, block, words, options);
  const fs::path folder =
      work_folder(work_dir, system.signature.top + "-icarus", version, command, inputs);
  MIXCMP_TRY(lock, FolderLock::take(folder, waiting));
  for (const auto& [name, text] : inputs) {
    MIXCMP_DO(write_file(folder / name, text));
  }
  std::error_code failure;
  fs::remove(folder / "results.txt", failure);
  MIXCMP_DO(run_tool({.command = command,
                      .directory = folder,
                      .log = folder / "compile.log",
                      .progress = progress}));
  if (!options.waves.empty()) {
    MIXCMP_DO(link_waves(folder, options.waves));
  }
  const auto simulated = run_tool({.command = run_command(options),
                                   .directory = folder,
                                   .log = folder / "simulation.log",
                                   .progress = progress});
  if (!simulated.ok()) return naming_the_package(simulated.error(), "vvp");
  MIXCMP_TRY(answer, read_results(folder / "results.txt", words));
  MIXCMP_DO(check_results(answer, block, system.signature, folder / "results.txt"));
  return answer;
}

}  // namespace mixcmp::verilator_tb

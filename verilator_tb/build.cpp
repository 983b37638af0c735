#include "verilator_tb/build.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "embedded/harness_files.hpp"
#include "model/base/common/content_hash.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/output_file.hpp"
#include "verilator_tb/bench.hpp"
#include "verilator_tb/clocked_block.hpp"

namespace mixcmp::verilator_tb {

namespace {

namespace fs = std::filesystem;

/// Verilator and make as they are called for every model.
struct Tools {
  std::string version;
  Command verilator;
  std::string make;
};

void append(Command& command, std::initializer_list<std::string> words) {
  command.insert(command.end(), words);
}

Command verilator_call(Waves waves) {
  Command command = {"verilator", "--cc",
                     // Uninitialised state starts at random, so that state which reset forgets
                     // shows itself.
                     "--x-initial", "unique", "--x-assign", "unique", "-Wno-fatal", "-O3",
                     // This optimisation is wrong in Verilator 5.006 to 5.020 on some widths (its
                     // issues 4059, 4841, 4842).
                     "-fno-const-bit-op-tree",
                     // Compilers take twice as long for the functions of thousands of lines that
                     // Verilator makes of a system of many lanes otherwise.
                     "--output-split-cfuncs", "200", "--timescale-override", "1ns/1ns", "--Mdir",
                     "obj"};
  if (waves == Waves::on) {
    // Parameters never change, and one function that writes all waves is slow to compile: without
    // these options g++ takes half as long again.
    append(command, {"--trace-fst", "--no-trace-params", "--output-split-ctrace", "200",
                     "+define+SETTLE_BLOCKS"});
  }
  return command;
}

/// The call of make in a makefile. One source for each model and -O1 build in half the time of many
/// sources and -O2, and the result is about as fast. A user who looks at waves waits for the
/// compiler and simulates little.
std::string make_call(Waves waves, bool ccache) {
  return fmt::format("$(MAKE) VM_PARALLEL_BUILDS=0 OPT_FAST={0} OPT_GLOBAL={0}{1}",
                     waves == Waves::on ? "-O0" : "-O1", ccache ? " OBJCACHE=ccache" : "");
}

/// The comments before a module tell which scene and which command it comes from. A block does
/// without them, because it serves several.
std::string without_header(const std::string& text) {
  std::size_t start = 0;
  while (text.compare(start, 2, "//") == 0) {
    const std::size_t end = text.find('\n', start);
    if (end == std::string::npos) return "";
    start = end + 1;
  }
  return text.substr(start);
}

ModelBuild block_build(const ClockedBlock& block, const SourceFiles& sources,
                       const fs::path& work_dir, const Tools& tools) {
  const std::string top = block.wrapper_name();
  ModelBuild build{.folder = {},
                   .prefix = "V" + top,
                   .product = "V" + top + "__ALL.a",
                   .compile = tools.verilator,
                   .inputs = {}};
  for (const auto& [file, text] : files_of_module(block.module, sources)) {
    build.inputs.emplace_back(file, without_header(text));
  }
  build.inputs.emplace_back(top + ".v", block.wrapper());
  append(build.compile, {"--prefix", build.prefix, "--top-module", top});
  for (const auto& [file, text] : build.inputs) build.compile.push_back(file);
  build.folder =
      work_folder(work_dir, block.module, tools.version + tools.make, build.compile, build.inputs);
  return build;
}

/// The files of the system's own model, in which stubs stand for the blocks.
SourceFiles files_with_stubs(const std::string& top, SourceFiles sources,
                             const std::vector<ClockedBlock>& blocks) {
  for (auto& [file, text] : sources) {
    for (const ClockedBlock& block : blocks) {
      if (file != block.module + ".v") continue;
      file = block.module + ".sv";
      text = block.stub();
    }
  }
  return files_of_module(top, sources);
}

/// The header that connects stubs and blocks. The folders of blocks are beside the system's: with
/// their headers named from here, compilers have the same flags for all systems, and ccache sees
/// that the harness was compiled before.
std::string bindings(const std::vector<ClockedBlock>& blocks,
                     const std::vector<ModelBuild>& block_builds) {
  std::string text = "#pragma once\n";
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    text += fmt::format("\n#include \"clocked_block.hpp\"\n#include \"../{}/obj/{}.h\"\n\n{}",
                        block_builds[k].folder.filename().string(), block_builds[k].prefix,
                        blocks[k].binding());
  }
  return text;
}

/// How make builds the system in its folder and the blocks in theirs, beside it. The file
/// `complete` marks a folder as whole.
std::string makefile(const ModelBuild& system, const std::vector<ModelBuild>& blocks,
                     const Tools& tools) {
  std::string stamps;
  std::string rules;
  for (const ModelBuild& block : blocks) {
    const std::string folder = "../" + block.folder.filename().string();
    stamps += fmt::format(" {}/{}", folder, build_stamp);
    rules += fmt::format(
        "\n{0}/{1}:\n\tcd {0} && rm -rf obj && {2}\n\t{3} -C {0}/obj -f {4}.mk {5}\n"
        "\ttouch $@\n",
        folder, build_stamp, shell_line(block.compile), tools.make, block.prefix, block.product);
  }
  return fmt::format(
      "# Builds obj/Vsystem: the system and its blocks side by side, then the program.\n\n"
      "obj/Vsystem: obj/compiled{0}\n\t{1} -C obj -f Vsystem.mk Vsystem\n\n"
      "obj/compiled:\n\t{2}\n\t{1} -C obj -f Vsystem.mk Vsystem__ALL.a\n\ttouch $@\n{3}",
      stamps, tools.make, shell_line(system.compile), rules);
}

/// The system's own model with its harness.
ModelBuild system_build(const Bench& bench, const SourceFiles& sources,
                        const std::vector<ClockedBlock>& blocks,
                        const std::vector<ModelBuild>& block_builds, const fs::path& work_dir,
                        const Tools& tools) {
  ModelBuild build{.folder = {},
                   .prefix = "Vsystem",
                   .product = "Vsystem",
                   .compile = tools.verilator,
                   .inputs = {}};
  std::string libraries;
  for (const ModelBuild& block : block_builds) {
    const std::string objects = fmt::format("../../{}/obj", block.folder.filename().string());
    libraries += fmt::format("{}{}/{}", libraries.empty() ? "" : " ", objects, block.product);
  }
  append(build.compile,
         {"--exe", "--prefix", build.prefix, "--top-module", bench.top, "-CFLAGS", "-std=c++20"});
  if (!libraries.empty()) append(build.compile, {"-LDFLAGS", libraries});
  build.inputs = files_with_stubs(bench.top, sources, blocks);
  for (const auto& [file, text] : build.inputs) build.compile.push_back(file);
  append(build.compile, {"clocked_model.cpp", bench.main});
  build.inputs.emplace_back("blocks.hpp", bindings(blocks, block_builds));
  for (const EmbeddedFile& file : harness_files()) build.inputs.emplace_back(file.name, file.text);
  build.inputs.emplace_back("system_model.hpp", bench.model);
  build.inputs.emplace_back("build.mk", makefile(build, block_builds, tools));
  build.folder = work_folder(work_dir, bench.top, tools.version, build.compile, build.inputs);
  return build;
}

bool is_complete(const ModelBuild& build) {
  return fs::exists(build.folder / build_stamp) && fs::exists(build.folder / "obj" / build.product);
}

/// Takes the folder for this run and puts the model's inputs there. A killed compiler or linker
/// leaves half a file newer than its sources, which make would keep.
Result<FolderLock> prepare(const ModelBuild& build, const Waiting& waiting) {
  MIXCMP_TRY(lock, FolderLock::take(build.folder, waiting));
  if (is_complete(build)) return lock;
  for (const char* left : {build_stamp, "obj"}) {
    std::error_code failure;
    fs::remove_all(build.folder / left, failure);
    if (failure) return cannot_write(build.folder / left, failure.value());
  }
  for (const auto& [name, text] : build.inputs) {
    MIXCMP_DO(write_file(build.folder / name, text));
  }
  return lock;
}

/// The error where a program is missing that compiles simulators.
std::optional<Error> missing_compiler() {
  for (const char* program : {"make", "g++"}) {
    const auto version = tool_version({program, "--version"}, program);
    if (!version.ok() && version.error().kind == ErrorKind::missing_tool) return version.error();
  }
  return std::nullopt;
}

}  // namespace

bool is_ccache_usable() {
  for (const char* setting : {"cache_dir", "temporary_dir"}) {
    const auto folder = capture({"ccache", "--get-config", setting});
    if (!folder.ok() || !folder->succeeded()) return false;
    const std::string path = folder->output.substr(0, folder->output.find('\n'));
    if (!fs::path(path).is_absolute() || !make_writable_folder(path).ok()) return false;
  }
  return true;
}

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

Result<Executable> make_program(const ModelBuild& program, const std::vector<ModelBuild>& parts,
                                const BuildOptions& options) {
  const Executable executable{program.folder / "obj" / program.product};
  MIXCMP_TRY(lock, prepare(program, options.waiting));
  if (is_complete(program)) return executable;

  const auto start = std::chrono::steady_clock::now();
  std::vector<FolderLock> locks;
  for (const ModelBuild& part : parts) {
    if (is_complete(part)) continue;
    MIXCMP_TRY(part_lock, prepare(part, options.waiting));
    locks.push_back(std::move(part_lock));
  }
  const auto jobs = std::to_string(std::max(1u, std::thread::hardware_concurrency()));
  const auto run = run_tool({.command = {"make", "-j", jobs, "-f", "build.mk"},
                             .directory = program.folder,
                             .log = program.folder / "build.log",
                             .progress = options.progress});
  if (!run.ok()) return missing_compiler().value_or(run.error());
  MIXCMP_DO(write_file(program.folder / build_stamp, ""));
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return Executable{executable.path, taken.count()};
}

Result<Executable> build_simulator(const System& system, const BuildOptions& options) {
  MIXCMP_TRY(version, tool_version({"verilator", "--version"}, "verilator"));
  MIXCMP_TRY(sources, system_sources(system));
  const Tools tools{version, verilator_call(options.waves),
                    make_call(options.waves, is_ccache_usable())};
  const std::vector<ClockedBlock> blocks = clocked_blocks(system.signature, sources);
  std::vector<ModelBuild> block_builds;
  for (const ClockedBlock& block : blocks) {
    block_builds.push_back(block_build(block, sources, options.work_dir, tools));
  }
  const ModelBuild build = system_build(bench_of(system.signature), sources, blocks, block_builds,
                                        options.work_dir, tools);
  return make_program(build, block_builds, options);
}

}  // namespace mixcmp::verilator_tb

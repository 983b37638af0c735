#include "verilator_tb/waves.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <fstream>
#include <set>

#include "model/base/common/output_file.hpp"

namespace mixcmp::verilator_tb {

namespace {

namespace fs = std::filesystem;

/// Checks that waves can be written to `path`; otherwise a long simulation would end in this error.
Result<Done> check_place(const fs::path& path) {
  std::error_code failed;
  if (!fs::exists(path, failed)) return Done{};
  if (access(path.c_str(), W_OK) != 0) return cannot_write(path, errno);
  if (fs::is_regular_file(path, failed)) return Done{};
  return Error{.file = path.string(),
               .message = "waves cannot be written there",
               .received = "no regular file",
               .accepted = "the name of a file"};
}

/// GTKWave's display flags, in hexadecimal as its save files have them.
constexpr const char* binary = "@28";
constexpr const char* hexadecimal = "@22";
constexpr const char* comment = "@200";

class Writer {
public:
  explicit Writer(std::string scope) : scope_(std::move(scope)) {}

  void group(const std::string& title) { text_ += fmt::format("{}\n-{}\n", comment, title); }

  void wire(const char* port) { text_ += fmt::format("{}\n{}.{}\n", binary, scope_, port); }

  /// Field `index` of a port made of `count` fields of `width` bits.
  void field(const char* port, int index, int count, int width) {
    const int total = count * width;
    const char* const flag = width == 1 ? binary : hexadecimal;
    const std::string name = total == 1 ? fmt::format("{}.{}", scope_, port)
                                        : fmt::format("{}.{}[{}:0]", scope_, port, total - 1);
    if (count == 1) {
      text_ += fmt::format("{}\n{}\n", flag, name);
      return;
    }
    text_ += fmt::format("{}\n#{{{}[{}]}}", flag, port, index);
    for (int bit = width - 1; bit >= 0; --bit) {
      text_ += fmt::format(" ({}){}", total - 1 - (index * width + bit), name);
    }
    text_ += '\n';
  }

  const std::string& text() const { return text_; }

private:
  std::string scope_;
  std::string text_;
};

std::string header(const SaveFile& options) {
  std::string text =
      fmt::format("[dumpfile] \"{}\"\n[timestart] 0\n[size] 1600 900\n", options.waves.string());
  if (!options.marked) return text;
  const auto time = [&](std::uint64_t cycle) { return cycle * options.time_per_cycle; };
  text += fmt::format("*-6.0 {0} {0} {1}", time(options.marked->cycle_accepted),
                      time(options.marked->cycle_left));
  for (char marker = 'C'; marker <= 'Z'; ++marker) text += " -1";
  return text + "\n";
}

/// The big-endian number of 8 bytes at the stream's place.
std::uint64_t read_number(std::ifstream& stream) {
  std::uint64_t number = 0;
  for (int byte = 0; byte < 8; ++byte) {
    number = number << 8 | static_cast<std::uint64_t>(stream.get() & 0xff);
  }
  return number;
}

}  // namespace

bool is_whole_fst(const std::filesystem::path& path) {
  // Types of blocks: header, geometry; the hierarchy comes in three packings.
  constexpr int header = 0, geometry = 3, packed_file = 254;
  std::error_code failed;
  const std::uint64_t size = std::filesystem::file_size(path, failed);
  std::ifstream stream(path, std::ios::binary);
  std::set<int> types;
  std::uint64_t place = 0;
  while (!failed && place < size) {
    stream.seekg(static_cast<std::streamoff>(place));
    const int type = stream.get();
    const std::uint64_t length = read_number(stream);
    if (!stream || length < 8 || length > size - place - 1) return false;
    types.insert(type);
    place += 1 + length;
  }
  const bool hierarchy = types.contains(4) || types.contains(6) || types.contains(7);
  return types.contains(packed_file) ||
         (types.contains(header) && types.contains(geometry) && hierarchy);
}

std::string gtkwave_save_file(const emit::Signature& s, const SaveFile& options) {
  const int lane = options.marked ? static_cast<int>(options.marked->lane) : 0;
  const int group = lane / s.lanes_per_group, groups = emit::group_count(s);
  const std::string counter_owner = s.lanes_per_group == 1
                                        ? fmt::format("lane {}", lane)
                                        : fmt::format("group {} of lanes", group);
  Writer writer(options.scope);
  writer.wire("aclk");
  writer.wire("aresetn");
  writer.group(fmt::format("comparisons of lane {}", lane));
  writer.field("s_axis_tvalid", group, groups, 1);
  writer.field("s_axis_tready", group, groups, 1);
  writer.field("s_axis_tdata", lane, s.lanes, 8 * s.tdata_bytes);
  writer.field("s_axis_tuser", group, groups, s.tag_bits);
  writer.group(
      fmt::format("results of lane {}: tdata = undecided, recomputed, verdict[1:0]", lane));
  writer.field("m_axis_tvalid", group, groups, 1);
  writer.field("m_axis_tready", group, groups, 1);
  writer.field("m_axis_tdata", lane, s.lanes, 8);
  writer.field("m_axis_tuser", group, groups, s.tag_bits);
  if (emit::has_counter_ports(s)) {
    writer.group("counters of " + counter_owner);
    for (const char* port : {"comparisons", "recomputations", "stalls"}) {
      writer.field(port, group, groups, s.counter_bits);
    }
  }
  return header(options) + writer.text();
}

std::string gtkwave_save_file(const emit::SignatureEngine& engine, const SaveFile& options) {
  Writer writer(options.scope);
  for (const emit::SignaturePort& port : engine.ports) {
    if (port.name == "s_axis_tvalid") writer.group("items");
    if (port.name == "m_axis_tvalid") writer.group("reports");
    if (port.name == "comparisons") writer.group("counters");
    writer.field(port.name.c_str(), 0, 1, port.width);
  }
  return header(options) + writer.text();
}

Result<WaveFile> WaveFile::open(const fs::path& path) {
  for (const fs::path& output : {path, save_file_beside(path)}) {
    MIXCMP_DO(check_place(output));
  }
  MIXCMP_TRY(target, follow_links(fs::absolute(path)));
  auto own = ScratchFolder::make_in(target.parent_path(), "waves");
  if (own.ok()) return WaveFile(path, std::move(own).value());
  Error error = own.error();
  error.file = path.string();
  return error;
}

Result<Done> WaveFile::commit() {
  if (!is_whole_fst(unfinished())) {
    return Error{.file = path_.string(),
                 .message = "cannot be written: the simulator left waves that are not whole",
                 .received = "a broken FST file, as of a full disk"};
  }
  MIXCMP_TRY(save_file, OutputFile::open(save_file_beside(path_)));
  save_file.write(save_file_text_);
  MIXCMP_DO(save_file.write_out());
  MIXCMP_DO(put_in_place(unfinished(), path_));
  return save_file.commit();
}

fs::path save_file_beside(fs::path waves) {
  return waves.empty() ? waves : waves.replace_extension(".gtkw");
}

}  // namespace mixcmp::verilator_tb

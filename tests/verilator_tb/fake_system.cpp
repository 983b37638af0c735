#include "tests/verilator_tb/fake_system.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <iterator>

#include "model/base/common/counter_random.hpp"

namespace mixcmp::test {

namespace {

namespace fs = std::filesystem;

FloatFormat binary16() {
  return *FloatFormat::make(11, 5);
}

void replace(std::string& text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  MIXCMP_CHECK(at != std::string::npos);
  text.replace(at, from.size(), to);
}

std::string read(const fs::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Whole or not at all: tests run side by side on the same folder.
void write(const fs::path& path, const std::string& text) {
  const fs::path draft = path.string() + fmt::format(".{}", getpid());
  std::ofstream(draft, std::ios::binary) << text;
  fs::rename(draft, path);
}

std::vector<emit::SignatureReferences> reference_signatures(const FakeSystem& fake) {
  if (fake.route == FakeRoute::none) return {};
  return {{.count = fake.lanes, .module = "fake_reference"}};
}

std::vector<design::ReferenceGroup> references_of(const FakeSystem& fake) {
  if (fake.route == FakeRoute::none) return {};
  return {{.count = fake.lanes}};
}

std::vector<emit::SignaturePort> fake_ports(const FakeSystem& fake) {
  constexpr rtl::Direction in = rtl::Direction::input, out = rtl::Direction::output;
  const int lanes = fake.lanes, tag_bytes = (fake.tag_bits + 7) / 8;
  std::vector<emit::SignaturePort> ports = {{"aclk", in, 1},
                                            {"aresetn", in, 1},
                                            {"s_axis_tvalid", in, lanes},
                                            {"s_axis_tready", out, lanes},
                                            {"s_axis_tdata", in, 32 * lanes},
                                            {"s_axis_tuser", in, fake.tag_bits * lanes},
                                            {"m_axis_tvalid", out, lanes},
                                            {"m_axis_tready", in, lanes},
                                            {"m_axis_tdata", out, 8 * lanes},
                                            {"m_axis_tuser", out, fake.tag_bits * lanes},
                                            {"comparisons", out, 16 * lanes},
                                            {"recomputations", out, 16 * lanes},
                                            {"stalls", out, 16 * lanes}};
  if (fake.operands != scene::OperandStore::refetched) return ports;
  ports.insert(ports.end(), {{"m_refetch_tvalid", out, lanes},
                             {"m_refetch_tready", in, lanes},
                             {"m_refetch_tdata", out, 8 * tag_bytes * lanes},
                             {"s_refetch_tvalid", in, lanes},
                             {"s_refetch_tready", out, lanes},
                             {"s_refetch_tdata", in, 32 * lanes}});
  return ports;
}

emit::Signature fake_signature(const FakeSystem& fake) {
  return {
      .top = "fake_system",
      .generator_version = "fake",
      .spec_hash = "fake",
      .reference_format = binary16(),
      .certified = true,
      .inputs = {"a", "b"},
      .input_formats = {OperandFormat(binary16()), OperandFormat(binary16())},
      .lanes = fake.lanes,
      .references = fake.route == FakeRoute::none ? 0 : fake.lanes,
      .lane_groups = {{.count = fake.lanes, .module = "fake_channel", .format = binary16().name()}},
      .reference_groups = reference_signatures(fake),
      .tdata_bytes = 4,
      .tag_bits = fake.tag_bits,
      .counter_bits = 16,
      .slots = 8,
      .order = fake.route == FakeRoute::in_order ? scene::ResultOrder::in_order
                                                 : scene::ResultOrder::tagged,
      .operands = fake.operands,
      .ports = fake_ports(fake),
      .files = {"fake_system.v", "fake_channel.v", "fake_reference.v", "fake_fifo.v"}};
}

}  // namespace

fs::path fake_work_dir() {
  return fs::path(MIXCMP_FAKE_WORK_DIR);
}

fs::path write_fake_system(const FakeSystem& fake) {
  const fs::path folder = fake_work_dir() / fake.name;
  fs::create_directories(folder);
  const emit::Signature signature = fake_signature(fake);
  for (const std::string& file : signature.files) {
    std::string text = read(fs::path(MIXCMP_FAKE_SOURCE_DIR) / file);
    if (file == "fake_system.v") {
      replace(text, "LANES = 2", fmt::format("LANES = {}", fake.lanes));
      replace(text, "TAG_BITS = 12", fmt::format("TAG_BITS = {}", fake.tag_bits));
      replace(text, "ROUTE = 0", fmt::format("ROUTE = {}", static_cast<int>(fake.route)));
      if (fake.operands == scene::OperandStore::refetched) text = "`define REFETCHED\n" + text;
    }
    write(folder / file, text);
  }
  write(folder / "fake_system.json", emit::to_json(signature));
  return folder;
}

design::Design fake_design(const FakeSystem& fake) {
  const auto input = [](int k) {
    return TypedNode{.operation = Operation::input,
                     .operand_format = binary16(),
                     .format = binary16(),
                     .input = k};
  };
  const TypedGraph graph{.nodes = {input(0), input(1)},
                         .input_count = 2,
                         .input_format = binary16(),
                         .arithmetic = {binary16()},
                         .parts = {{0, 1}}};
  const error::UlpDistanceCriterion criterion{.guard_ulp = 4, .nonnegative = true};
  return {.name = "fake",
          .inputs = {"a", "b"},
          .lanes = {{.lane = error::one_part_lane(graph, criterion), .count = fake.lanes}},
          .reference = graph,
          .references = references_of(fake)};
}

data::Comparisons fake_comparisons(std::size_t count) {
  data::Table table{.format = binary16(), .columns = {"a", "b"}};
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint64_t random = counter_random(7, k);
    const std::uint64_t a = 0x0800 + random % 0x7000;
    const std::uint64_t near = a + (random >> 32) % 9 - 4;
    const std::uint64_t far = 0x0800 + (random >> 32) % 0x7000;
    table.values.push_back(a);
    table.values.push_back((random >> 20 & 1) != 0 ? near : far);
  }
  return *data::Comparisons::rows(table, {"a", "b"});
}

}  // namespace mixcmp::test

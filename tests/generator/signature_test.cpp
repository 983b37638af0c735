#include "generator/hardware/emit/signature.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test::signature_test {
namespace {

emit::Signature some_signature() {
  return {.top = "top",
          .generator_version = "1.2.3",
          .spec_hash = "abc",
          .reference_format = *FloatFormat::parse("s53e11"),
          .reference_sums = Sums::fused,
          .certified = true,
          .parts = {{"near", "b"}, {"a", "c"}},
          .combination = Combination::any,
          .lets = {{"near", "a^2"}},
          .inputs = {"a", "b", "c"},
          .input_formats = {*OperandFormat::parse("s53e11"), *OperandFormat::parse("uint10"),
                            *OperandFormat::parse("q3.4")},
          .lanes = 87,
          .lanes_per_group = 29,
          .references = 3,
          .lane_groups = {{.count = 80,
                           .module = "channel",
                           .format = "s17e8",
                           .latency_cycles = 20,
                           .certified = true,
                           .decision = "certified: always",
                           .inputs = LaneInputs::rounded},
                          {.count = 7,
                           .module = "narrow_channel",
                           .format = "q13",
                           .latency_cycles = 15,
                           .inputs = LaneInputs::of_digits(20),
                           .multipliers = scene::Multipliers::logic}},
          .reference_groups = {{.count = 3, .module = "reference", .latency_cycles = 40}},
          .tdata_bytes = 24,
          .tag_bits = 31,
          .counter_bits = 48,
          .counter_map = {{"comparisons", 5, 0}, {"answers", 3, 40}},
          .slots = 64,
          .input_registers = 2,
          .request_beats = 4,
          .order = scene::ResultOrder::in_order,
          .operands = scene::OperandStore::refetched,
          .target_mhz = 312.5,
          .files = {"top.v", "channel.v"}};
}

Result<emit::Signature> read_text(const std::string& text) {
  const test::ScratchDirectory scratch;
  const auto path = scratch.path() / "top.json";
  std::ofstream(path) << text;
  return emit::read_signature(path);
}

std::string without(const std::string& text, const std::string& part, const std::string& instead) {
  const auto at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return std::string(text).replace(at, part.size(), instead);
}

TEST(Signature, ReadsBackAsWritten) {
  const std::string text = to_json(some_signature());
  const auto read = read_text(text);
  ASSERT_TRUE(read.ok()) << read.error().to_string();
  EXPECT_EQ(to_json(*read), text);
  EXPECT_EQ(read->lanes, 87);
  ASSERT_EQ(read->parts.size(), 2u);
  EXPECT_EQ(read->parts[1].g, "c");
  EXPECT_EQ(read->combination, Combination::any);
  EXPECT_EQ(read->reference_format, *FloatFormat::parse("s53e11"));
  EXPECT_EQ(read->reference_sums, Sums::fused);
  EXPECT_EQ(read->order, scene::ResultOrder::in_order);
  EXPECT_EQ(read->operands, scene::OperandStore::refetched);
  EXPECT_EQ(read->files, some_signature().files);
  EXPECT_EQ(read->input_formats, some_signature().input_formats);
}

TEST(Signature, NamesTheFieldThatDoesNotFit) {
  const std::string text = to_json(some_signature());
  const auto lanes = read_text(without(text, "\"lanes\": 87", "\"lanes\": 0"));
  ASSERT_FALSE(lanes.ok());
  EXPECT_EQ(lanes.error().field, "lanes");
  EXPECT_EQ(lanes.error().received, "0");
  EXPECT_EQ(lanes.error().accepted, "an integer in 1..4096");

  const auto group = read_text(without(text, "\"lanes_per_group\": 29", "\"lanes_per_group\": 2"));
  ASSERT_FALSE(group.ok());
  EXPECT_EQ(group.error().field, "lanes_per_group");
  EXPECT_EQ(group.error().accepted, "a divisor of 87");

  const auto order = read_text(without(text, "\"in_order\"", "\"sorted\""));
  ASSERT_FALSE(order.ok());
  EXPECT_EQ(order.error().field, "order");
  EXPECT_EQ(order.error().accepted, "\"tagged\", \"in_order\"");

  const auto format = read_text(without(text, "\"s17e8\"", "\"s17\""));
  ASSERT_FALSE(format.ok());
  EXPECT_EQ(format.error().field, "lane_groups[0].format");

  const auto part = read_text(without(text, "\"near\",\n      \"g\"", "\"near\",\n      \"h\""));
  ASSERT_FALSE(part.ok());
  EXPECT_EQ(part.error().field, "parts[0].g");

  for (const char* formats :
       {"\"uint10\"", "\"uint10\",\n    \"q3\""}) {  // one too few, one unknown
    const auto few = read_text(without(text, "\"uint10\",\n    \"q3.4\"", formats));
    ASSERT_FALSE(few.ok());
    EXPECT_EQ(few.error().field, "input_formats");
  }

  const auto missing = read_text(without(text, "\"tag_bits\": 31,", ""));
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().field, "tag_bits");
  EXPECT_EQ(missing.error().message, "missing");
}

TEST(Signature, RefusesWhatIsNotAnObject) {
  EXPECT_EQ(read_text("top = 1").error().message, "not JSON");
  EXPECT_FALSE(read_text("[]").ok());
  EXPECT_FALSE(emit::read_signature("/nonexistent/top.json").ok());
}

}  // namespace
}  // namespace mixcmp::test::signature_test

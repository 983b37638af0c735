#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "model/cost/measured/measurement.hpp"
#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test::table_test {
namespace {

measured::Lane lane_in(const std::string& format) {
  return {.format = LaneFormat::parse(format).value(),
          .inputs = LaneInputs::exact,
          .bound = Bound{.kind = BoundKind::running, .digits = 4},
          .multipliers = scene::Multipliers::logic};
}

/// A reference with multipliers in logic.
measured::Reference reference() {
  return {.format = LaneFormat::parse("s53e8").value(), .multipliers = scene::Multipliers::logic};
}

measured::Measurement lane(const std::string& format, int luts) {
  return {
      .key = lane_in(format),
      .latency_cycles = 17,
      .area =
          {.luts = luts, .registers = 2, .dsps = 3, .memories = 4, .carries = 5, .shift_luts = 6},
      .clock = std::nullopt,
      .timing_seeds = 0,
      .hash = "0123456789abcdef0123456789abcdef",
      .tools = "Yosys 0.23 (git sha1 7ce5011c24b, \"g++\")"};
}

measured::Measurement crossbar(int ports) {
  return {.key = measured::Crossbar{ports},
          .latency_cycles = 3,
          .area = {.luts = 100 * ports},
          .clock = measured::Clock{.mhz = 101.25,
                                   .low_mhz = 99.5,
                                   .high_mhz = 103.75,
                                   .seeds = 3,
                                   .source = measured::ClockSource::routed},
          .timing_seeds = 3,
          .hash = "f",
          .tools = "Yosys 0.23"};
}

measured::Characterisation example() {
  return {.device = "ice40-hx8k",
          .scene = "spheres",
          .command = "mixcmp characterise scene.toml --set 'x=1: 2'",
          .spec = {{"f", "a * b"}, {"tools", "Yosys 0.23"}},
          .rows = {lane("s12e8", 700), lane("s8e8", 400), crossbar(2), crossbar(11)}};
}

class Table : public testing::Test {
protected:
  Result<measured::Characterisation> read(const std::string& text) {
    std::ofstream(path_, std::ios::binary) << text;
    return measured::read_characterisation(path_);
  }

  /// The example with `old_text` replaced, which must be refused at this place.
  void expect_refused(const std::string& old_text, const std::string& new_text, int line,
                      int column, const std::string& message) {
    std::string text = to_csv(example());
    const std::size_t place = text.find(old_text);
    ASSERT_NE(place, std::string::npos) << old_text;
    text.replace(place, old_text.size(), new_text);
    const auto table = read(text);
    ASSERT_FALSE(table.ok()) << text;
    EXPECT_EQ(table.error().file, path_.string());
    EXPECT_EQ(table.error().line, line) << table.error().to_string();
    EXPECT_EQ(table.error().column, column) << table.error().to_string();
    EXPECT_NE(table.error().message.find(message), std::string::npos) << table.error().to_string();
  }

  ScratchDirectory directory_;
  const std::filesystem::path path_ = directory_.path() / "table.csv";
};

TEST_F(Table, ComesBackAsItWasWritten) {
  const measured::Characterisation written = example();
  const auto read_back = read(to_csv(written));
  ASSERT_TRUE(read_back.ok()) << read_back.error().to_string();
  EXPECT_EQ(read_back->device, written.device);
  EXPECT_EQ(read_back->scene, written.scene);
  EXPECT_EQ(read_back->command, written.command);
  EXPECT_EQ(read_back->spec, written.spec);
  ASSERT_EQ(read_back->rows.size(), 4u);
  EXPECT_EQ(to_csv(*read_back), to_csv(written));
  EXPECT_EQ(read_back->rows[0].area, written.rows[0].area);
  EXPECT_EQ(read_back->rows[0].tools, written.rows[0].tools);
  EXPECT_FALSE(read_back->rows[0].clock);
  ASSERT_TRUE(read_back->rows[3].clock);
  EXPECT_EQ(read_back->rows[3].clock->low_mhz, 99.5);
  EXPECT_EQ(read_back->rows[3].clock->source, measured::ClockSource::routed);
  EXPECT_EQ(read_back->rows[3].timing_seeds, 3);
}

TEST_F(Table, TheStageOfAreasIsAColumnWhereARowIsImported) {
  measured::Characterisation written = example();
  std::sort(written.rows.begin(), written.rows.end(),
            [](const auto& a, const auto& b) { return a.key < b.key; });
  EXPECT_EQ(to_csv(written).find("area_stage"), std::string::npos);
  written.rows[1].stage = measured::AreaStage::routed;
  const auto read_back = read(to_csv(written));
  ASSERT_TRUE(read_back.ok()) << read_back.error().to_string();
  EXPECT_EQ(to_csv(*read_back), to_csv(written));
  EXPECT_EQ(read_back->rows[1].stage, measured::AreaStage::routed);
  EXPECT_FALSE(read_back->rows[0].is_imported());
  std::string text = to_csv(written);
  text.replace(text.find("placed_and_routed"), 17, "guessed");
  EXPECT_FALSE(read(text).ok());
}

TEST_F(Table, LinesOfOtherSystemsAndUnsortedRowsAreRead) {
  measured::Characterisation shuffled = example();
  std::swap(shuffled.rows[0], shuffled.rows[3]);
  std::string text;
  for (const char c : to_csv(shuffled)) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const auto table = read(text);
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  EXPECT_EQ(to_csv(*table), to_csv(example()));
}

TEST_F(Table, FindsARowByAllOfItsKey) {
  const measured::Characterisation table = example();
  measured::Lane key = lane_in("s8e8");
  ASSERT_NE(table.find(key), nullptr);
  EXPECT_EQ(table.find(key)->area.luts, 400);
  EXPECT_EQ(table.find(crossbar(11).key)->area.luts, 1100);
  EXPECT_EQ(table.find(crossbar(3).key), nullptr);
  key.inputs = LaneInputs::rounded;
  EXPECT_EQ(table.find(key), nullptr);
  EXPECT_EQ(measured::Characterisation().find(key), nullptr);
}

TEST_F(Table, ErrorsTellLineAndColumn) {
  // Five comments and the header stand before the first row.
  expect_refused("lane,,s12e8", "line,,s12e8", 7, 1, "not a choice");
  expect_refused("17,700", "17,many", 7, 42, "not a number");
  expect_refused("17,700", "17,-700", 7, 42, "not a number");
  expect_refused("17,700", "17,700.5", 7, 42, "not a number");
  expect_refused("101.25,", "nan,", 9, 35, "not a number");
  expect_refused("101.25,", "0,", 9, 35, "no clock");
  expect_refused("lane,,s12e8", "lane,,float", 7, 7, "not a format");
  expect_refused("exact,running_4", "some,running_4", 7, 13, "not a choice");
  expect_refused("exact,running_4", "12,running_4", 7, 13, "not a choice");
  expect_refused("exact,running_4", "200,running_4", 7, 13, "digits out of range");
  expect_refused("running_4,logic", "running_4,wood", 7, 29, "not a choice");
  expect_refused("routed,3", "guessed,3", 9, 57, "not a choice");
  expect_refused("f,Yosys 0.23\n", "f\n", 9, 66, "ends here");
  expect_refused("f,Yosys 0.23\n", "f,Yosys 0.23,more\n", 9, 68, "goes on");
  expect_refused("g++\"\")\"\n", "g++\"\")\n", 7, 96, "text behind the quotes");
  expect_refused("kind,name", "name,kind", 6, 1, "not the columns");
}

TEST_F(Table, ReferencesAloneHaveAnInitiationInterval) {
  measured::Characterisation table = example();
  table.rows = {lane("s12e8", 700)};
  measured::Reference slow = reference();
  slow.initiation_interval = 16;
  table.rows.front().key = slow;
  const std::string text = to_csv(table);
  EXPECT_EQ(read(text).value().rows.front().key, measured::ComponentKey(slow));
  const auto message = [&](const std::string& instead) {
    std::string other = text;
    other.replace(other.find("logic,16"), 8, instead);
    return read(other).error().to_string();
  };
  for (const char* interval : {"logic,0", "logic,65"}) {
    const std::string refused = message(interval);
    EXPECT_NE(refused.find("7:26: not an initiation interval"), std::string::npos) << refused;
    EXPECT_NE(refused.find("accepted 1..64"), std::string::npos) << refused;
  }
  expect_refused("logic,0,", "logic,1,", 7, 35, "a lane has no such property");
}

TEST_F(Table, AReferencesNameSaysThatItsSumsAreFused) {
  measured::Characterisation table = example();
  table.rows = {lane("s12e8", 700)};
  measured::Reference fused = reference();
  fused.sums = Sums::fused;
  table.rows.front().key = fused;
  table.rows.push_back(table.rows.front());
  table.rows.back().key = reference();
  const std::string text = to_csv(table);
  EXPECT_NE(text.find("\nreference,fused,s53e8,"), std::string::npos) << text;
  EXPECT_NE(text.find("\nreference,,s53e8,"), std::string::npos) << text;
  const auto read_table = read(text);
  ASSERT_TRUE(read_table.ok()) << read_table.error().to_string();
  EXPECT_EQ(read_table->rows[0].key, measured::ComponentKey(reference()));
  EXPECT_EQ(read_table->rows[1].key, measured::ComponentKey(fused));
  const auto refused = [&](const std::string& cells, const std::string& others) {
    std::string other = text;
    other.replace(other.find(cells), cells.size(), others);
    return read(other).error().message;
  };
  EXPECT_EQ(refused("reference,fused", "reference,woven"), "not a kind of reference");
  EXPECT_EQ(refused("reference,fused,s53e8", "reference,fused,q9"),
            "an exact reference rounds no sum");
  EXPECT_EQ(refused("reference,,s53e8", "reference,,block9"), "not a format of references");
}

TEST_F(Table, AReferencesNameSaysWhatItsRegistersArePlacedForIfNotForTheTablesTarget) {
  measured::Characterisation table = example();
  table.rows = {lane("s12e8", 700)};
  measured::Reference placed = reference();
  placed.target_mhz = 600;
  table.rows.front().key = placed;
  table.rows.push_back(table.rows.front());
  placed.sums = Sums::fused;
  table.rows.back().key = placed;
  const std::string text = to_csv(table);
  EXPECT_NE(text.find("\nreference,at_600_mhz,s53e8,"), std::string::npos) << text;
  EXPECT_NE(text.find("\nreference,fused at_600_mhz,s53e8,"), std::string::npos) << text;
  EXPECT_EQ(read(text).value().rows[0].key, table.rows[0].key);
  EXPECT_EQ(read(text).value().rows[1].key, table.rows[1].key);
  for (const char* wrong :
       {"at_0_mhz", "at_2001_mhz", "at__mhz", "at_mhz", "at_6x_mhz", "at_600", "600"}) {
    std::string other = text;
    other.replace(other.find("at_600_mhz"), 10, wrong);
    const std::string refused = read(other).error().to_string();
    EXPECT_NE(refused.find("not a kind of reference"), std::string::npos) << wrong << refused;
  }
}

/// The rows of every kind, in the order of a table, which stored tables have.
TEST_F(Table, EveryComponentHasItsColumnsAndItsPlace) {
  const measured::Lane lane = lane_in("s12e8");
  measured::Reference exact = reference();
  exact.format = LaneFormat::parse("q9").value();
  const std::vector<std::pair<measured::ComponentKey, std::string>> rows = {
      {measured::Unit{"fp_add A=1"}, "unit,fp_add A=1,,,,,0,0"},
      {lane, "lane,,s12e8,exact,running_4,logic,0,0"},
      {lane_in("s8e8"), "lane,,s8e8,exact,running_4,logic,0,0"},
      {exact, "reference,,q9,,,logic,1,0"},
      {reference(), "reference,,s53e8,,,logic,1,0"},
      {measured::Fifo{64}, "fifo,,,,,,0,64"},
      {measured::Crossbar{2}, "crossbar,,,,,,0,2"},
      {measured::Crossbar{11}, "crossbar,,,,,,0,11"},
      {measured::ReferencePort{reference()}, "reference_port,,s53e8,,,logic,1,0"},
      {measured::SecondLane{lane, 64}, "second_lane,,s12e8,exact,running_4,logic,0,64"},
      {measured::Segment{lane, 8}, "segment,,s12e8,exact,running_4,logic,0,8"},
      {measured::Conversion{lane}, "conversion,,s12e8,exact,running_4,logic,0,0"},
      {measured::Engine{lane, 4}, "engine,,s12e8,exact,running_4,logic,0,4"},
      {measured::OperandMemory{4}, "operand_memory,,,,,,0,4"}};
  measured::Characterisation table = example();
  table.rows.clear();
  for (const auto& [key, cells] : rows) table.rows.push_back({.key = key, .hash = {}, .tools = {}});
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
  const std::string text = to_csv(table);
  for (const auto& [key, cells] : rows) {
    EXPECT_NE(text.find("\n" + cells + ",0,"), std::string::npos) << cells << "\n" << text;
  }
  const auto read_back = read(text);
  ASSERT_TRUE(read_back.ok()) << read_back.error().to_string();
  for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_EQ(read_back->rows[k].key, rows[k].first);
}

TEST_F(Table, ACellThatDoesNotApplyIsEmpty) {
  // The row of a crossbar: kind, name, format, inputs, bound, multipliers, interval, ports.
  const std::string row = "crossbar,,,,,,0,2";
  expect_refused(row, "crossbar,big,,,,,0,2", 9, 10, "a crossbar has no such property");
  expect_refused(row, "crossbar,,s8e8,,,,0,2", 9, 11, "a crossbar has no such property");
  expect_refused(row, "crossbar,,,exact,,,0,2", 9, 12, "a crossbar has no such property");
  expect_refused(row, "crossbar,,,,,logic,0,2", 9, 14, "a crossbar has no such property");
  expect_refused("logic,0,0", "logic,0,1", 7, 37, "a lane has no such property");
}

TEST_F(Table, SizesOfAComponentDifferOnlyInTheirCount) {
  const measured::Lane lane = lane_in("s12e8");
  measured::Characterisation table = example();
  const auto add = [&](const measured::ComponentKey& key) {
    table.rows.push_back({.key = key, .hash = {}, .tools = {}});
  };
  add(measured::Fifo{2});
  add(measured::Engine{lane, 4});
  add(measured::Engine{lane_in("s8e8"), 5});
  const auto crossbars = sizes_of(table, measured::Crossbar{});
  EXPECT_EQ(crossbars.size(), 2u) << "a fifo of two slots is no crossbar of two lanes";
  EXPECT_EQ(crossbars.at(2)->area.luts, 200);
  EXPECT_EQ(crossbars.at(11)->area.luts, 1100);
  EXPECT_EQ(sizes_of(table, measured::Engine{lane}).size(), 1u);
  add(without_multipliers(measured::Engine{lane, 6}));
  EXPECT_EQ(sizes_of(table, measured::Engine{lane}).count(6), 1u) << "no product, no multipliers";
}

TEST_F(Table, OneRowForOneComponent) {
  measured::Characterisation doubled = example();
  doubled.rows.push_back(crossbar(2));
  const auto table = read(to_csv(doubled));
  ASSERT_FALSE(table.ok());
  EXPECT_NE(table.error().to_string().find("crossbar"), std::string::npos);
}

TEST_F(Table, IsNotAnyFile) {
  EXPECT_FALSE(read("").ok());
  EXPECT_FALSE(read("# device: x").ok());
  EXPECT_FALSE(read(to_csv(example()).substr(0, to_csv(example()).size() - 30)).ok());
  EXPECT_FALSE(measured::read_characterisation(directory_.path() / "nothing.csv").ok());
}

}  // namespace
}  // namespace mixcmp::test::table_test

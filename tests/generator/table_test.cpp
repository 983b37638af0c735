#include "generator/present/table/table.hpp"

#include <gtest/gtest.h>

/// The writers of tables: each from the same columns and rows.
namespace mixcmp::test::table_test {
namespace {

using table::Fields;
using table::Json;
using table::Table;

struct Plan {
  int lanes;
  double per_s;
  std::optional<double> clock_mhz;
  std::string kinds;
};

const Fields<Plan>& plan_fields() {
  static const Fields<Plan> fields = {
      {{"lanes", "p_L", 5, 1}, &Plan::lanes},
      {{"per_s", "G/s", 7, 1, "{:.2f}", 1e9, "{:.3g}"}, &Plan::per_s},
      {{"clock_mhz", "MHz", 6, 1, "{:.1f}"},
       [](const Plan& plan) { return table::cell(plan.clock_mhz); }},
      {{"kinds", "lanes", 0, 2, "{}", 1, "\"{}\""}, &Plan::kinds}};
  return fields;
}

/// Two plans, the second without a clock, and one that is infeasible.
Table plans() {
  Table table = table_of(plan_fields(), {{12, 2.4e9, 200.25, "12 x s8e8"}, {7, 1e9, {}, "7 x q8"}});
  table.rows.push_back(row_of(plan_fields(), {.lanes = 9}, "too large"));
  table.remark_name = "infeasible";
  return table;
}

TEST(Table, TextAlignsTitlesWithCells) {
  EXPECT_EQ(to_text(plans()),
            "   p_L     G/s    MHz  lanes\n"
            "    12    2.40  200.2  12 x s8e8\n"
            "     7    1.00      -  7 x q8\n"
            "     9  too large\n");
}

TEST(Table, CsvHasTheValuesInTheirOwnUnits) {
  EXPECT_EQ(to_csv(plans()),
            "lanes,per_s,clock_mhz,kinds\n"
            "12,2.4e+09,200.25,\"12 x s8e8\"\n"
            "7,1e+09,,\"7 x q8\"\n"
            "9,0,,\"too large\"\n");
}

TEST(Table, JsonHasAnObjectForEachRow) {
  EXPECT_EQ(to_json(plans()).dump(),
            R"([{"lanes":12,"per_s":2400000000.0,"clock_mhz":200.25,"kinds":"12 x s8e8"},)"
            R"({"lanes":7,"per_s":1000000000.0,"clock_mhz":null,"kinds":"7 x q8"},)"
            R"({"lanes":9,"infeasible":"too large"}])");
}

TEST(Table, MarkdownHasTheCellsThatPeopleRead) {
  EXPECT_EQ(to_markdown(plans()),
            "| p_L | G/s | MHz | lanes |\n|---|---|---|---|\n"
            "| 12 | 2.40 | 200.2 | 12 x s8e8 |\n"
            "| 7 | 1.00 | - | 7 x q8 |\n"
            "| 9 | - | - | too large |\n");
}

TEST(Table, TextHasTheNamesOfGroupsAboveTheirColumns) {
  const Table rates = {.columns = {{"L", "L", 4, 0},
                                   {"", "rate", 5, 2, "{:.0e}", 1, "{}", "relative"},
                                   {"", "wrong", 6, 1, "{}", 1, "{}", "relative"},
                                   {"", "wrong", 7, 2, "{}", 1, "{}", "alone"}},
                       .rows = {{{8, 0.25, 3, 40}}, {{9, "", Json(), 7}}}};
  EXPECT_EQ(to_text(rates),
            "   L      relative    alone\n"
            "       rate  wrong    wrong\n"
            "   8  2e-01      3       40\n"
            "   9             -        7\n");
}

TEST(Table, PickedFieldsComeInTheOrderAskedFor) {
  const Fields<Plan> picked = pick(plan_fields(), {"kinds", "lanes"});
  EXPECT_EQ(object_of(picked, {.lanes = 3, .kinds = "3 x q8"}).dump(),
            R"({"kinds":"3 x q8","lanes":3})");
}

struct Stage {
  int rank = 0;
  std::optional<Plan> plan = {};
  std::vector<Plan> others = {};
};

const Fields<Stage>& stage_fields() {
  static const Fields<Plan> plan = {
      {{"lanes", "lanes"}, &Plan::lanes, "{lanes} in {kinds}"},
      {{"per_s"}, &Plan::per_s},
      {{"giga", "G/s", 0, 2, "{:.1f}"}, [](const Plan& each) { return each.per_s / 1e9; }},
      {{"kinds", "kinds"}, &Plan::kinds, [](const Plan& each) {
         return each.lanes > 9 ? "many" : "";
       }}};
  static const Fields<Stage> fields = {
      {{"rank", "rank"}, &Stage::rank},
      table::record<Stage>({.name = "plan", .may_be_absent = true}, &Stage::plan, plan),
      table::record<Stage>({"others"}, &Stage::others, plan),
      table::line<Stage>("so", "rank {rank}")};
  return fields;
}

const Stage stage{3, Plan{12, 2.4e9, {}, "s8e8"}, {{7, 1e9, {}, "q8"}}};

TEST(Fields, GiveLinesWithTextsInOneColumn) {
  EXPECT_EQ(to_text(lines_of(stage_fields(), stage), 10),
            "  rank    3\n"
            "  lanes   12 in s8e8\n"
            "  G/s     2.4\n"
            "  kinds   many\n"
            "  lanes   7 in q8\n"
            "  G/s     1.0\n"
            "  so      rank 3\n");
  EXPECT_EQ(to_text(lines_of(stage_fields(), Stage{}), 10), "  rank    0\n  so      rank 0\n");
  EXPECT_EQ(table::to_text({{"only a name", "", 4}}, 10), "    only a name\n");
}

TEST(Fields, ReadBackTheObjectThatTheyGive) {
  const Json object = object_of(stage_fields(), stage);
  EXPECT_EQ(object.dump(),
            R"({"rank":3,"plan":{"lanes":12,"per_s":2400000000.0,"giga":2.4,"kinds":"s8e8"},)"
            R"("others":[{"lanes":7,"per_s":1000000000.0,"giga":1.0,"kinds":"q8"}]})");
  Stage read;
  read_object(stage_fields(), object, read);
  EXPECT_EQ(object_of(stage_fields(), read), object);
}

TEST(Fields, ReadOnlyWhatIsThere) {
  Stage read;
  read_object(stage_fields(), Json::parse(R"({"rank":2,"others":[]})"), read);
  EXPECT_EQ(read.rank, 2);
  EXPECT_FALSE(read.plan);
  EXPECT_EQ(object_of(stage_fields(), read).dump(), R"({"rank":2,"others":[]})");
  EXPECT_THROW(read_object(stage_fields(), Json::parse(R"({"rank":2})"), read), Json::exception);
  EXPECT_THROW(read_object(stage_fields(), Json::parse(R"({"rank":"2","others":[]})"), read),
               Json::exception);
}

}  // namespace
}  // namespace mixcmp::test::table_test

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

}  // namespace
}  // namespace mixcmp::test::table_test

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "generator/present/page/axis.hpp"
#include "generator/present/page/chart.hpp"
#include "generator/present/page/html_page.hpp"
#include "generator/present/page/pipeline_columns.hpp"
#include "generator/present/page/waveform.hpp"
#include "generator/present/table/table.hpp"
#include "tests/support/well_formed.hpp"

/// Elements, axes, charts and layouts of pages.
namespace mixcmp::test::page_test {
namespace {

using page::Axis;
using page::Element;
using page::Pipeline;
using page::Scaling;

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) {
    ++found;
  }
  return found;
}

TEST(Page, TextsAndAttributesAreEscaped) {
  Element element("p", {{"class", "a\"b"}});
  element.add_text("1 < 2 & \"3\" > 2");
  EXPECT_EQ(element.to_text(), "<p class=\"a&quot;b\">1 &lt; 2 &amp; &quot;3&quot; &gt; 2</p>");
  EXPECT_EQ(fault_of_markup(element.to_text()), "");
}

TEST(Page, OnlyElementsThatHtmlEndsItselfHaveNoEndTag) {
  EXPECT_EQ(Element("br").to_text(), "<br/>");
  EXPECT_EQ(Element("div").to_text(), "<div></div>");
  EXPECT_EQ(Element("path").add(page::tip("t")).to_text(), "<path><title>t</title></path>");
}

TEST(Page, CoordinatesAreShort) {
  EXPECT_EQ(page::coordinate(1.0), "1");
  EXPECT_EQ(page::coordinate(1.256), "1.26");
  EXPECT_EQ(page::coordinate(-0.001), "0");
  EXPECT_EQ(page::coordinate(100), "100");
}

TEST(Page, TheCheckOfMarkupFindsFaults) {
  EXPECT_NE(fault_of_markup("<p><b>x</p></b>"), "");
  EXPECT_NE(fault_of_markup("<p>"), "");
  EXPECT_NE(fault_of_markup("<p class=x></p>"), "");
  EXPECT_NE(fault_of_markup("<p>a & b</p>"), "");
  EXPECT_EQ(fault_of_markup("<p class=\"x\">a &amp; b<br/></p>"), "");
}

TEST(Page, AWholePageIsWellFormed) {
  const page::Page whole{"a < b",
                         "why & how",
                         {{"one", "One", {page::code("x > y"), page::definitions({{"a", "b"}})}}},
                         "end"};
  const std::string html = to_html(whole);
  EXPECT_EQ(fault_of_markup(html), "");
  EXPECT_NE(html.find("<a href=\"#one\">One</a>"), std::string::npos);
  EXPECT_EQ(html, to_html(whole));
}

TEST(Page, ATableAlignsColumnsOfNumbers) {
  table::Table kinds = table::text_table({"L", "kind"});
  kinds.rows = {{{8, "s8e8"}}, {{12, table::Json()}}};
  const std::string table = page::draw(kinds).to_text();
  EXPECT_EQ(count(table, "<td class=\"number\">"), 2);
  EXPECT_NE(table.find("<td>s8e8</td>"), std::string::npos);
  const auto is_number = [](const char* cell) {
    table::Table one = table::text_table({"column"});
    one.rows = {{{table::Json(cell)}}};
    return page::draw(one).to_text().find("\"number\"") != std::string::npos;
  };
  for (const char* cell : {"8", "-3.5", "1.25e-3", "3-4.5", "0.5-1", "250 MHz", "-", ""}) {
    EXPECT_TRUE(is_number(cell)) << cell;
  }
  for (const char* cell : {"1A8O.pdb", "3x", "8-bit", "s8e8", "2 of those that are left"}) {
    EXPECT_FALSE(is_number(cell)) << cell;
  }
}

TEST(PageAxis, ALinearOneCoversItsValuesAndBeginsAtZero) {
  const Axis axis({"x", Scaling::linear}, {3, 47}, 0, 100);
  EXPECT_EQ(axis.ticks().front().value, 0);
  EXPECT_GE(axis.ticks().back().value, 47);
  EXPECT_EQ(axis.position(0), 0);
  EXPECT_LE(axis.position(47), 100);
  EXPECT_LT(axis.position(3), axis.position(47));
}

TEST(PageAxis, AnAxisOfWholeNumbersHasNoTicksBetweenThem) {
  const Axis axis({"L", Scaling::linear, false, 1}, {7, 12}, 0, 100);
  ASSERT_EQ(axis.ticks().size(), 6u);
  EXPECT_EQ(axis.ticks()[1].label, "8");
}

TEST(PageAxis, ALogarithmicOneHasALineForZeroBelowAllOthers) {
  const Axis axis({"y", Scaling::logarithmic}, {0, 1e-6, 0.5}, 100, 0);
  EXPECT_EQ(axis.ticks().front().label, "none");
  EXPECT_EQ(axis.position(0), 100);
  EXPECT_LT(axis.position(1e-6), axis.position(0));
  EXPECT_LT(axis.position(0.5), axis.position(1e-6));
  EXPECT_GE(axis.position(0.5), 0);
  // A decade is as long everywhere.
  EXPECT_NEAR(axis.position(1e-5) - axis.position(1e-4), axis.position(1e-3) - axis.position(1e-2),
              1e-9);
}

TEST(PageAxis, AShortLogarithmicOneHasTicksAtOneTwoAndFive) {
  const Axis axis({"x", Scaling::logarithmic}, {700, 4100}, 0, 100);
  std::vector<std::string> labels;
  for (const page::Tick& tick : axis.ticks()) labels.push_back(tick.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"500", "1000", "2000", "5000"}));
  EXPECT_EQ(axis.position(500), 0);
  EXPECT_EQ(axis.position(5000), 100);
}

TEST(PageAxis, NoValuesAndEqualValuesStillMakeAnAxis) {
  for (const Scaling scaling : {Scaling::linear, Scaling::logarithmic}) {
    for (const std::vector<double>& values : {std::vector<double>{}, std::vector<double>{1, 1}}) {
      const Axis axis({"x", scaling}, values, 0, 100);
      EXPECT_GE(axis.ticks().size(), 2u);
      EXPECT_GE(axis.position(1), 0);
      EXPECT_LE(axis.position(1), 100);
    }
  }
}

TEST(PageChart, EveryPointIsDrawnWithItsTip) {
  page::Chart chart{.title = "t", .x = {"x"}, .y = {"y"}, .series = {}};
  chart.series.push_back({"a", 0, page::Mark::line, {{1, 2, "first"}, {2, 3, "second"}}});
  chart.series.push_back({"b", 1, page::Mark::dashed_line, {{1, 1, ""}, {2, 1, ""}}});
  const std::string text = draw(chart).to_text();
  EXPECT_EQ(count(text, "<circle"), 2);
  EXPECT_EQ(count(text, "<title>first</title>"), 1);
  EXPECT_EQ(count(text, "<li>"), 2);
  EXPECT_EQ(fault_of_markup(text), "");
}

/// Two sums of two operands each, compared; the second sum's result waits.
Pipeline small_pipeline() {
  Pipeline pipeline{.title = "p", .units = {}, .cycles = 9};
  const auto add = [&](const char* title, int start, int ready, std::vector<int> operands) {
    pipeline.units.push_back({.title = title,
                              .detail = "s8e8",
                              .tip = title,
                              .start_cycle = start,
                              .ready_cycle = ready,
                              .operands = std::move(operands)});
  };
  for (const char* input : {"a", "b", "c", "d"}) add(input, 0, 0, {});
  add("a + b", 0, 5, {0, 1});
  add("-(a + b)", 5, 5, {4});
  add("c + d", 0, 2, {2, 3});
  add("decide", 5, 9, {5, 6});
  return pipeline;
}

TEST(PagePipeline, BoxesOfOneRowDoNotOverlapAndOperandsAreAbove) {
  const Pipeline pipeline = small_pipeline();
  const page::PipelineRows rows(pipeline);
  const page::PipelineColumns columns(pipeline, rows);
  const int units = static_cast<int>(pipeline.units.size());
  for (int one = 0; one < units; ++one) {
    for (const int operand : pipeline.units[one].operands) {
      EXPECT_LT(rows.bottom(rows.last_row(operand)), rows.top(rows.first_row(one)));
    }
    for (int other = 0; other < one; ++other) {
      const bool apart =
          rows.last_row(one) < rows.first_row(other) || rows.last_row(other) < rows.first_row(one);
      if (apart) continue;
      const double distance = std::abs(columns.x(one) - columns.x(other));
      EXPECT_GE(distance + 1e-9, (columns.box_width(one) + columns.box_width(other)) / 2)
          << pipeline.units[one].title << " and " << pipeline.units[other].title;
    }
  }
}

TEST(PagePipeline, BoxesHaveRoomForTheirText) {
  const Pipeline pipeline = small_pipeline();
  const page::PipelineRows rows(pipeline);
  for (int unit = 0; unit < static_cast<int>(pipeline.units.size()); ++unit) {
    EXPECT_GE(rows.bottom(rows.last_row(unit)) - rows.top(rows.first_row(unit)), 37.9);
  }
}

TEST(PagePipeline, ValuesThatWaitAreDashed) {
  const std::string text = draw(small_pipeline()).to_text();
  EXPECT_EQ(count(text, "class=\"wire delayed\""), 1);
  EXPECT_EQ(count(text, "class=\"wire\""), 6);
  EXPECT_EQ(fault_of_markup(text), "");
}

TEST(PageWave, ShowsTheCyclesOfItsWindows) {
  page::Waveform wave{.title = "w", .cycle_zero = 10, .windows = {{9, 11}, {20, 21}}, .rows = {}};
  wave.rows.push_back({"aclk", page::WaveClock{}});
  wave.rows.push_back({"valid", page::WaveBit{{10}}});
  wave.rows.push_back({"bus", page::WaveBus{{{10, {"a", 0, "tip"}}, {30, {"b", 0, "unseen"}}}}});
  const std::string text = draw(wave).to_text();
  for (const char* cycle : {">-1<", ">0<", ">1<", ">10<", ">11<"}) {
    EXPECT_NE(text.find(cycle), std::string::npos) << cycle;
  }
  EXPECT_EQ(count(text, "class=\"idle\""), 4);
  EXPECT_EQ(count(text, "unseen"), 0);
  EXPECT_EQ(fault_of_markup(text), "");
}

}  // namespace
}  // namespace mixcmp::test::page_test

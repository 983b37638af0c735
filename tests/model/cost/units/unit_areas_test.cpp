#include "model/cost/units/unit_areas.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mixcmp::test::unit_areas_test {
namespace {

using devices::Area;
using units::Unit;

constexpr const char* small_library =
    "# synthesis: synth_a -flatten\n"
    "# also: synth_b -flatten\n"
    "\n"
    "[fixed_sum] rtl=0123\n"
    "WIDTH,CUTS,luts,registers,dsps,memories,carries,shift_luts\n"
    "4,1'h0,4,0,0,0,1,0\n"
    "8,1'h1,8,8,0,0,2,0\n";

Unit sum(int width, Bits cuts) {
  return {"fixed_sum", {units::integer("WIDTH", width), {"CUTS", 1, cuts}}};
}

/// Sums of widths from 2 to 40 in steps of `step`, with and without a register: a LUT and perhaps a
/// register for each bit, and a carry for four bits.
units::UnitAreas sums(int step) {
  units::UnitAreas library("synth_a");
  units::TemplateAreas areas{.module = "fixed_sum", .rtl = "0", .units = {}, .areas = {}};
  for (int width = 2; width <= 40; width += step) {
    for (const int cuts : {0, 1}) {
      areas.units.push_back(sum(width, cuts));
      areas.areas.push_back({.luts = width, .registers = cuts * width, .carries = (width + 3) / 4});
    }
  }
  library.set(std::move(areas));
  return library;
}

Unit memory(int a, int b, int width) {
  return {"squares",
          {units::integer("A", a), units::integer("B", b), units::integer("WIDTH", width)}};
}

/// Two ports share one memory up to ten bits, from eleven on they need four.
TEST(UnitAreas, HaveAsManyMemoriesAsMeasuredUnitsAllow) {
  units::UnitAreas library("synth_a");
  library.set({.module = "squares",
               .rtl = "0",
               .units = {memory(2, 2, 2), memory(3, 3, 4), memory(8, 8, 15), memory(9, 9, 17),
                         memory(10, 10, 19), memory(11, 11, 21), memory(12, 12, 23)},
               .areas = {{},
                         {.memories = 1},
                         {.memories = 1},
                         {.memories = 1},
                         {.memories = 1},
                         {.memories = 4},
                         {.memories = 4}}});
  for (int bits = 3; bits <= 10; ++bits) {
    const auto area = library.of(memory(bits, bits, 2 * bits - 2));
    EXPECT_EQ(area->memories, 1) << bits;
  }
  EXPECT_EQ(library.of(memory(11, 12, 22))->memories, 4);
  EXPECT_GE(library.of(memory(14, 14, 27))->memories, 4);
}

std::string message_of(const std::string& text) {
  const auto read = units::UnitAreas::read(text, "l.csv");
  return read.ok() ? "read" : read.error().to_string();
}

TEST(UnitAreas, AreWrittenAsTheyWereRead) {
  const auto library = units::UnitAreas::read(small_library, "l.csv");
  ASSERT_TRUE(library.ok()) << library.error().to_string();
  EXPECT_EQ(library->text(), small_library);
  EXPECT_TRUE(library->holds_for("synth_a -flatten"));
  EXPECT_TRUE(library->holds_for("synth_b -flatten"));
  EXPECT_FALSE(library->holds_for("synth_c"));
  EXPECT_EQ(library->of(sum(8, 1)), (Area{.luts = 8, .registers = 8, .carries = 2}));
}

TEST(UnitAreas, OfUnknownTemplatesOrParametersAreNone) {
  const auto library = units::UnitAreas::read(small_library, "l.csv");
  ASSERT_TRUE(library.ok());
  EXPECT_FALSE(library->of({"fp_add", {units::integer("WIDTH", 4)}}).has_value());
  EXPECT_FALSE(library->of({"fixed_sum", {units::integer("WIDTH", 4)}}).has_value());
  Unit renamed = sum(4, 0);
  renamed.parameters[0].name = "A_WIDTH";
  EXPECT_FALSE(library->of(renamed).has_value());
}

TEST(UnitAreas, BetweenMeasuredUnitsFollowTheFormula) {
  const units::UnitAreas library = sums(3);
  for (int width = 3; width <= 40; ++width) {
    for (const int cuts : {0, 1}) {
      const auto area = library.of(sum(width, cuts));
      ASSERT_TRUE(area.has_value());
      EXPECT_EQ(area->luts, width);
      EXPECT_EQ(area->registers, cuts * width);
      EXPECT_NEAR(area->carries, (width + 3) / 4, 1);
    }
  }
}

/// The ranges of a scene may be far from those that were measured, with limits of 2^-5 to 2^8.
TEST(UnitAreas, DoNotDependOnTheSizeOfNumbers) {
  const std::vector<units::UnitAreas> libraries = units::shipped_libraries().value();
  const auto operand = [&](int top) {
    return libraries.front()
        .of({"fixed_operand",
             {units::integer("EXPONENT_BITS", 11),
              units::integer("PRECISION", 53),
              units::integer("TOP", top),
              units::integer("WIDTH", 10),
              units::integer("SIGNED", 0),
              {"CUTS", 2, 2},
              units::integer("EMBEDDED_PRODUCTS", 0)}})
        .value();
  };
  for (const int top : {-996, -20, 2, 7, 20, 300}) {
    EXPECT_NEAR(operand(top).luts, 24, 12) << top;  // by Yosys 0.23: 22 to 26
    EXPECT_NEAR(operand(top).registers, 11, 1) << top;
  }
}

/// Memories of rows of LUTs up to 20 bits, of a block above; queues of a memory and five LUTs.
units::UnitAreas queues() {
  units::UnitAreas library("synth_a");
  units::TemplateAreas memories{.module = "memory", .rtl = "0", .units = {}, .areas = {}};
  units::TemplateAreas queues{.module = "queue", .rtl = "0", .units = {}, .areas = {}};
  const auto memory = [](int width) {
    return width <= 20 ? Area{.luts = 3 * width} : Area{.memories = 1};
  };
  for (int width = 1; width <= 40; ++width) {
    memories.units.push_back({"memory", {units::integer("WIDTH", width)}});
    memories.areas.push_back(memory(width));
  }
  for (const int width : {3, 7, 24, 39}) {
    queues.units.push_back({"queue", {units::integer("WIDTH", width)}});
    queues.areas.push_back(memory(width) + Area{.luts = 5});
  }
  library.set(std::move(memories));
  library.set(std::move(queues));
  return library;
}

TEST(UnitAreas, AreTheAreasOfTheirPartsAndARest) {
  units::UnitAreas library = queues();
  const Unit queue{"queue", {units::integer("WIDTH", 19)}};
  EXPECT_GT(library.of(queue)->memories, 0);  // a line between 7 and 24 knows no step
  library.take_apart([](const Unit& unit) {
    // The wrapper is not in the library, and is taken apart in turn.
    if (unit.module == "queue") return std::vector{Unit{"wrapper", unit.parameters}};
    if (unit.module == "wrapper") return std::vector{Unit{"memory", unit.parameters}};
    return std::vector<Unit>();
  });
  EXPECT_EQ(library.of(queue), (Area{.luts = 62}));
  EXPECT_EQ(library.of({"queue", {units::integer("WIDTH", 30)}}), (Area{.luts = 5, .memories = 1}));
}

/// A formula of a few terms has no steps, but what it misses at the units that differ in one number
/// brings them back.
TEST(UnitAreas, LieBetweenTheirNeighbours) {
  units::UnitAreas library("synth_a");
  units::TemplateAreas areas{.module = "memory", .rtl = "0", .units = {}, .areas = {}};
  const auto memory = [](int width, int depth) {
    return Unit{"memory", {units::integer("WIDTH", width), units::integer("DEPTH", depth)}};
  };
  for (const int width : {2, 4, 8, 16, 32}) {
    for (const int depth : {5, 11, 23, 47}) {
      areas.units.push_back(memory(width, depth));
      areas.areas.push_back({.luts = width * (depth % 7) * (depth % 3)});
    }
  }
  library.set(std::move(areas));
  EXPECT_NEAR(library.of(memory(12, 5))->luts, 12 * 5 * 2, 4);
  EXPECT_NEAR(library.of(memory(23, 11))->luts, 23 * 4 * 2, 4);
}

TEST(UnitAreas, OfDelayLinesAreThoseOfTheirBits) {
  units::UnitAreas library("synth_a");
  const auto line = [](int width, int length) {
    return Unit{"delay_line", {units::integer("WIDTH", width), units::integer("LENGTH", length)}};
  };
  library.set({.module = "delay_line",
               .rtl = "0",
               .units = {line(1, 1), line(1, 2)},
               .areas = {{.registers = 1}, {.luts = 1, .registers = 1}}});
  EXPECT_EQ(library.of(line(9, 2)), (Area{.luts = 9, .registers = 9}));
}

Unit memory(int width, int address_bits) {
  return {"dual_port_memory",
          {units::integer("WIDTH", width), units::integer("ADDRESS_BITS", address_bits)}};
}

/// 1,200 bits are three times 288 and the rest, which has the area of its own row.
TEST(UnitAreas, OfWideMemoriesAreThoseOfNarrowOnes) {
  units::UnitAreas library("synth_a");
  library.set({.module = "dual_port_memory",
               .rtl = "0",
               .units = {memory(288, 5), memory(336, 5), memory(575, 5), memory(2000, 5)},
               .areas = {{.luts = 192}, {.luts = 7}, {.luts = 99}, {.luts = 5}}});
  EXPECT_EQ(library.of(memory(1200, 5)), (Area{.luts = 3 * 192 + 7}));
  EXPECT_EQ(library.of(memory(576, 5)), (Area{.luts = 2 * 192}));
  EXPECT_EQ(library.of(memory(575, 5)), (Area{.luts = 99}));
  EXPECT_EQ(library.of(memory(2000, 5)), (Area{.luts = 5}));  // as measured
}

/// A product is in a multiplier or in LUTs, which no sum of terms tells apart.
TEST(UnitAreas, OfProductsDependOnWhereTheyAre) {
  units::UnitAreas library("synth_a");
  const auto product = [](int width, int embedded) {
    return Unit{"fixed_product",
                {units::integer("WIDTH", width),
                 units::integer(std::string(units::embedded_products), embedded)}};
  };
  units::TemplateAreas areas{.module = "fixed_product", .rtl = "0", .units = {}, .areas = {}};
  for (int width = 2; width <= 24; ++width) {
    const bool embedded = width % 2 == 0;
    areas.units.push_back(product(width, embedded ? 1 : 0));
    areas.areas.push_back(embedded ? Area{.dsps = 1} : Area{.luts = width * width});
  }
  library.set(std::move(areas));
  for (int width = 3; width <= 24; ++width) {
    EXPECT_EQ(library.of(product(width, 0))->luts, width * width);
    EXPECT_EQ(library.of(product(width, 1)), (Area{.dsps = 1}));
  }
}

TEST(AreaFormula, FindsTheTermsThatMadeTheAmounts) {
  std::vector<Unit> all;
  std::vector<double> amounts;
  const auto amount = [](int precision, int embedded, Bits cuts) {
    const double product = embedded == 0 ? 2.0 * precision * precision : 0;
    return 30 + product + 3 * precision * std::log2(precision) + ((cuts >> 1 & 1) != 0 ? 40 : 0);
  };
  for (int precision = 4; precision <= 53; precision += 3) {
    for (const int embedded : {0, 1}) {
      for (Bits cuts = 0; cuts < 4; ++cuts) {
        all.push_back({"fp_multiply",
                       {units::integer("PRECISION", precision),
                        units::integer("FREE", embedded),
                        {"CUTS", 2, cuts}}});
        amounts.push_back(amount(precision, embedded, cuts));
      }
    }
  }
  const units::Formula formula = units::fit(all, amounts, amounts);
  for (const int precision : {5, 24, 52}) {
    for (const int embedded : {0, 1}) {
      const Unit unit{"fp_multiply",
                      {units::integer("PRECISION", precision),
                       units::integer("FREE", embedded),
                       {"CUTS", 2, 2}}};
      const double right = amount(precision, embedded, 2);
      EXPECT_NEAR(formula.of(unit), right, 0.01 * right);
    }
  }
  EXPECT_LE(formula.terms.size(), 10u);  // of some thirty that are possible
}

/// A LUT of six inputs chooses among up to four bits, and one bit needs none: a step that no
/// product of sizes has.
TEST(AreaFormula, ASingleStreamNeedsNoMultiplexer) {
  const auto arbiter = [](int inputs, int width) {
    return Unit{"arbiter", {units::integer("INPUTS", inputs), units::integer("WIDTH", width)}};
  };
  const auto amount = [](int inputs, int width) { return inputs == 1 ? 4.0 : 15.0 + width; };
  std::vector<Unit> all;
  std::vector<double> amounts;
  for (int inputs = 1; inputs <= 4; ++inputs) {
    for (int width = 10; width <= 400; width += 30) {
      all.push_back(arbiter(inputs, width));
      amounts.push_back(amount(inputs, width));
    }
  }
  const units::Formula formula = units::fit(all, amounts, amounts);
  for (int inputs = 1; inputs <= 4; ++inputs) {
    EXPECT_NEAR(formula.of(arbiter(inputs, 205)), amount(inputs, 205), 1) << inputs;
  }
}

TEST(AreaFormula, ASingleUnitGivesItsOwnAmount) {
  const Unit unit = sum(4, 0);
  EXPECT_NEAR(units::fit({unit}, {7}, {7}).of(unit), 7, 1e-9);
}

TEST(AreaFormula, TermsHaveNames) {
  const Unit unit = sum(4, 1);
  EXPECT_EQ(to_string(units::Term{}, unit), "1");
  EXPECT_EQ(to_string(units::Term{{0, units::Factor::Kind::size},
                                  {0, units::Factor::Kind::log},
                                  {1, units::Factor::Kind::bit, 0}},
                      unit),
            "WIDTH*lg(WIDTH)*CUTS[0]");
  EXPECT_EQ(to_string(units::Term{{0, units::Factor::Kind::many}}, unit), "(WIDTH>1)");
}

TEST(UnitAreas, MistakesAreNamedWithTheirLine) {
  EXPECT_EQ(message_of(""),
            "l.csv: no synthesis command: received \"\"; accepted # synthesis: "
            "COMMAND");
  const std::string head = "# synthesis: s\n\n[t] rtl=0\n";
  const std::string columns = "A,luts,registers,dsps,memories,carries,shift_luts\n";
  EXPECT_NE(message_of("# synthesis: s\n\nfixed_sum\n").find("l.csv:3: no section"),
            std::string::npos);
  EXPECT_NE(message_of(head + "A,luts\n").find("l.csv:4: not the columns"), std::string::npos);
  EXPECT_NE(message_of(head + columns + "1,2,3\n").find("l.csv:5: not a row"), std::string::npos);
  EXPECT_NE(message_of(head + columns + "x,0,0,0,0,0,0\n").find("l.csv:5: A: not a value"),
            std::string::npos);
  EXPECT_NE(message_of(head + columns + "4'hg,0,0,0,0,0,0\n").find("A: not a value"),
            std::string::npos);
  EXPECT_NE(message_of(head + columns + "1,-2,0,0,0,0,0\n").find("luts: not a count"),
            std::string::npos);
  EXPECT_EQ(message_of(head + columns + "1,2,0,0,0,0,0\n"), "read");
}

/// The measured memories of 1,024 bits, predicted from those of up to 512. The library has no
/// memory of 288 bits yet; the line between its neighbours gives 31 blocks for 29 at depths of 128
/// to 512.
TEST(ShippedLibraries, KnowWideMemoriesByNarrowOnes) {
  auto libraries = units::shipped_libraries().value();
  for (units::UnitAreas& library : libraries) {
    const units::TemplateAreas all = *library.find("dual_port_memory");
    units::TemplateAreas narrow{.module = all.module, .rtl = all.rtl, .units = {}, .areas = {}};
    const auto is_wide = [](const Unit& unit) { return unit.parameters.front().size() >= 576; };
    for (std::size_t k = 0; k < all.units.size(); ++k) {
      if (is_wide(all.units[k])) continue;
      narrow.units.push_back(all.units[k]);
      narrow.areas.push_back(all.areas[k]);
    }
    library.set(narrow);
    int wide = 0;
    for (std::size_t k = 0; k < all.units.size(); ++k) {
      if (!is_wide(all.units[k])) continue;
      const auto area = library.of(all.units[k]);
      ASSERT_TRUE(area.has_value());
      const Area& right = all.areas[k];
      EXPECT_NEAR(area->luts, right.luts, 0.03 * right.luts);
      EXPECT_NEAR(area->memories, right.memories, 0.07 * right.memories + 1);
      EXPECT_NEAR(area->registers, right.registers, 0.03 * right.registers);
      ++wide;
    }
    EXPECT_GE(wide, 12);
  }
}

TEST(ShippedLibraries, AreReadable) {
  const auto libraries = units::shipped_libraries();
  ASSERT_TRUE(libraries.ok()) << libraries.error().to_string();
  EXPECT_FALSE(libraries->empty());
  for (const units::UnitAreas& library : *libraries) {
    for (const auto& [module, areas] : library.templates()) {
      EXPECT_EQ(areas.units.size(), areas.areas.size()) << module;
    }
  }
}

}  // namespace
}  // namespace mixcmp::test::unit_areas_test

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "generator/present/report/trade_report.hpp"
#include "model/cost/estimated/table_luts.hpp"
#include "model/lane/error/profiled_lane.hpp"
#include "model/plan/profile/schemes.hpp"
#include "tests/model/plan/profile/profile_cases.hpp"
#include "tests/support/scratch_directory.hpp"
#include "tests/support/sphere.hpp"

namespace mixcmp::test::trade_test {
namespace {

using estimated::MeasuredAreas;
using profile::RateProfile;
using profile::SchemeCounts;
using profile::SchemeKind;
using profile::Trade;
using profile::TradePoint;
using scene::Scene;

Scene sphere_scene() {
  const Arithmetic reduced{format_of(8, 8)};
  Scene scene = scene_of(sphere_graph(), format_of(53, 8), reduced);
  scene.system.slack = 0.25;
  return scene;
}

/// The comparisons of a thousand that each scheme leaves undecided, and errs on, at L = 8, 9, 10.
Trade trade_of(const Scene& scene, const MeasuredAreas& areas) {
  profile::ErrorProfile errors{
      .comparisons = 1000, .precisions = {}, .no_f_bound = {}, .no_g_bound = {}};
  for (int precision = 8; precision <= 10; ++precision) {
    errors.precisions.push_back(
        {.precision = precision, .f = mpq_class(1, 50), .g = mpq_class(1, 50)});
  }
  RateProfile rates{.first_precision = 8, .comparisons = 1000, .reference_wrong = 3};
  for (const profile::SchemeLanes& scheme : make_schemes(scene, errors)) {
    const std::uint64_t wrong = scheme.kind == SchemeKind::lanes_alone ? 20
                                : scheme.kind == SchemeKind::profiled  ? 1
                                                                       : 0;
    const std::uint64_t undecided = scheme.kind == SchemeKind::lanes_alone ? 0 : 100;
    rates.schemes.push_back({.name = scheme.name, .kind = scheme.kind, .counts = {}, .reason = ""});
    for (const std::uint64_t k : {1u, 2u, 4u}) {
      rates.schemes.back().counts.push_back(SchemeCounts{true, undecided / k, wrong / k});
    }
  }
  return make_trade(scene, rates, errors, areas);
}

const TradePoint& point_of(const Trade& trade, const std::string& scheme, int precision) {
  for (const TradePoint& point : trade.points) {
    if (point.scheme == scheme && point.precision == precision) return point;
  }
  throw std::runtime_error("no such point");
}

class Areas : public testing::Test {
protected:
  Result<MeasuredAreas> read(const std::string& text) {
    const auto path = directory_.path() / "areas.csv";
    std::ofstream(path) << text;
    return MeasuredAreas::read(path);
  }
  ScratchDirectory directory_;
};

TEST_F(Areas, ReplaceTheModels) {
  const auto areas = read("scheme,precision,luts\nreference,53,8000\nrelative,9,1000\r\n").value();
  const Trade trade = trade_of(sphere_scene(), areas);
  const TradePoint measured = point_of(trade, "relative", 9);
  EXPECT_TRUE(measured.measured && trade.reference_measured);
  EXPECT_EQ(trade.reference_luts, 8000);
  EXPECT_EQ(measured.rate, 0.05);
  // One lane and 0.05 * 1.25 of a reference: 1500 LUTs for a comparison a cycle.
  EXPECT_DOUBLE_EQ(measured.per_kiloluts, 1000.0 / 1500);
  EXPECT_FALSE(point_of(trade, "relative", 10).measured);
  EXPECT_FALSE(point_of(trade, "profiled", 9).measured);
}

TEST_F(Areas, AreThoseOfAWholeFile) {
  EXPECT_NE(MeasuredAreas::read("/proc/self/mem").error().to_string().find("cannot be read"),
            std::string::npos);
  const std::string pipe = (directory_.path() / "pipe").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(MeasuredAreas::read(pipe).error().received, "no readable regular file");
}

TEST_F(Areas, NameWhatIsWrong) {
  const auto message = [&](const std::string& text) { return read(text).error().to_string(); };
  EXPECT_NE(message("").find("areas.csv"), std::string::npos);
  EXPECT_NE(message("a,b\n").find("areas.csv:1: header"), std::string::npos);
  const std::string header = "scheme,precision,luts\n";
  EXPECT_NE(message(header + "relative,9\n").find("areas.csv:2"), std::string::npos);
  EXPECT_NE(
      message(header + "relative,nine,1\n").find("precision: is not usable: received \"nine\""),
      std::string::npos);
  for (const char* luts : {"0", "-1", "inf", "nan", "1x"}) {
    EXPECT_NE(message(header + "relative,9," + luts + "\n").find("luts"), std::string::npos)
        << luts;
  }
}

TEST(TradeAdvice, IsTheCheapestThatQualifies) {
  const Trade trade = trade_of(sphere_scene(), MeasuredAreas());
  const auto expect_cheapest = [&](double accepted, auto qualifies) {
    const TradePoint* best = cheapest(trade, accepted);
    ASSERT_NE(best, nullptr);
    EXPECT_TRUE(qualifies(*best)) << best->scheme;
    for (const TradePoint& point : trade.points) {
      if (!qualifies(point)) continue;
      EXPECT_LE(point.per_kiloluts, best->per_kiloluts) << point.scheme;
    }
  };
  expect_cheapest(0, [](const TradePoint& p) { return p.kind == SchemeKind::certified; });
  expect_cheapest(500, [](const TradePoint& p) { return p.wrong_per_million <= 500; });
  expect_cheapest(1e6, [](const TradePoint&) { return true; });
  EXPECT_EQ(point_of(trade, "lanes_alone", 8).wrong_per_million, 20000);
}

TEST(TradeAdvice, SaysWhereNothingQualifies) {
  Trade trade;
  trade.points = {{.scheme = "relative", .kind = SchemeKind::certified, .wrong_per_million = 1}};
  EXPECT_EQ(cheapest(trade, 0), nullptr) << "the reference errs on what it recomputes";
  EXPECT_NE(report::advice(trade, 0).find("no scheme"), std::string::npos);
  EXPECT_NE(cheapest(trade, 2), nullptr);
}

TEST(TradeAdvice, TakesAnUndeterminedTruthForAWrongVerdict) {
  Trade trade;
  trade.points = {{.scheme = "relative", .kind = SchemeKind::certified, .per_kiloluts = 1}};
  EXPECT_NE(cheapest(trade, 0), nullptr);
  trade.undetermined_per_million = 4;
  EXPECT_EQ(cheapest(trade, 0), nullptr);
  EXPECT_EQ(cheapest(trade, 3), nullptr);
  EXPECT_NE(cheapest(trade, 4), nullptr);
  for (const double accepted : {0.0, 4.0}) {
    EXPECT_NE(report::advice(trade, accepted).find("4 per million whose truth is undetermined"),
              std::string::npos);
  }
}

TEST(CostModel, GrowsWithPrecisionAndWithTheErrorUnit) {
  const Scene scene = sphere_scene();
  double before = 0;
  for (int precision = 4; precision <= 52; ++precision) {
    const TypedGraph graph = profile::graph_at(scene, precision, LaneInputs::rounded);
    const error::Lane alone = error::one_part_lane(
        graph, error::UlpDistanceCriterion{.guard_ulp = 0, .nonnegative = true});
    const error::Lane profiled = error::profiled_lane(graph, mpq_class(1, 9), mpq_class(1, 9));
    EXPECT_GT(estimated::lane_luts(alone), before);
    EXPECT_GT(estimated::lane_luts(profiled), estimated::lane_luts(alone) + 100);
    before = estimated::lane_luts(alone);
  }
  EXPECT_GT(estimated::reference_luts(reference_graph(scene.graph, scene.reference)), before);
}

/// Yosys makes the same number of blocks for whole lanes (docs/fixed_point.md).
TEST(CostModel, CountsTheBlocksOfSquaresInMemory) {
  struct Measured {
    int bits, blocks_18k, blocks_4k;
  };
  const Graph graph = sphere_graph();
  for (const auto& [bits, blocks_18k, blocks_4k] :
       {Measured{9, 2, 11}, Measured{11, 8, 52}, Measured{13, 35, 248}}) {
    const fixed::FixedOptions options = {
        .format = {bits}, .ranges = {graph.inputs().size(), std::optional(Range{0, 100})}};
    const auto lane = fixed::fixed_lane(graph, format_of(53, 8), options).value();
    EXPECT_EQ(estimated::memory_blocks(lane, {}), blocks_18k) << bits;
    const int of_ice40 = estimated::memory_blocks(lane, {.bits = 4096, .read_ports = 1});
    EXPECT_NEAR(of_ice40, blocks_4k, 0.05 * blocks_4k) << bits;
    using estimated::Products;
    EXPECT_LT(estimated::lane_luts(lane, Products::left_out),
              estimated::lane_luts(lane, Products::squares_in_memory));
    EXPECT_LT(estimated::lane_luts(lane, Products::squares_in_memory),
              estimated::lane_luts(lane, Products::in_luts));
  }
}

/// A look-up table has six inputs; equal ones are shared. Constants and bits of the address cost
/// nothing.
TEST(TableLuts, AreTheDifferentPartsOfAllBits) {
  const auto luts = [](int address_bits, int width, auto word_at) {
    std::vector<Bits> words;
    for (unsigned address = 0; address < 1U << address_bits; ++address) {
      words.push_back(word_at(address));
    }
    return estimated::table_luts(words, width);
  };
  EXPECT_EQ(luts(6, 4, [](unsigned) { return Bits{10}; }), 0);
  EXPECT_EQ(luts(6, 3, [](unsigned address) { return Bits{address >> 3}; }), 0);
  EXPECT_EQ(luts(6, 2, [](unsigned address) { return Bits{(address & 5) == 4} * 3; }), 1);
  // The parity depends on three bits of seven: one look-up table.
  const auto parity = [](unsigned address) {
    return Bits{(address ^ address >> 3 ^ address >> 6) & 1};
  };
  EXPECT_EQ(luts(7, 1, parity), 1);
  // Bit 0 of these words is 0, bit 1 depends on two bits of the address.
  EXPECT_EQ(luts(7, 2, [](unsigned address) { return Bits{(address >> 6) * (address & 2)}; }), 1);
  // A function of other bits is another look-up table.
  EXPECT_EQ(luts(6, 2, [](unsigned a) { return Bits{(a & a >> 1 & 1) | (a >> 1 & a >> 2 & 2)}; }),
            2);
  // Four different parts; multiplexers of more than four parts are look-up tables themselves.
  const auto scattered = [](unsigned address) { return Bits{(address * 2654435761U >> 20) & 1}; };
  EXPECT_EQ(luts(8, 1, scattered), 4);
  EXPECT_EQ(luts(9, 1, scattered), 8 + 2);
}

}  // namespace
}  // namespace mixcmp::test::trade_test

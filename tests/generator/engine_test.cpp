#include <gtest/gtest.h>

#include <algorithm>

#include "generator/hardware/emit/system.hpp"
#include "model/comparison/expression/parser.hpp"
#include "tests/support/scratch_directory.hpp"
#include "tests/support/sphere.hpp"

namespace mixcmp::test::engine_test {
namespace {

design::Design with_pairs(design::Design design, const scene::EngineSpec& engine) {
  design.system = with_engine(design.system, engine);
  return design;
}

emit::GeneratedSystem generated(const design::Design& design) {
  return emit::generate_system(design, "mixcmp generate scene.toml").value();
}

design::Design spheres(int lanes, int references) {
  return with_pairs(
      test::sphere_design(format("s17e8"), format("s53e8"), lanes, references),
      {.kind = scene::EngineKind::pairwise, .capacity = 1000, .report = {Verdict::less}});
}

/// One lane and a reference for `f` against `g`.
design::Design design_of(const std::string& f, const std::string& g) {
  Graph graph;
  const NodeId left = parse_expression(graph, f, {}).value();
  graph.compare(left, parse_expression(graph, g, {}).value());
  TypedGraph lane = lane_graph(graph, format("s24e8"), {format("s8e8")}, LaneInputs::exact);
  const std::vector<bool> any_sign(graph.inputs().size(), false);
  return {.name = "comparison",
          .inputs = graph.inputs(),
          .lanes = {{.lane = test::relative_lane(std::move(lane), any_sign).value(), .count = 1}},
          .reference = reference_graph(graph, {format("s24e8")}),
          .references = {{.count = 1}},
          .system = {}};
}

std::string verilog_of(const emit::GeneratedSystem& system, const std::string& module) {
  const auto found =
      std::find_if(system.files.begin(), system.files.end(),
                   [&](const emit::GeneratedFile& f) { return f.name == module + ".v"; });
  EXPECT_NE(found, system.files.end()) << module;
  return found == system.files.end() ? "" : found->text;
}

int width_of(const emit::SignatureEngine& engine, const std::string& port) {
  const auto found = std::find_if(engine.ports.begin(), engine.ports.end(),
                                  [&](const emit::SignaturePort& p) { return p.name == port; });
  return found == engine.ports.end() ? 0 : found->width;
}

TEST(Engine, WithoutOneNothingOfItIsWritten) {
  const emit::GeneratedSystem system =
      generated(test::sphere_design(format("s17e8"), format("s53e8"), 8, 1));
  EXPECT_FALSE(system.signature.engine.has_value());
  for (const emit::GeneratedFile& file : system.files) {
    EXPECT_EQ(file.text.find("pairwise"), std::string::npos) << file.name;
  }
}

TEST(Engine, TopSaysWhatItComparesAndWhereColumnsAre) {
  design::Design design = spheres(8, 1);
  design.parts = {{.f = "distance2", .g = "reach2"}};
  const emit::GeneratedSystem system = generated(design);
  const std::string top = verilog_of(system, "sphere_s17e8_8x1_pairwise");
  for (const char* lines :
       {"// The verdict of a pair is the sign of f - g:\n//   f = distance2\n//   g = reach2\n"
        "// Streams s_axis, m_axis: AXI4-Stream.\n",
        "//   cx [60:0], cy [121:61], cz [182:122], r [243:183]\n"
        "//   each in s53e8: sign [60], exponent + 127 [59:52], fraction [51:0].\n"}) {
    EXPECT_NE(top.find(lines), std::string::npos) << lines << top.substr(0, 1500);
  }
}

TEST(Engine, TopSaysWhatLeaves) {
  const auto top_of = [](scene::ReportForm form, int references) {
    design::Design design = spheres(8, references);
    design.system.engine.report_as = form;
    const emit::GeneratedSystem system = generated(design);
    return verilog_of(system, system.signature.engine->top);
  };
  const auto expect_in = [](const std::string& top, const std::string& lines) {
    EXPECT_NE(top.find(lines), std::string::npos) << lines << top.substr(0, 1500);
  };
  expect_in(top_of(scene::ReportForm::pairs, 1),
            "// m_axis: a beat a pair that is less;\n//   tdata: i in");
  expect_in(top_of(scene::ReportForm::pairs, 0), "a beat a pair that is less or undecided;\n");
  expect_in(top_of(scene::ReportForm::bitmap, 0), "j; undecided pairs leave one by one;\n");
  expect_in(top_of(scene::ReportForm::count, 0),
            "// m_axis: a beat a set, with the number of pairs that are less or undecided.\n"
            "// A set ends with a beat with tlast: tdata is that number, tuser\n");
}

TEST(Engine, ANoteTellsThatUndecidedPairsAreCounted) {
  const auto notes_of = [](scene::ReportForm form, int references) {
    design::Design design = spheres(8, references);
    design.system.engine.report_as = form;
    return generated(design).notes;
  };
  const std::string note =
      "there is no reference: pairs that stay undecided are in the number that is reported";
  EXPECT_EQ(notes_of(scene::ReportForm::count, 0), std::vector<std::string>{note});
  EXPECT_TRUE(notes_of(scene::ReportForm::count, 1).empty());
  EXPECT_TRUE(notes_of(scene::ReportForm::pairs, 0).empty());
}

TEST(Engine, SignatureTellsItsStreams) {
  const emit::GeneratedSystem system = generated(spheres(8, 1));
  ASSERT_TRUE(system.signature.engine.has_value());
  const emit::SignatureEngine& engine = *system.signature.engine;
  EXPECT_EQ(system.signature.top, "sphere_s17e8_8x1");
  EXPECT_EQ(engine.top, "sphere_s17e8_8x1_pairwise");
  EXPECT_EQ(engine.columns, (std::vector<std::string>{"cx", "cy", "cz", "r"}));
  EXPECT_EQ(engine.index_bits, 10);
  EXPECT_EQ(engine.item_bytes, 31);  // 4 * 61 bits
  EXPECT_EQ(engine.report, std::vector<std::string>{"less"});
  EXPECT_EQ(width_of(engine, "s_axis_tdata"), 248);
  EXPECT_EQ(width_of(engine, "m_axis_tdata"), 32);
  EXPECT_EQ(width_of(engine, "reports"), 32);
  EXPECT_EQ(width_of(engine, "s_axis_tuser"), 1);
  EXPECT_EQ(system.signature.tag_bits, 20);
  EXPECT_EQ(system.signature.operands, scene::OperandStore::refetched);
}

TEST(Engine, SignatureIsReadBackWhole) {
  test::ScratchDirectory scratch;
  const emit::GeneratedSystem system = generated(spheres(3, 2));
  ASSERT_TRUE(emit::write_system(system, scratch.path() / "out").ok());
  const auto read = emit::read_signature(scratch.path() / "out" / (system.signature.top + ".json"));
  ASSERT_TRUE(read.ok()) << read.error().to_string();
  EXPECT_EQ(to_json(*read), to_json(system.signature));
}

TEST(Engine, EachOperandComesFromItsItem) {
  const emit::GeneratedSystem system = generated(with_pairs(
      design_of("aj - bi", "aj * ci"), {.kind = scene::EngineKind::pairwise, .capacity = 2}));
  const std::string text = verilog_of(system, "comparison_s8e8_1x1_pairwise");
  // Columns a, b, c of 32 bits; the operands are aj, bi, ci.
  EXPECT_NE(text.find("operand_aj = item_j[31:0];"), std::string::npos) << text;
  EXPECT_NE(text.find("operand_bi = item_i[63:32];"), std::string::npos);
  EXPECT_NE(text.find("operand_ci = item_i[95:64];"), std::string::npos);
  EXPECT_NE(text.find("{operand_ci, operand_bi, operand_aj}"), std::string::npos);
  EXPECT_NE(text.find("unused_columns = &{1'b0, item_i[31:0], item_j[63:32], item_j[95:64]};"),
            std::string::npos);
}

TEST(Engine, TemplateIsToldWhatTheSystemIs) {
  const std::string text = verilog_of(generated(spheres(8, 1)), "sphere_s17e8_8x1_pairwise");
  for (const char* parameter :
       {".SEGMENTS         (1)", ".LANES_PER_SEGMENT(8)", ".LANES            (8)",
        ".REFERENCES       (1)", ".CAPACITY         (1000)", ".ITEM_BITS        (244)",
        ".WORD_BITS        (244)", ".WORD_LATENCY     (0)", ".INDEX_BITS       (10)",
        ".REPORT           (1)", ".CODE_BITS        (2)", ".COUNTER_BITS     (32)"}) {
    EXPECT_NE(text.find(parameter), std::string::npos) << parameter << "\n" << text;
  }
}

/// An engine of four candidates; only f reads w, only g reads o.
emit::GeneratedSystem arg_min_of_four() {
  design::Design design = with_pairs(design_of("(p - ci)^2 + (wi * q)^2", "(p - cj)^2 + oj^2"),
                                     {.kind = scene::EngineKind::arg_min, .row_tag_bits = 5});
  design.lanes.front().count = 3;
  return generated(design);
}

/// References begin in turn, each a third of the interval after the one before.
TEST(Engine, FoldedReferencesBeginInDifferentPhases) {
  design::Design design = spheres(8, 3);
  design.references.front().structure.initiation_interval = 4;
  const emit::GeneratedSystem system = generated(design);
  const std::string text = verilog_of(system, system.signature.engine->top);
  EXPECT_NE(text.find("references_reset_phases = {2'b10, 2'b11, 2'b00};"), std::string::npos)
      << text;
}

/// In an interval of two cycles a reference reads operands in its last phase: its register takes
/// the next request while the last one leaves.
TEST(Engine, AReferenceThatReadsLateGetsARequestInEachInterval) {
  design::Design design = spheres(8, 1);
  for (const auto& [interval, parameter] :
       {std::pair(2, ".HALF_RATE(0)"), std::pair(16, ".HALF_RATE(1)")}) {
    design.references.front().structure.initiation_interval = interval;
    const std::string top = verilog_of(generated(design), "sphere_s17e8_8x1_pairwise");
    EXPECT_NE(top.find(parameter), std::string::npos) << interval;
  }
}

TEST(ArgMinEngine, SignatureTellsItsStreams) {
  const emit::SignatureEngine engine = *arg_min_of_four().signature.engine;
  EXPECT_EQ(engine.kind, scene::EngineKind::arg_min);
  EXPECT_EQ(engine.capacity, 4);
  EXPECT_EQ(engine.index_bits, 2);
  EXPECT_EQ(engine.columns, (std::vector<std::string>{"c", "w", "o"}));
  EXPECT_EQ(engine.row_columns, (std::vector<std::string>{"p", "q"}));
  EXPECT_EQ(engine.item_bytes, 12);
  EXPECT_EQ(engine.row_bytes, 8);
  EXPECT_EQ(engine.tag_bits, 5);
  EXPECT_EQ(width_of(engine, "s_candidate_tdata"), 96);
  EXPECT_EQ(width_of(engine, "s_axis_tdata"), 64);
  EXPECT_EQ(width_of(engine, "s_axis_tuser"), 5);
  EXPECT_EQ(width_of(engine, "m_axis_tdata"), 8);
  EXPECT_EQ(width_of(engine, "comparisons"), 3 * 32);
}

TEST(ArgMinEngine, SignatureIsReadBackWhole) {
  test::ScratchDirectory scratch;
  const emit::GeneratedSystem system = arg_min_of_four();
  ASSERT_TRUE(emit::write_system(system, scratch.path() / "out").ok());
  const auto read = emit::read_signature(scratch.path() / "out" / (system.signature.top + ".json"));
  ASSERT_TRUE(read.ok()) << read.error().to_string();
  EXPECT_EQ(to_json(*read), to_json(system.signature));
}

TEST(ArgMinEngine, TopSaysWhatItComparesAndWhereColumnsAre) {
  design::Design design = with_pairs(design_of("(p - ci)^2", "(p - cj)^2"),
                                     {.kind = scene::EngineKind::arg_min, .row_tag_bits = 5});
  design.parts = {{.f = "(p - ci)^2", .g = "(p - cj)^2"}};
  const emit::GeneratedSystem system = generated(design);
  const std::string top = verilog_of(system, system.signature.engine->top);
  for (const char* lines : {"// Candidate j replaces i, the best before it, where the verdict is "
                            "greater. It is the sign "
                            "of f - g:\n//   f = (p - ci)^2\n//   g = (p - cj)^2\n"
                            "// Streams s_candidate, s_axis, m_axis: AXI4-Stream.\n",
                            "//   c [31:0]\n//   each in s24e8: sign [31],", "//   p [31:0]\n"}) {
    EXPECT_NE(top.find(lines), std::string::npos) << lines << top.substr(0, 1500);
  }
}

TEST(ArgMinEngine, EachOperandComesFromItsItem) {
  const emit::GeneratedSystem system = arg_min_of_four();
  const std::string text = verilog_of(system, system.signature.engine->top);
  for (const char* line :
       {"operand_p = row[31:0];", "operand_ci = best[31:0];", "operand_wi = best[63:32];",
        "operand_q = row[63:32];", "operand_cj = own[31:0];", "operand_oj = own[95:64];",
        "unused_columns = &{1'b0, best[95:64], own[63:32]};"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
  }
}

TEST(Engine, SameDesignGivesTheSameBytes) {
  const emit::GeneratedSystem once = generated(spheres(3, 1)), again = generated(spheres(3, 1));
  ASSERT_EQ(once.files.size(), again.files.size());
  for (std::size_t k = 0; k < once.files.size(); ++k) {
    EXPECT_EQ(once.files[k].text, again.files[k].text) << once.files[k].name;
  }
}

}  // namespace
}  // namespace mixcmp::test::engine_test

#include <fmt/core.h>

#include <algorithm>

#include "generator/project/builders.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::project {
namespace {

constexpr int choice_bits = 32;  // of a row's choice in the file of vectors

/// The values that the test benches of both kinds of engines have.
Values engine_values(const ProjectSpec& spec) {
  const emit::SignatureEngine& engine = *spec.signature.engine;
  Values values = common_values(spec, "//");
  values["DUT"] = engine.top;
  values["LANES"] = std::to_string(spec.signature.lanes);
  values["ITEM_BITS"] = std::to_string(8 * engine.item_bytes);
  values["FIELD_BITS"] = std::to_string((engine.index_bits + 7) / 8 * 8);
  add_counter_values(spec.signature, engine.ports, values);
  return values;
}

/// "0101": bit v is set where pairs with verdict v are reported.
std::string reported_verdicts(const emit::SignatureEngine& engine) {
  std::string bits;
  for (const Verdict verdict :
       {Verdict::unordered, Verdict::greater, Verdict::equal, Verdict::less}) {
    const auto& report = engine.report;
    const bool is_there =
        std::find(report.begin(), report.end(), to_string(verdict)) != report.end();
    bits += is_there ? '1' : '0';
  }
  return bits;
}

GeneratedFile vector_file(const ProjectSpec& spec, const std::string& description,
                          const std::string& lines) {
  return {.name = fmt::format("testbench/{}_tb.hex", spec.signature.engine->top),
          .text = fmt::format("{}\n// {}\n{}", common_values(spec, "//").at("PROVENANCE"),
                              description, lines)};
}

std::vector<GeneratedFile> pairwise_files(const ProjectSpec& spec,
                                          const emit::PairwiseVectors& vectors) {
  const emit::SignatureEngine& engine = *spec.signature.engine;
  Values values = engine_values(spec);
  const bool bitmap = engine.report_as == scene::ReportForm::bitmap;
  values["FLAG_BITS"] = std::to_string(bitmap ? engine.report_lanes : 0);
  values["COUNT_ONLY"] = engine.report_as == scene::ReportForm::count ? "1" : "0";
  values["STREAMS"] = std::to_string(engine.report_streams);
  values["TDATA_BITS"] = std::to_string(8 * engine.report_bytes);
  values["TARGETS"] = std::to_string(vectors.targets);
  values["ITEMS"] = std::to_string(vectors.items.size());
  values["REPORTED_VERDICTS"] = reported_verdicts(engine);
  std::string lines;
  for (const auto& item : vectors.items) lines += hexadecimal(item) + "\n";
  for (const ResultWord word : vectors.expected) lines += fmt::format("{:02x}\n", word.bits());
  return {file_from(fmt::format("testbench/{}_tb.v", spec.signature.engine->top),
                    "testbench_pairwise.v", values),
          vector_file(spec,
                      "s_axis_tdata of each item, then the word of each pair: "
                      "(0,1), (0,2), ..., (1,2), ...",
                      lines)};
}

/// The lanes that recompute in a row, lane 0 lowest, as hexadecimal digits.
std::string lanes_in_hexadecimal(const std::vector<bool>& lanes) {
  std::vector<std::uint8_t> bytes((lanes.size() + 7) / 8);
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    if (lanes[k]) bytes[k / 8] = static_cast<std::uint8_t>(bytes[k / 8] | 1u << (k % 8));
  }
  return hexadecimal(bytes);
}

std::vector<GeneratedFile> arg_min_files(const ProjectSpec& spec,
                                         const emit::ArgMinVectors& vectors) {
  const emit::SignatureEngine& engine = *spec.signature.engine;
  Values values = engine_values(spec);
  values["CANDIDATES"] = std::to_string(vectors.candidates.size());
  values["ROWS"] = std::to_string(vectors.rows.size());
  values["ROW_BITS"] = std::to_string(8 * engine.row_bytes);
  values["TAG_BITS"] = std::to_string(engine.tag_bits);
  const int row_line_bits = 8 * engine.row_bytes + choice_bits + (spec.signature.lanes + 7) / 8 * 8;
  values["LINE_BITS"] = std::to_string(std::max(row_line_bits, 8 * engine.item_bytes));
  std::string lines;
  for (const auto& candidate : vectors.candidates) lines += hexadecimal(candidate) + "\n";
  for (const emit::RowVector& row : vectors.rows) {
    lines += fmt::format("{}_{:08x}_{}\n", lanes_in_hexadecimal(row.is_recomputed), row.choice,
                         hexadecimal(row.tdata));
  }
  return {file_from(fmt::format("testbench/{}_tb.v", engine.top), "testbench_arg_min.v", values),
          vector_file(spec,
                      "s_candidate_tdata of each candidate; then of each row the lanes that "
                      "recompute _ the choice _ s_axis_tdata",
                      lines)};
}

}  // namespace

std::vector<GeneratedFile> engine_testbench_files(const ProjectSpec& spec) {
  if (const auto* pairs = std::get_if<emit::PairwiseVectors>(&spec.engine_vectors)) {
    return pairwise_files(spec, *pairs);
  }
  const auto* rows = std::get_if<emit::ArgMinVectors>(&spec.engine_vectors);
  MIXCMP_CHECK(rows != nullptr);
  return arg_min_files(spec, *rows);
}

}  // namespace mixcmp::project

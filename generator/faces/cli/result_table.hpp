#pragma once

#include <filesystem>
#include <set>

#include "model/base/common/output_file.hpp"
#include "model/comparison/data/comparisons.hpp"
#include "verilator_tb/verify.hpp"

namespace mixcmp::cli {

/// The verdicts of a run as CSV: index, then i and j of a pair (with their labels where the data
/// has some), verdict ("undecided" where no reference answered), recomputed.
class ResultTable {
public:
  static constexpr std::string_view undecided = "undecided";

  /// Only verdicts in `kept` become rows.
  static Result<ResultTable> open(const std::filesystem::path& path, const data::Comparisons& data,
                                  std::set<std::string> kept);

  void add(const verilator_tb::VerifiedResult& result);
  Result<Done> finish();

private:
  ResultTable(OutputFile file, const data::Comparisons& data, std::set<std::string> kept)
      : file_(std::move(file)), data_(&data), kept_(std::move(kept)) {}

  OutputFile file_;
  const data::Comparisons* data_;
  std::set<std::string> kept_;
};

}  // namespace mixcmp::cli

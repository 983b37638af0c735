#pragma once

#include <filesystem>
#include <fstream>
#include <set>

#include "model/data/comparisons.hpp"
#include "verilator_tb/verify.hpp"

namespace mixcmp::cli {

/// The verdicts of a run as CSV: index, then i and j of a pair (with their labels where the data
/// has some), verdict ("undecided" where no reference answered), recomputed. Written beside the
/// final path and moved there when complete.
class ResultTable {
public:
  static constexpr std::string_view undecided = "undecided";

  /// Only verdicts in `kept` become rows.
  static model::Result<ResultTable> open(const std::filesystem::path& path,
                                         const model::Comparisons& data,
                                         std::set<std::string> kept);

  ResultTable(ResultTable&&) = default;
  ResultTable& operator=(ResultTable&&) = delete;
  /// Of a table that was not finished nothing remains.
  ~ResultTable();

  void add(const tb::VerifiedResult& result);
  model::Result<model::Done> finish();

private:
  ResultTable(std::filesystem::path path, std::ofstream stream, const model::Comparisons& data,
              std::set<std::string> kept);

  std::filesystem::path path_;
  std::ofstream stream_;
  const model::Comparisons* data_;
  std::set<std::string> kept_;
};

}  // namespace mixcmp::cli

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "model/characterise/synthesis.hpp"

namespace mixcmp::characterise {

/// Results of synthesis in a folder: a file for each, named by its job's hash. Machines that share
/// a file system can write it at the same time, which they cannot a database: a file appears whole
/// or not at all, and two runs of one job write the same bytes.
class ResultFolder {
public:
  explicit ResultFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// None where there is no file, or one that a broken disk has cut short: then the job is to be
  /// done again.
  std::optional<SynthesisResult> find(const std::string& hash) const;
  Result<Done> add(const std::string& hash, const SynthesisResult& result,
                   const std::string& tools) const;

  /// The file of a job's result.
  std::filesystem::path file_of(const std::string& hash) const;

private:
  std::filesystem::path folder_;
};

}  // namespace mixcmp::characterise

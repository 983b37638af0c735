#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "generator/synthesis/characterise/synthesis.hpp"

namespace mixcmp::characterise {

/// Results of synthesis in a folder, each in a file named by its job's hash. Machines that share a
/// file system can write to the folder at the same time, which a database would not allow: a file
/// appears whole or not at all, and two runs of one job write the same bytes.
class ResultFolder {
public:
  explicit ResultFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// None if there is no file, or if a broken disk has cut it short: then the job has to be run
  /// again.
  std::optional<SynthesisResult> find(const std::string& hash) const;
  Result<Done> add(const std::string& hash, const SynthesisResult& result,
                   const std::string& tools) const;

  /// The file of a job's result.
  std::filesystem::path file_of(const std::string& hash) const;

private:
  std::filesystem::path folder_;
};

}  // namespace mixcmp::characterise

#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "model/base/common/folder_lock.hpp"
#include "model/base/common/result.hpp"
#include "model/judge/proof/lane_proof.hpp"

namespace mixcmp::proof {

/// A prover that keeps no files. It runs each script once, all of them within `budget_seconds`.
/// Without Gappa every script is unchecked.
class QuickProver {
public:
  explicit QuickProver(double budget_seconds);
  ScriptResult operator()(const std::string& script);
  /// The version of Gappa, or why there is none.
  const Result<std::string>& gappa() const { return version_; }

private:
  Result<std::string> version_;
  double seconds_left_;
  std::map<std::string, ScriptResult> known_;
};

/// Keeps scripts, Coq certificates and verdicts in a directory, each under the hash of its script:
///   HASH.g        the input of Gappa
///   HASH.v        the proof, for coqc with the library of Gappa
///   HASH.verdict  Gappa's version, verdict and output
/// A verdict is written last, and each file is written whole or not at all, so an interrupted run
/// can be resumed. A script that the same version of Gappa has proven is not proven again.
class ProofDirectory {
public:
  /// Makes the directory and locks it until this object is destroyed; `waiting` is called if
  /// another run holds the lock. It is an error if the directory cannot be locked.
  static Result<ProofDirectory> open(const std::filesystem::path& path, double seconds_a_script,
                                     const Waiting& waiting = {});

  ScriptResult operator()(const std::string& script);
  /// The lane's proof for a reader, beside the scripts that it names.
  Result<Done> write_report(const std::string& file_name, const std::string& text) const;

  const std::filesystem::path& path() const { return path_; }
  /// The version of Gappa, or why there is none.
  const Result<std::string>& gappa() const { return version_; }
  int reused() const { return reused_; }
  /// The error of a file that could not be written, if any. Scripts are proven all the same.
  const std::optional<Error>& failure() const { return failure_; }
  /// The first run of Gappa that ended without a verdict, if any.
  const std::optional<Error>& broken() const { return broken_; }

private:
  ProofDirectory(std::filesystem::path path, FolderLock lock, Result<std::string> version,
                 double seconds)
      : path_(std::move(path)),
        lock_(std::move(lock)),
        version_(std::move(version)),
        seconds_(seconds) {}

  bool is_proven(const std::string& hash, const std::string& script) const;
  std::string verdict_text(const std::string& words, const std::string& certificate) const;
  void keep(const std::string& hash, const std::string& script, const std::string& verdict,
            const std::string& certificate);

  std::filesystem::path path_;
  FolderLock lock_;
  Result<std::string> version_;
  double seconds_;
  std::map<std::string, ScriptResult> known_;
  int reused_ = 0;
  std::optional<Error> failure_;
  std::optional<Error> broken_;
};

}  // namespace mixcmp::proof

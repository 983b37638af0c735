#include "model/judge/proof/provers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "model/base/common/check.hpp"
#include "model/base/common/content_hash.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/output_file.hpp"
#include "model/judge/proof/gappa.hpp"

namespace mixcmp::proof {
namespace {

namespace fs = std::filesystem;

/// The beginning of Gappa's error message on one line, without the warnings before it.
std::string first_words(const std::string& message) {
  constexpr std::size_t enough = 160;
  const std::size_t error = message.find("Error: ");
  std::string words;
  for (const char c : message.substr(error == std::string::npos ? 0 : error))
    words += c == '\n' ? ' ' : c;
  while (!words.empty() && words.back() == ' ') words.pop_back();
  return words.size() > enough ? words.substr(0, enough) + "..." : words;
}

ScriptResult to_result(const GappaRun& run, double seconds) {
  switch (run.verdict) {
    case GappaVerdict::proven: return {Outcome::proven, "", ""};
    case GappaVerdict::not_proven: return {Outcome::not_proven, first_words(run.message), ""};
    case GappaVerdict::out_of_time:
      return {Outcome::out_of_time, fmt::format("after {:.3g} s", seconds), ""};
    case GappaVerdict::broken:
      return {Outcome::unchecked, "gappa gives no verdict: " + first_words(run.message), ""};
  }
  MIXCMP_CHECK(false);
}

ScriptResult without_gappa(const Error& error) {
  return {Outcome::unchecked, error.to_string(), ""};
}

Error of_proof_directory(Error error) {
  error.field = "--proof-dir";
  return error;
}

std::string hash_of(const std::string& text) {
  return ContentHash().add(text).hex();
}

}  // namespace

QuickProver::QuickProver(double budget_seconds)
    : version_(gappa_version()), seconds_left_(budget_seconds) {}

ScriptResult QuickProver::operator()(const std::string& script) {
  if (!version_) return without_gappa(version_.error());
  const auto [place, is_new] = known_.try_emplace(script);
  if (!is_new) return place->second;
  if (seconds_left_ <= 0) return place->second = {Outcome::out_of_time, "", ""};
  const auto start = std::chrono::steady_clock::now();
  const GappaRun run = run_gappa(script, Certificate::none, seconds_left_);
  place->second = to_result(run, seconds_left_);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  seconds_left_ -= spent.count();
  return place->second;
}

Result<ProofDirectory> ProofDirectory::open(const fs::path& path, double seconds_a_script,
                                            const Waiting& waiting) {
  auto lock = FolderLock::take(path, waiting);
  if (!lock.ok()) return of_proof_directory(lock.error());
  return ProofDirectory(path, std::move(lock).value(), gappa_version(), seconds_a_script);
}

ScriptResult ProofDirectory::operator()(const std::string& script) {
  const std::string hash = hash_of(script);
  const auto [place, is_new] = known_.try_emplace(hash);
  if (!is_new) return place->second;
  if (!version_) {
    place->second = without_gappa(version_.error());
    keep(hash, script, "", "");
  } else if (is_proven(hash, script)) {
    ++reused_;
    place->second = {Outcome::proven, "", ""};
  } else {
    const GappaRun run = run_gappa(script, Certificate::coq, seconds_);
    place->second = to_result(run, seconds_);
    if (run.verdict == GappaVerdict::broken && !broken_) {
      broken_ = Error{.file = (path_ / (hash + ".g")).string(), .message = place->second.detail};
    }
    const std::string words = fmt::format("{}\n{}", to_string(place->second.outcome), run.message);
    keep(hash, script, verdict_text(words, run.certificate), run.certificate);
  }
  place->second.file = hash + ".g";
  return place->second;
}

std::string ProofDirectory::verdict_text(const std::string& words,
                                         const std::string& certificate) const {
  return fmt::format("gappa {}\ncertificate {}\n{}", *version_, hash_of(certificate), words);
}

bool ProofDirectory::is_proven(const std::string& hash, const std::string& script) const {
  const auto content = [&](const char* extension) { return read_file(path_ / (hash + extension)); };
  const auto kept = content(".g"), certificate = content(".v"), verdict = content(".verdict");
  if (!kept.ok() || !certificate.ok() || !verdict.ok() || *kept != script) return false;
  const std::string proven = fmt::format("{}\n", to_string(Outcome::proven));
  return verdict->starts_with(verdict_text(proven, *certificate));
}

void ProofDirectory::keep(const std::string& hash, const std::string& script,
                          const std::string& verdict, const std::string& certificate) {
  const auto write = [&](const char* extension, const std::string& text) {
    if (failure_) return;
    const Result<Done> written = write_kept_file(path_ / (hash + extension), text);
    if (!written.ok()) failure_ = of_proof_directory(written.error());
  };
  write(".g", script);
  if (!certificate.empty()) write(".v", certificate);
  if (!verdict.empty()) write(".verdict", verdict);
}

Result<Done> ProofDirectory::write_report(const std::string& file_name,
                                          const std::string& text) const {
  const Result<Done> written = write_kept_file(path_ / file_name, text);
  if (!written.ok()) return of_proof_directory(written.error());
  return Done{};
}

}  // namespace mixcmp::proof

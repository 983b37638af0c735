#include "generator/faces/cli/suite_run.hpp"

#include <chrono>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/options.hpp"
#include "generator/present/report/json_text.hpp"
#include "model/base/common/content_hash.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/folder_lock.hpp"
#include "model/base/common/output_file.hpp"
#include "model/base/common/process.hpp"
#include "verilator_tb/report.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A report as `verify --json` prints it; null if the text is none, or if its own statement that it
/// passed contradicts its counts.
Json verify_report(const std::string& text) {
  Json report = Json::parse(text, nullptr, false);
  try {
    const bool passed = verilator_tb::report_in(report).passed();
    return report.at("passed") == passed ? report : Json();
  } catch (const Json::exception&) {
    return {};
  }
}

constexpr const char* key_field = "key";

/// The key in a report's name. The report must contain it, so that a file under another report's
/// name is not taken.
std::string name_key(const fs::path& kept) {
  return kept.stem().string();
}

/// The text of a report for this file.
std::string kept_text(const fs::path& kept, const std::string& report) {
  Json json = {{key_field, name_key(kept)}};
  json.update(Json::parse(report));
  return report::json_text(json);
}

Command verify_command(const SuiteRun& run, const fs::path& work) {
  Command words = {"/proc/self/exe", "verify", "--no-counterexample", "--quiet", "--json"};
  const std::vector<std::string> own = verify_words(run);
  words.insert(words.end(), own.begin(), own.end());
  words.insert(words.end(), {std::string("--work"), work.string()});
  return words;
}

}  // namespace

const char* word_for(Outcome outcome) {
  switch (outcome) {
    case Outcome::passed: return "passed";
    case Outcome::failed: return "FAILED";
    case Outcome::broken: return "not run";
    case Outcome::skipped: return "no time";
  }
  return "";
}

Json report_of(const RunOutcome& outcome) {
  return outcome.report.empty() ? Json() : verify_report(outcome.report);
}

std::vector<std::string> verify_words(const SuiteRun& run) {
  std::vector<std::string> words = {run.scene.string()};
  words.insert(words.end(), run.options.begin(), run.options.end());
  return words;
}

ContentHash hash_of_program() {
  return ContentHash().add(value_or_exit(read_file("/proc/self/exe")));
}

Result<ContentHash> identity(const SuiteRun& run, ContentHash program) {
  SceneOptions options{.scene = run.scene, .settings = {}, .shortcuts = {}};
  for (std::size_t k = 0; k + 1 < run.options.size(); ++k) {
    if (run.options[k] == "--set") options.settings.push_back(run.options[k + 1]);
  }
  const auto scene = scene::load_scene(options.scene, options.settings);
  if (!scene.ok()) return as_user_error(scene.error(), options);
  ContentHash hash = program.add(run.name);
  for (const std::string& word : run.options) hash.add(word);
  for (const fs::path& input : inputs_of(options, *scene)) {
    if (input.empty()) continue;
    MIXCMP_TRY(text, read_file(input));
    hash.add(text);
  }
  return hash;
}

std::string key_of(const ContentHash& identity) {
  return identity.hex().substr(0, 16);
}

RunOutcome kept_outcome(const fs::path& kept) {
  const auto text = read_file(kept);
  if (kept.empty() || !text.ok()) return {};
  Json report = verify_report(*text);
  if (!report.is_object() || report.value(key_field, Json()) != name_key(kept)) return {};
  report.erase(key_field);
  const double seconds = report.value("build_seconds", 0.0) + report.value("run_seconds", 0.0);
  const Outcome outcome = report["passed"] == true ? Outcome::passed : Outcome::failed;
  return {outcome, seconds, report.dump(), kept, ""};
}

RunOutcome verify_run(const SuiteRun& run, const fs::path& work, const fs::path& kept,
                      double seconds) {
  const auto start = std::chrono::steady_clock::now();
  const Result<Captured> captured = capture(verify_command(run, work), {.seconds = seconds});
  RunOutcome outcome;
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!captured.ok()) {
    outcome.outcome = Outcome::broken;
    outcome.error = captured.error().to_string();
    return outcome;
  }
  if (!captured->in_time) return outcome;
  if (!verify_report(captured->output).is_object()) {
    outcome.outcome = Outcome::broken;
    outcome.error = captured->errors.empty() ? how_it_ended(captured->status) : captured->errors;
    return outcome;
  }
  outcome.report = captured->output;
  outcome.outcome = captured->succeeded() ? Outcome::passed : Outcome::failed;
  if (kept.empty()) return outcome;
  value_or_exit(make_writable_folder(kept.parent_path()));
  value_or_exit(write_kept_file(kept, kept_text(kept, captured->output)));
  outcome.report_file = kept;
  return outcome;
}

}  // namespace mixcmp::cli

#include "model/judge/proof/gappa.hpp"

#include <sys/wait.h>

#include <utility>

#include "model/base/common/process.hpp"

namespace mixcmp::proof {
namespace {

constexpr std::uint64_t most_memory_bytes = std::uint64_t{2} << 30;

/// Whether Gappa read the script and found no proof.
bool searched(const std::string& errors) {
  return errors.find("were not satisfied") != std::string::npos ||
         errors.find("no contradiction was found") != std::string::npos;
}

GappaVerdict verdict_of(const Captured& outcome) {
  if (!outcome.in_time) return GappaVerdict::out_of_time;
  if (!WIFEXITED(outcome.status)) return GappaVerdict::broken;
  const bool doubts = outcome.errors.find("are not trivially equal") != std::string::npos;
  if (doubts) return GappaVerdict::not_proven;  // Gappa would use a false hint
  if (WEXITSTATUS(outcome.status) == 0) return GappaVerdict::proven;
  return searched(outcome.errors) ? GappaVerdict::not_proven : GappaVerdict::broken;
}

/// Whether a certificate for Coq is complete.
bool is_whole(std::string_view certificate) {
  const std::size_t last = certificate.find_last_not_of(" \n");
  return last != std::string_view::npos &&
         certificate.substr(0, last + 1).ends_with("End Generated_by_Gappa.");
}

}  // namespace

Result<std::string> gappa_version() {
  MIXCMP_TRY(line, tool_version({"gappa", "--version"}, "gappa"));
  constexpr double patience_seconds = 1;
  const GappaRun false_claim = run_gappa("{ 1 in [2, 3] }", Certificate::none, patience_seconds);
  if (false_claim.verdict == GappaVerdict::broken) {
    return Error{.message = "gappa does not work", .received = false_claim.message};
  }
  if (false_claim.verdict == GappaVerdict::proven) {
    return Error{.message = "gappa proves what is false",
                 .received = "a proof of 1 in [2, 3]",
                 .accepted = "a gappa that refuses that"};
  }
  const std::size_t number = line.find_first_of("0123456789");
  return number == std::string::npos ? line : line.substr(number);
}

GappaRun run_gappa(const std::string& script, Certificate certificate, double seconds) {
  const bool coq = certificate == Certificate::coq;
  Result<Captured> run =
      capture({"gappa", coq ? "-Bcoq" : "-Bnull"},
              {.input = script, .seconds = seconds, .memory_bytes = most_memory_bytes});
  if (!run.ok()) return {GappaVerdict::broken, run.error().to_string(), ""};
  Captured outcome = std::move(run).value();
  outcome.errors.erase(outcome.errors.find_last_not_of('\n') + 1);
  const GappaVerdict verdict = verdict_of(outcome);
  if (verdict == GappaVerdict::broken && outcome.errors.empty()) {
    outcome.errors = "gappa " + how_it_ended(outcome.status) + " and says nothing";
  }
  if (verdict == GappaVerdict::proven && coq && !is_whole(outcome.output)) {
    return {GappaVerdict::broken, "gappa ended well and wrote no whole certificate", ""};
  }
  return {.verdict = verdict,
          .message = std::move(outcome.errors),
          .certificate = verdict == GappaVerdict::proven ? std::move(outcome.output) : ""};
}

}  // namespace mixcmp::proof

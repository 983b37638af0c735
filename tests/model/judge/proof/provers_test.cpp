#include "model/judge/proof/provers.hpp"

#include <fmt/core.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>

#include "model/base/common/file.hpp"
#include "model/judge/proof/gappa.hpp"
#include "model/judge/proof/lane_proof.hpp"
#include "tests/model/judge/proof/proof_support.hpp"
#include "tests/support/scratch_directory.hpp"

/// Tests which proofs are kept, which are done again, and the effect of a missing or hanging Gappa.
namespace mixcmp::test::provers_test {
namespace {

namespace fs = std::filesystem;
using namespace proof;

const std::string truth = "{ x in [0, 1] -> x * x in [0, 1] }\n";
const std::string falsehood = "{ x in [0, 1] -> x * x in [0, 0.5] }\n";
const std::string nonsense = "{ x in [0, 1] -> }\n";

ProofDirectory opened(const fs::path& path, double seconds = 30) {
  return ProofDirectory::open(path, seconds).value();
}

/// The name, without its ending, of the only file with this ending.
std::string only_stem(const fs::path& directory, const std::string& extension) {
  std::vector<std::string> stems;
  for (const auto& entry : fs::directory_iterator(directory)) {
    if (entry.path().extension() == extension) stems.push_back(entry.path().stem().string());
  }
  EXPECT_EQ(stems.size(), 1U) << extension;
  return stems.empty() ? "" : stems.front();
}

void write(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// Changes PATH for one test: it has the test's own program called gappa, or none at all.
class OtherPath {
public:
  explicit OtherPath(const std::string& path) : before_(getenv("PATH")) {
    setenv("PATH", path.c_str(), 1);
  }
  OtherPath(const OtherPath&) = delete;
  OtherPath& operator=(const OtherPath&) = delete;
  ~OtherPath() { setenv("PATH", before_.c_str(), 1); }

private:
  std::string before_;
};

fs::path fake_gappa(const ScratchDirectory& directory, const std::string& commands) {
  const fs::path program = directory.path() / "gappa";
  write(program,
        "#!/bin/sh\nif [ \"$1\" = --version ]; then echo Gappa 9.9; exit 0; fi\n" + commands);
  fs::permissions(program, fs::perms::owner_all);
  return directory.path();
}

class Provers : public WithGappa {
protected:
  ScratchDirectory scratch_;
  fs::path kept_ = scratch_.path() / "a" / "proof";
};

TEST_F(Provers, VerdictsAreGappas) {
  EXPECT_EQ(run_gappa(truth, Certificate::none, 30).verdict, GappaVerdict::proven);
  EXPECT_EQ(run_gappa(falsehood, Certificate::none, 30).verdict, GappaVerdict::not_proven);
  EXPECT_EQ(run_gappa(nonsense, Certificate::none, 30).verdict, GappaVerdict::broken);
  EXPECT_EQ(run_gappa("{ x in [0,1] -> not x in [0,1] }", Certificate::none, 30).verdict,
            GappaVerdict::not_proven);
}

TEST_F(Provers, AHintThatIsNotAnEquationProvesNothing) {
  const std::string script = "{ x in [0, 1] -> x * x in [0, 0.5] }\nx * x -> x / 2;\n";
  EXPECT_EQ(run_gappa(script, Certificate::none, 30).verdict, GappaVerdict::not_proven);
}

TEST_F(Provers, ScriptCertificateAndVerdictAreKept) {
  ProofDirectory directory = opened(kept_);
  const ScriptResult result = directory(truth);
  EXPECT_EQ(result.outcome, proof::Outcome::proven);
  const std::string stem = only_stem(kept_, ".g");
  EXPECT_EQ(result.file, stem + ".g");
  EXPECT_EQ(read_file(kept_ / (stem + ".g")).value(), truth);
  const std::string certificate = read_file(kept_ / (stem + ".v")).value();
  EXPECT_NE(certificate.find("Qed"), std::string::npos);
  const std::string verdict = read_file(kept_ / (stem + ".verdict")).value();
  EXPECT_NE(verdict.find("gappa " + *gappa_version()), std::string::npos);
  EXPECT_NE(verdict.find("\nproven\n"), std::string::npos);
}

TEST_F(Provers, WhatIsNotProvenHasNoCertificate) {
  EXPECT_EQ(opened(kept_)(falsehood).outcome, proof::Outcome::not_proven);
  const std::string stem = only_stem(kept_, ".verdict");
  EXPECT_FALSE(fs::exists(kept_ / (stem + ".v")));
  ProofDirectory again = opened(kept_);
  EXPECT_EQ(again(falsehood).outcome, proof::Outcome::not_proven);
  EXPECT_EQ(again.reused(), 0);
}

TEST_F(Provers, ASecondRunReusesWhatIsProvenAndOnlyThat) {
  opened(kept_)(truth);
  const std::string stem = only_stem(kept_, ".g");
  {
    ProofDirectory again = opened(kept_);
    EXPECT_EQ(again(truth).outcome, proof::Outcome::proven);
    EXPECT_EQ(again.reused(), 1);
  }
  const auto proven_anew = [&] {
    ProofDirectory again = opened(kept_);
    return again(truth).outcome == proof::Outcome::proven && again.reused() == 0;
  };
  write(kept_ / (stem + ".v"), "(* shortened *)");
  EXPECT_TRUE(proven_anew());
  write(kept_ / (stem + ".g"), falsehood);
  EXPECT_TRUE(proven_anew());
  fs::remove(kept_ / (stem + ".verdict"));
  EXPECT_TRUE(proven_anew());
  write(kept_ / (stem + ".verdict"), "gappa 0.1\n");
  EXPECT_TRUE(proven_anew());
  EXPECT_EQ(read_file(kept_ / (stem + ".g")).value(), truth);
}

/// Once all scripts are kept, a run asks the real Gappa nothing.
TEST_F(Provers, AnInterruptedRunResumes) {
  const error::Lane lane = lane_of(sphere_graph(), {}).value();
  int scripts = 0;
  {
    ProofDirectory directory = opened(kept_);
    const Prove until_interrupted = [&](const std::string& script) {
      return ++scripts <= 4 ? directory(script) : ScriptResult{proof::Outcome::unchecked, "", ""};
    };
    prove_lane(lane, until_interrupted, Effort::whole);
  }
  {
    ProofDirectory directory = opened(kept_);
    EXPECT_TRUE(prove_lane(lane, std::ref(directory), Effort::whole).machine_checked());
    EXPECT_EQ(directory.reused(), 4);
  }
  ProofDirectory complete = opened(kept_);
  EXPECT_TRUE(prove_lane(lane, std::ref(complete), Effort::whole).machine_checked());
  // The scripts are one rounding in two binades, seven cases of f and one of g; squares and their
  // sums have one sign.
  EXPECT_EQ(complete.reused(), 13);
}

TEST_F(Provers, NothingUnfinishedIsLeft) {
  opened(kept_)(truth);
  for (const auto& entry : fs::directory_iterator(kept_)) {
    EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << entry.path();
  }
}

TEST_F(Provers, ADirectoryThatCannotBeIsAnError) {
  write(scratch_.path() / "file", "");
  const auto directory = ProofDirectory::open(scratch_.path() / "file" / "proof", 1);
  ASSERT_FALSE(directory.ok());
  EXPECT_EQ(directory.error().field, "--proof-dir");
}

TEST_F(Provers, AFileThatCannotBeWrittenIsAnErrorAndNoProofLess) {
  ProofDirectory directory = opened(kept_);
  fs::remove_all(kept_);
  EXPECT_EQ(directory(truth).outcome, proof::Outcome::proven);
  EXPECT_TRUE(directory.failure().has_value());
}

TEST(ProversWithoutGappa, LeaveEverythingUnchecked) {
  ScratchDirectory scratch;
  const OtherPath path(scratch.path().string());
  EXPECT_FALSE(gappa_version());
  QuickProver quick(5);
  EXPECT_EQ(quick(truth).outcome, proof::Outcome::unchecked);
  ProofDirectory directory = opened(scratch.path() / "proof");
  EXPECT_EQ(directory(truth).outcome, proof::Outcome::unchecked);
  EXPECT_EQ(only_stem(scratch.path() / "proof", ".g") + ".g", directory(truth).file);
}

TEST(ProversWithAFake, AHangingGappaIsStoppedInTime) {
  ScratchDirectory scratch;
  const std::string search = getenv("PATH");
  const OtherPath path(fake_gappa(scratch, "exec sleep 60\n").string() + ":" + search);
  EXPECT_EQ(gappa_version().value(), "9.9");
  QuickProver quick(0.2);
  EXPECT_EQ(quick(truth).outcome, proof::Outcome::out_of_time);
  EXPECT_EQ(quick(falsehood).outcome, proof::Outcome::out_of_time);  // no budget left
  ProofDirectory directory = opened(scratch.path() / "proof", 0.2);
  EXPECT_EQ(directory(truth).outcome, proof::Outcome::out_of_time);
}

TEST(ProversWithAFake, ACrashIsNoProof) {
  ScratchDirectory scratch;
  const std::string search = getenv("PATH");
  const OtherPath path(fake_gappa(scratch, "kill -9 $$\n").string() + ":" + search);
  EXPECT_EQ(run_gappa(truth, Certificate::coq, 30).verdict, GappaVerdict::broken);
  QuickProver quick(5);
  EXPECT_NE(quick(truth).outcome, proof::Outcome::proven);
}

TEST(ProversWithAFake, ALaneWhoseGappaNeverAnswersIsNotRefused) {
  ScratchDirectory scratch;
  const std::string search = getenv("PATH");
  const OtherPath path(fake_gappa(scratch, "exec sleep 60\n").string() + ":" + search);
  QuickProver quick(0.2);
  const LaneProof proof =
      prove_lane(lane_of(sphere_graph(), {}).value(), std::ref(quick), Effort::operations);
  EXPECT_FALSE(proof.refused() || proof.machine_checked());
  EXPECT_NE(proof.verdict().find("not machine-checked: out of time"), std::string::npos)
      << proof.verdict();
}

TEST(ProversWithAFake, MuchOutputOnBothStreamsPasses) {
  ScratchDirectory scratch;
  const std::string search = getenv("PATH");
  const std::string ending = "echo End Generated_by_Gappa.\n";
  const std::string much = "head -c 300000 /dev/zero | tr '\\0' x";
  const OtherPath path(fake_gappa(scratch, much + " >&2\n" + much + "\n" + ending).string() + ":" +
                       search);
  const GappaRun run = run_gappa(truth, Certificate::coq, 30);
  EXPECT_EQ(run.verdict, GappaVerdict::proven);
  EXPECT_GT(run.certificate.size(), 300000U);
  EXPECT_EQ(run.message.size(), 300000U);
}

TEST(ProversWithAFake, AProofWithoutItsCertificateIsNone) {
  ScratchDirectory scratch;
  const std::string search = getenv("PATH");
  for (const char* certificate : {"", "echo 'Section Generated_by_Gappa.'; "}) {
    const std::string commands =
        fmt::format("grep -q '1 in' && {{ echo some were not satisfied >&2; exit 1; }}\n{}exit 0\n",
                    certificate);
    const OtherPath path(fake_gappa(scratch, commands).string() + ":" + search);
    ASSERT_TRUE(gappa_version());
    EXPECT_EQ(run_gappa(truth, Certificate::coq, 30).verdict, GappaVerdict::broken);
    ProofDirectory directory = opened(scratch.path() / "proof");
    EXPECT_NE(directory(truth).outcome, proof::Outcome::proven);
  }
}

TEST(ProversWithAFake, OneThatProvesEverythingIsNotBelieved) {
  ScratchDirectory scratch;
  const std::string search = getenv("PATH");
  const OtherPath path(fake_gappa(scratch, "exit 0\n").string() + ":" + search);
  ASSERT_FALSE(gappa_version());
  EXPECT_EQ(gappa_version().error().message, "gappa proves what is false");
  QuickProver quick(5);
  EXPECT_EQ(quick(truth).outcome, proof::Outcome::unchecked);
}

/// A crash is no refusal of a false claim.
TEST(ProversWithAFake, OneThatCrashesIsNotBelieved) {
  ScratchDirectory scratch;
  const std::string search = getenv("PATH");
  const std::string commands = "grep -q '1 in' && kill -SEGV $$\nexit 0\n";
  const OtherPath path(fake_gappa(scratch, commands).string() + ":" + search);
  ASSERT_FALSE(gappa_version());
  EXPECT_EQ(gappa_version().error().message, "gappa does not work");
}

TEST(ProversWithAFake, OneThatCannotReadScriptsRefusesNothing) {
  ScratchDirectory scratch;
  const std::string search = getenv("PATH");
  const std::string complaint = "echo 'Error: syntax error' >&2; exit 1\n";
  const OtherPath path(fake_gappa(scratch, complaint).string() + ":" + search);
  QuickProver quick(5);
  const ScriptResult result = quick(truth);
  EXPECT_EQ(result.outcome, proof::Outcome::unchecked);
  EXPECT_NE(result.detail.find("syntax error"), std::string::npos) << result.detail;
}

}  // namespace
}  // namespace mixcmp::test::provers_test

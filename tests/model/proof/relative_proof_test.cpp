#include <fmt/core.h>

#include "model/proof/report.hpp"
#include "tests/model/proof/proof_support.hpp"

namespace mixcmp::test {
namespace {
using namespace model::proof;

TEST_F(WithGappa, Scratch) {
  for (const auto& [f, g] :
       std::vector<std::pair<std::string, std::string>>{{"(a-b)^2+(c-d)^2", "(e+h)^2"},
                                                        {"a*b+c*d", "sqrt(a)*e/h"},
                                                        {"min(a,b)*c", "max(a*b,c)+abs(d)"},
                                                        {"0.1*a+4*b", "abs(-a*0.3)"},
                                                        {"a/(b+0.5)", "sqrt(c*d+a)"},
                                                        {"a > 1 ? 1 : 1", "1"}}) {
    if (f.find('?') != std::string::npos) continue;
    const auto graph = graph_of(f, g);
    for (const auto rounding : {model::Rounding::nearest_even, model::Rounding::toward_zero}) {
      const auto lane = lane_of(graph, {.rounding = rounding, .ranges = nonnegative_ranges(graph)});
      ASSERT_TRUE(lane.ok()) << lane.error().to_string();
      for (const auto effort : {Effort::whole, Effort::operations}) {
        auto quick = patient_prover();
        const auto proof = prove_lane(*lane, std::ref(quick), effort);
        fmt::print("{} : {}\n{}", f, g, to_text(proof, "x"));
      }
    }
  }
}
}  // namespace
}  // namespace mixcmp::test

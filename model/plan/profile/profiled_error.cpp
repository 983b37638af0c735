#include "model/plan/profile/profiled_error.hpp"

#include <algorithm>
#include <vector>

#include "model/comparison/data/permutation.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/judge/golden/true_values.hpp"
#include "model/plan/profile/largest_relative_error.hpp"

namespace mixcmp::profile {

error::ProfiledError profile_error(const Graph& graph, const TypedGraph& lane,
                                   const data::Comparisons& data, std::uint64_t sample_count,
                                   std::uint64_t seed) {
  const data::Permutation permutation(data.size(), seed);
  const std::uint64_t count = std::min(sample_count, data.size());
  golden::TrueValues truth(graph, {graph.f(), graph.g()});
  LargestRelativeError f(lane.arithmetic.format), g(lane.arithmetic.format);
  std::vector<Bits> operands(data.input_count());
  error::ProfiledError profiled;
  for (std::uint64_t index = 0; index < count; ++index) {
    data.fetch(permutation(index), operands);
    if (!truth.compute(lane.input_format, operands)) continue;
    const std::vector<golden::Rounded> computed = golden::evaluate(lane, operands);
    f.measure(computed[lane.f()].bits, truth.f());
    g.measure(computed[lane.g()].bits, truth.g());
    ++profiled.comparisons;
  }
  profiled.f = f.value();
  profiled.g = g.value();
  profiled.f_unbounded = f.unbounded();
  profiled.g_unbounded = g.unbounded();
  return profiled;
}

}  // namespace mixcmp::profile

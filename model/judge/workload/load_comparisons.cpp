#include "model/judge/workload/load_comparisons.hpp"

#include "model/base/common/result.hpp"
#include "model/comparison/data/load_tables.hpp"
#include "model/judge/workload/compare_by_reference.hpp"

namespace mixcmp::workload {
namespace {

/// Makes the comparisons report its progress.
data::CompareItems with_progress(data::CompareItems compare, const ComparisonProgress& progress) {
  if (!progress) return compare;
  return [compare = std::move(compare), progress, done = std::uint64_t{0}](
             const data::Comparisons& data, std::span<const data::Items> items,
             std::span<std::uint8_t> greater) mutable {
    compare(data, items, greater);
    done += items.size();
    progress(done, data.size());
  };
}

Result<data::Comparisons> arrange(const scene::Scene& scene, std::vector<data::Table> tables,
                                  const ComparisonProgress& progress) {
  using data::Comparisons;
  const std::vector<std::string>& inputs = scene.graph.inputs();
  data::Table& first = tables.front();
  data::Table& second = tables.back();
  switch (scene.data->pairing) {
    case data::Pairing::rows: return Comparisons::rows(std::move(first), inputs);
    case data::Pairing::all: return Comparisons::all_pairs(std::move(first), inputs);
    case data::Pairing::cross:
      return Comparisons::cross(std::move(first), std::move(second), inputs);
    case data::Pairing::arg_min: break;
  }
  const data::CompareItems compare =
      compare_by_reference(reference_graph(scene.graph, scene.reference));
  return Comparisons::arg_min(std::move(first), std::move(second), inputs,
                              with_progress(compare, progress));
}

}  // namespace

Result<data::Comparisons> load_comparisons(const scene::Scene& scene,
                                           const ComparisonProgress& progress) {
  if (!scene.data) {
    return Error{.file = scene.path.string(),
                 .field = "data",
                 .message = "the scene has no data",
                 .received = "nothing",
                 .accepted = "a section [data]"};
  }
  MIXCMP_TRY(tables, data::load_tables(*scene.data, scene.graph.inputs(), scene.reference.format));
  Result<data::Comparisons> comparisons = arrange(scene, std::move(tables), progress);
  if (!comparisons.ok()) return data::with_place(*scene.data, comparisons.error());
  return comparisons;
}

}  // namespace mixcmp::workload

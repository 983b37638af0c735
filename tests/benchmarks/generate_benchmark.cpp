#include <benchmark/benchmark.h>

#include "generator/hardware/emit/system.hpp"
#include "tests/support/scratch_directory.hpp"
#include "tests/support/sphere.hpp"

/// The paper's largest system: from a design to files on disk. Said to take under a second.
namespace mixcmp {
namespace {

void generate_108_lanes_3_references(benchmark::State& state) {
  const design::Design design =
      test::sphere_design(test::format("s17e8"), test::format("s53e8"), 108, 3);
  test::ScratchDirectory scratch;
  for (auto unused : state) {
    const auto system = emit::generate_system(design, "mixcmp generate scene.toml");
    if (!emit::write_system(*system, scratch.path() / "out").ok()) {
      state.SkipWithError("cannot be written");
    }
  }
}
BENCHMARK(generate_108_lanes_3_references)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mixcmp

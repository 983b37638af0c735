#include "generator/faces/cli/suite_file.hpp"
#include "tests/fuzz/input.hpp"

using namespace mixcmp;

/// A suite of runs of `mixcmp verify`; each run has a name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto suite = cli::read_suite(test::file_of(data, size));
  if (!test::is_read(suite)) return 0;
  for (const cli::SuiteRun& run : suite->runs) test::require(!run.name.empty());
  return 0;
}

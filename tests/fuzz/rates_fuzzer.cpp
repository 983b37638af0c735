#include "model/plan/optimise/rates.hpp"
#include "tests/fuzz/input.hpp"

using namespace mixcmp;

/// Recomputation rates, as `mixcmp profile` writes them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::is_read(optimise::Rates::read(test::file_of(data, size)));
  return 0;
}

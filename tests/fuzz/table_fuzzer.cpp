#include "model/cost/measured/measurement.hpp"
#include "tests/fuzz/input.hpp"

using namespace mixcmp;

/// A table of measured areas and clocks.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::is_read(measured::read_characterisation(test::file_of(data, size)));
  return 0;
}

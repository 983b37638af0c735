#include "generator/synthesis/characterise/vendor_report.hpp"
#include "tests/fuzz/input.hpp"

using namespace mixcmp;

/// A report of Vivado or Quartus: areas by instance, or a clock.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::is_read(characterise::read_vendor_report(test::file_of(data, size)));
  return 0;
}

#include "model/cost/devices/device_file.hpp"
#include "tests/fuzz/input.hpp"

using namespace mixcmp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::is_read(devices::read_device(test::text_of(data, size), "device.toml"));
  return 0;
}

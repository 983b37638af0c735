#include <nlohmann/json.hpp>

#include "generator/synthesis/characterise/mapped_area.hpp"
#include "tests/fuzz/input.hpp"

using namespace mixcmp;

/// The statistics that Yosys writes in JSON.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto json = nlohmann::json::parse(data, data + size, nullptr, false);
  static const auto device = devices::find_device("artix7-200t").value();
  if (!json.is_discarded()) test::is_read(characterise::area_of_statistics(json, device));
  return 0;
}

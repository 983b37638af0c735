#pragma once

#include <filesystem>
#include <string>

#include "verilator_tb/verify.hpp"

namespace mixcmp::test {

/// The route of comparisons that a lane of the fake system does not decide; a value is its ROUTE.
enum class FakeRoute {
  reference = 0,
  in_order = 1,
  none = 2,
};

struct FakeSystem {
  std::string name;  ///< of its folder
  int lanes = 2;
  int tag_bits = 12;
  FakeRoute route = FakeRoute::reference;
  scene::OperandStore operands = scene::OperandStore::carried;
};

/// The folder of all fake systems and of their builds, kept between runs.
std::filesystem::path fake_work_dir();

/// Writes the system with its signature; the folder it is in.
std::filesystem::path write_fake_system(const FakeSystem& fake);

/// The design that the fake system implements.
design::Design fake_design(const FakeSystem& fake);

/// Pairs of positive binary16 numbers; about half of them too close for a lane.
data::Comparisons fake_comparisons(std::size_t count);

}  // namespace mixcmp::test

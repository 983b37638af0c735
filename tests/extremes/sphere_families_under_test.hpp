#pragma once

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "model/comparison/data/sphere_family.hpp"
#include "model/judge/golden/arithmetic.hpp"

namespace mixcmp::test {

inline data::Table family_of(const std::string& name, FloatFormat format, std::uint64_t count,
                             std::uint64_t seed = 1) {
  auto table = data::sphere_family({.name = name, .count = count, .seed = seed}, format);
  EXPECT_TRUE(table.ok()) << (table.ok() ? "" : table.error().to_string());
  return table.ok() ? std::move(table).value() : data::Table{.format = format};
}

inline std::vector<Bits> row_of(const data::Table& table, std::size_t row) {
  const auto first = table.values.begin() + static_cast<long>(row * table.columns.size());
  return {first, first + static_cast<long>(table.columns.size())};
}

}  // namespace mixcmp::test

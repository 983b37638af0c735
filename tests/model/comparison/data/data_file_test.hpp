#pragma once

#include <gtest/gtest.h>

#include <fstream>

#include "model/base/number/decimal.hpp"
#include "model/comparison/data/comparisons.hpp"
#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test {

/// Writes data files and checks the results of their readers.
class DataFileTest : public testing::Test {
protected:
  const std::filesystem::path& write(const std::string& bytes) {
    std::filesystem::remove(path_);  // truncating a file in place waits for the disk
    std::ofstream(path_, std::ios::binary) << bytes;
    return path_;
  }

  static std::string text(const data::Table& table, std::size_t row, std::size_t column) {
    return to_text(table.format, table.at(row, column));
  }

  /// The error without the file's name, which it must have.
  std::string told(const Result<data::Table>& table) const {
    EXPECT_FALSE(table.ok());
    if (table.ok()) return {};
    EXPECT_EQ(table.error().file, path_.string());
    return table.error().to_string().substr(path_.string().size());
  }

  FloatFormat binary64_ = FloatFormat::parse("binary64").value();
  FloatFormat binary16_ = FloatFormat::parse("binary16").value();
  test::ScratchDirectory directory_;
  std::filesystem::path path_ = directory_.path() / "data";
};

}  // namespace mixcmp::test

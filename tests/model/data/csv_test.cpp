#include "model/data/csv.hpp"

#include <random>

#include "tests/model/data/data_file_test.hpp"

namespace mixcmp::model {
namespace {

using CsvTest = DataFileTest;
const std::vector<std::string> xy = {"x", "y"};

TEST_F(CsvTest, ReadsColumnsByNameAndLeavesOthersAlone) {
  const auto table =
      read_csv(write("name,y,x\nfirst, 0.1 ,-2\n\"a, \"\"b\"\"\nc\",3e-2,0x1p4\n"), binary64_, xy);
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  ASSERT_EQ(table->rows(), 2U);
  EXPECT_EQ(text(*table, 0, 0), "-2");
  EXPECT_EQ(text(*table, 0, 1), "0.1");
  EXPECT_EQ(text(*table, 1, 0), "16");
  EXPECT_EQ(text(*table, 1, 1), "0.03");
}

TEST_F(CsvTest, ToleratesCarriageReturnsByteOrderMarkAndEmptyLines) {
  const auto table = read_csv(write("\xef\xbb\xbfx,\"y\"\r\n\r\n1,\"2\"\r\n\n3,4"), binary64_, xy);
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  ASSERT_EQ(table->rows(), 2U);
  EXPECT_EQ(text(*table, 0, 1), "2");
  EXPECT_EQ(text(*table, 1, 1), "4");
}

TEST_F(CsvTest, InfinitiesAndNansAreData) {
  const auto table = read_csv(write("x,y\n-inf,nan\n"), binary64_, xy);
  ASSERT_TRUE(table.ok());
  EXPECT_EQ(text(*table, 0, 0), "-inf");
  EXPECT_EQ(text(*table, 0, 1), "nan");
}

TEST_F(CsvTest, RoundsOnce) {
  // Between 1 and its successor in binary16, above the middle by less than binary64 can see.
  const auto table =
      read_csv(write("x,y\n1.000488281250000000000000001,1.00048828125\n"), binary16_, xy);
  ASSERT_TRUE(table.ok());
  EXPECT_EQ(table->at(0, 0), Bits{0x3c01});
  EXPECT_EQ(table->at(0, 1), Bits{0x3c00});
}

TEST_F(CsvTest, MistakesNameLineAndColumn) {
  const auto error = [&](const std::string& bytes) {
    return told(read_csv(write(bytes), binary16_, xy));
  };
  EXPECT_EQ(error(""),
            ": no header: received an empty file; accepted a first line that names the columns");
  EXPECT_EQ(error("yy,x\n1,2\n"),
            ":1: y: no such column: received nothing; accepted yy (the nearest), x");
  EXPECT_EQ(error("\nx,y,x\n1,2,3\n"),
            ":2: x: two columns of this name: received 2 of them; accepted one");
  EXPECT_EQ(error("x,y\n1,2\n1,2,3\n"),
            ":3: wrong number of fields: received 3; accepted 2, as in the first line");
  EXPECT_EQ(error("x,y\n\"1\n\",2\n3,4\n").substr(0, 17), ":2: x: not a numb");
  EXPECT_EQ(error("a,x,y\n\"1\n\",2,3\n5,6,four\n").substr(0, 35),
            ":4: y: not a number: received \"four");
  EXPECT_EQ(error("x,y\n1,\n").substr(0, 32), ":2: y: not a number: received \"\"");
  EXPECT_EQ(error("x,y\n1,70000\n"),
            ":2: y: beyond the largest number of s11e5: received \"70000\"; accepted a smaller "
            "number, or a reference format with more exponent bits");
  EXPECT_EQ(error("x,y\n1,\"2\n3,4\n"),
            ":2: a quoted field is not closed: received the end of the file; accepted a closing "
            "'\"'");
  EXPECT_EQ(error("x,y\n1,\"2\"3\n"),
            ":2: text after a quoted field: received '3'; accepted ',' or the end of the line; "
            "quotes inside quotes doubled");
}

TEST_F(CsvTest, MutatedFilesGiveErrorsNotCrashes) {
  const std::string good = "name,y,x\n\"a \"\"b\"\"\",0.1,-2\r\nc,3e-2,0x1p4\nd,inf,nan\n";
  std::mt19937 random(1);
  int errors = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string bytes = good;
    for (auto changes = 1 + random() % 3; changes > 0; --changes) {
      bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
    }
    bytes.resize(random() % 4 == 0 ? random() % bytes.size() : bytes.size());
    errors += !read_csv(write(bytes), binary64_, xy).ok();
  }
  EXPECT_GT(errors, 500);
}

}  // namespace
}  // namespace mixcmp::model

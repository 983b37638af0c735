#include "model/comparison/data/csv.hpp"

#include <fmt/core.h>

#include <random>

#include "tests/model/comparison/data/data_file_test.hpp"

namespace mixcmp::test::csv_test {
namespace {

using CsvTest = DataFileTest;
const std::vector<data::WantedColumn> xy =
    data::columns_by_name(std::vector<std::string>{"x", "y"});

TEST_F(CsvTest, ReadsColumnsByNameAndLeavesOthersAlone) {
  const auto table = data::read_csv(
      write("name,y,x\nfirst, 0.1 ,-2\n\"a, \"\"b\"\"\nc\",3e-2,0x1p4\n"), binary64_, xy);
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  ASSERT_EQ(table->rows(), 2U);
  EXPECT_EQ(text(*table, 0, 0), "-2");
  EXPECT_EQ(text(*table, 0, 1), "0.1");
  EXPECT_EQ(text(*table, 1, 0), "16");
  EXPECT_EQ(text(*table, 1, 1), "0.03");
}

TEST_F(CsvTest, ToleratesCarriageReturnsByteOrderMarkAndEmptyLines) {
  const auto table =
      data::read_csv(write("\xef\xbb\xbfx,\"y\"\r\n\r\n1,\"2\"\r\n\n3,4"), binary64_, xy);
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  ASSERT_EQ(table->rows(), 2U);
  EXPECT_EQ(text(*table, 0, 1), "2");
  EXPECT_EQ(text(*table, 1, 1), "4");
}

TEST_F(CsvTest, InfinitiesAndNansAreData) {
  const auto table = data::read_csv(write("x,y\n-inf,nan\nInfinity,NaN\n"), binary64_, xy);
  ASSERT_TRUE(table.ok());
  EXPECT_EQ(text(*table, 1, 0), "inf");
  EXPECT_EQ(text(*table, 1, 1), "nan");
  EXPECT_EQ(text(*table, 0, 0), "-inf");
  EXPECT_EQ(text(*table, 0, 1), "nan");
}

TEST_F(CsvTest, RoundsOnce) {
  // The number lies between 1 and its successor in binary16, above the middle by less than binary64
  // can see.
  const auto table =
      data::read_csv(write("x,y\n1.000488281250000000000000001,1.00048828125\n"), binary16_, xy);
  ASSERT_TRUE(table.ok());
  EXPECT_EQ(table->at(0, 0), Bits{0x3c01});
  EXPECT_EQ(table->at(0, 1), Bits{0x3c00});
}

TEST_F(CsvTest, CountsNumbersThatBecomeZero) {
  const auto table =
      data::read_csv(write("x,y\n0,-0.00e9\n1e-40,0x0p9\n-0x0.8p-99,1e-7\n"), binary16_, xy);
  ASSERT_TRUE(table.ok());
  EXPECT_EQ(table->lost.count, 2U);
  EXPECT_EQ(table->lost.first, "1e-40 in data, line 3, x, read in s11e5");
}

TEST_F(CsvTest, CountsWholeNumbersThatItRounds) {
  const auto table =
      data::read_csv(write("x,y\n9007199254740993,9007199254740992\n0.1,1e300\n-9007199254740995,"
                           " +100000000000000000000\n"),
                     binary64_, xy);
  ASSERT_TRUE(table.ok());
  EXPECT_EQ(table->lost.count, 2U);
  EXPECT_EQ(table->lost.first, "9007199254740993 in data, line 2, x, read in s53e11");
  const auto coarse = data::read_csv(write("x,y\n-2048,2049.000\n4100.0,4099\n"), binary16_, xy);
  ASSERT_TRUE(coarse.ok());
  EXPECT_EQ(coarse->lost.count, 2U);
  EXPECT_EQ(coarse->lost.first, "2049.000 in data, line 2, y, read in s11e5");
}

/// E4M3 has no infinities and no number above 448; the NaN that is written is none that is lost.
TEST_F(CsvTest, CountsNumbersThatBecomeNan) {
  const FloatFormat e4m3 = FloatFormat::e4m3();
  const std::vector<data::WantedColumn> wanted = {{.name = "x", .column = "x", .rounded_to = e4m3},
                                                  {.name = "y", .column = "y"}};
  const auto table = data::read_csv(
      write("x,y\n464.0,1\n-464.5,2\ninf,3\n nan,4\nNaN,5\n-1e9,6\n-448,inf\n0x1p-9,8\n"),
      binary64_, wanted);
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  const std::vector<std::string> expected = {"448", "nan", "nan",  "nan",
                                             "nan", "nan", "-448", "0.001953125"};
  for (std::size_t row = 0; row < expected.size(); ++row) {
    EXPECT_EQ(text(*table, row, 0), expected[row]) << row;
  }
  EXPECT_EQ(text(*table, 6, 1), "inf");
  EXPECT_EQ(table->lost.count, 4U) << "464 as well, as a whole number that is rounded";
  EXPECT_EQ(table->lost.first, "464.0 in data, line 2, x, read in E4M3");
}

TEST_F(CsvTest, MistakesNameLineAndColumn) {
  const auto error = [&](const std::string& bytes) {
    return told(data::read_csv(write(bytes), binary16_, xy));
  };
  EXPECT_EQ(error(""),
            ": no header: received an empty file; accepted a first line that names the columns");
  EXPECT_EQ(error("yy,x\n1,2\n"),
            ":1: y: no such column: received nothing; accepted yy (the nearest), x");
  EXPECT_EQ(error("\nx,y,x\n1,2,3\n"),
            ":2: x: two columns of this name: received 2 of them; accepted one, or the column's "
            "number in place of its name, here 0 or 2");
  EXPECT_EQ(error("x,y\n1,2\n1,2,3\n"),
            ":3: wrong number of fields: received 3; accepted 2, as in the first line");
  EXPECT_EQ(error("x,y\n\"1\n\",2\n3,4\n").substr(0, 17), ":2: x: not a numb");
  EXPECT_EQ(error("a,x,y\n\"1\n\",2,3\n5,6,four\n").substr(0, 35),
            ":4: y: not a number: received \"four");
  EXPECT_EQ(error("x,y\n1,\n").substr(0, 32), ":2: y: not a number: received \"\"");
  EXPECT_EQ(error("x,y\n1,70000\n"),
            ":2: y: beyond the largest number of s11e5: received \"70000\"; accepted a smaller "
            "number, or a format with more exponent bits");
  EXPECT_EQ(error("x,y\n1,\"2\n3,4\n"),
            ":2: a quoted field is not closed: received the end of the file; accepted a closing "
            "'\"'");
  EXPECT_EQ(error("x,y\n1,\"2\"3\n"),
            ":2: text after a quoted field: received '3'; accepted ',' or the end of the line; "
            "quotes inside quotes doubled");
}

TEST_F(CsvTest, ColumnsGoByNumberToo) {
  const std::vector<data::WantedColumn> wanted = {{.name = "p_0",
                                                   .column = std::uint64_t{2},
                                                   .field = "data.columns.p",
                                                   .place = {"s.toml", 9}},
                                                  {.name = "r", .column = "x"}};
  const auto table = data::read_csv(write("x,y,x2\n\n1,2,3\n"), binary64_, wanted);
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  EXPECT_EQ(table->columns, (std::vector<std::string>{"p_0", "r"}));
  EXPECT_EQ(text(*table, 0, 0), "3");
  EXPECT_EQ(text(*table, 0, 1), "1");
  EXPECT_EQ(table->origins[0].number, 2U);
  EXPECT_EQ(table->origins[0].name, "x2");
  EXPECT_EQ(table->lines, std::vector<int>{3});
  EXPECT_EQ(table->label(0), "of line 3");
  EXPECT_EQ(data::read_csv(write("x,y\n1,2\n"), binary64_, wanted).error().to_string(),
            "s.toml:9: data.columns.p: no column of this number in data: received 2; accepted "
            "0..1, counted from 0");
  EXPECT_EQ(told(data::read_csv(write("x,y,0.5\n1,2,3\n"), binary64_, wanted)),
            ":1: the first line seems to hold numbers, not names of columns: received \"0.5\" in "
            "column 2; accepted a first line that names the columns; in the scene, the name of a "
            "column that is called like a number");
}

TEST_F(CsvTest, OtherSeparatorsAndMissingHeadersAreTold) {
  const auto error = [&](const std::string& bytes) {
    return told(data::read_csv(write(bytes), binary64_, xy));
  };
  const auto seems = [](const std::string& what) {
    return ":1: x: no such column: received a first line that seems to be " + what +
           "; accepted a first line that names the columns, with ',' between them";
  };
  EXPECT_EQ(error("x;y\n1;2\n"), seems("separated by ';'"));
  EXPECT_EQ(error("x;y\n1,5;2,5\n"), seems("separated by ';'"));
  EXPECT_EQ(error("x\ty\n1\t2\n"), seems("separated by tabs"));
  EXPECT_EQ(error("x y\n1 2\n"), seems("separated by blanks"));
  EXPECT_EQ(error("1,2\n3,4\n"), seems("numbers"));
  EXPECT_EQ(error(" \n1\n"), seems("blank"));
  EXPECT_EQ(error("# made by hand\nx,y\n1,2\n"), seems("a comment"));
  EXPECT_EQ(error("x,y\r1,2\r"),
            ":1: y: no such column: received a first line that seems to be "
            "several lines that end in CR without LF; accepted a first line that "
            "names the columns, with ',' between them");
  EXPECT_EQ(error(std::string("\xff\xfex\0,\0y\0\n\0", 10)), seems("text in UTF-16, or no text"));
  EXPECT_EQ(error("x,y\n1,2\n# the end\n"),
            ":3: wrong number of fields: received 1, the line seems to be a comment; accepted 2, "
            "as in the first line");
  EXPECT_EQ(error("x,y\n1;2\n"),
            ":2: wrong number of fields: received 1, the line seems to be separated by ';'; "
            "accepted 2, as in the first line");
}

TEST_F(CsvTest, NamesAndMessagesAreUtf8) {
  const std::vector<data::WantedColumn> first = {{.name = "x", .column = std::uint64_t{0}}};
  const auto table = data::read_csv(write("\xe9\xcf\x80\x1b[31m,y\n1,2\n"), binary64_, first);
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  EXPECT_EQ(table->origins[0].name, "?\xcf\x80?[31m");
  EXPECT_EQ(told(data::read_csv(path_, binary64_, xy)).substr(0, 71),
            ":1: x: no such column: received nothing; accepted y (the nearest), ?\xcf\x80?");
  EXPECT_EQ(told(data::read_csv(write("\"a\nb\",y\n1,2\n"), binary64_, xy)),
            ":1: x: no such column: received nothing; accepted y (the nearest), a?b");
}

TEST_F(CsvTest, AMessageOfAWideFileIsShort) {
  std::string header;
  for (int column = 0; column < 200'000; ++column) header += fmt::format("c{},", column);
  const std::string text = told(data::read_csv(write(header + "y\n"), binary64_, xy));
  EXPECT_LT(text.size(), 1000U);
  EXPECT_NE(text.find(", and 199961 more"), std::string::npos) << text;
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
    errors += !data::read_csv(write(bytes), binary64_, xy).ok();
  }
  EXPECT_GT(errors, 500);
}

}  // namespace
}  // namespace mixcmp::test::csv_test

#include "model/comparison/data/npy.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <random>

#include "tests/model/comparison/data/data_file_test.hpp"

namespace mixcmp::test::npy_test {
namespace {

using NpyTest = DataFileTest;
const std::vector<data::WantedColumn> xy = {{.name = "x", .column = std::uint64_t{0}},
                                            {.name = "y", .column = std::uint64_t{1}}};
const std::vector<data::WantedColumn> fields =
    data::columns_by_name(std::vector<std::string>{"x", "y"});

/// A file as NumPy writes it: magic, version, length, and a dictionary padded to 64 bytes.
std::string npy(const std::string& type, const std::string& order, const std::string& shape,
                const std::string& data, int version = 1) {
  std::string dictionary =
      "{'descr': " + type + ", 'fortran_order': " + order + ", 'shape': " + shape + ", }";
  const std::size_t prefix = version == 1 ? 10 : 12;
  while ((prefix + dictionary.size() + 1) % 64 != 0) dictionary += ' ';
  dictionary += '\n';
  std::string bytes = "\x93NUMPY";
  bytes += static_cast<char>(version);
  bytes += '\0';
  for (std::size_t k = 0; k < prefix - 8; ++k) {
    bytes += static_cast<char>(dictionary.size() >> (8 * k) & 255);
  }
  return bytes + dictionary + data;
}

template <class Number>
std::string bytes_of(std::vector<Number> numbers, bool big_endian = false) {
  std::string bytes;
  for (const Number number : numbers) {
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    std::string one(raw, sizeof number);
    if (big_endian) std::reverse(one.begin(), one.end());
    bytes += one;
  }
  return bytes;
}

const std::string six = bytes_of<double>({1, 2, 3, 4, 5, 0.1});

TEST_F(NpyTest, ReadsRowsInEitherOrderAndEveryVersion) {
  for (const int version : {1, 2, 3}) {
    const auto rows =
        data::read_npy(write(npy("'<f8'", "False", "(3, 2)", six, version)), binary64_, xy);
    ASSERT_TRUE(rows.ok()) << rows.error().to_string();
    ASSERT_EQ(rows->rows(), 3U);
    EXPECT_EQ(text(*rows, 1, 0), "3");
    EXPECT_EQ(text(*rows, 2, 1), "0.1");
  }
  const auto columns = data::read_npy(write(npy("'<f8'", "True", "(3, 2)", six)), binary64_, xy);
  ASSERT_TRUE(columns.ok()) << columns.error().to_string();
  EXPECT_EQ(text(*columns, 1, 0), "2");
  EXPECT_EQ(text(*columns, 0, 1), "4");
  EXPECT_EQ(text(*columns, 2, 1), "0.1");
}

TEST_F(NpyTest, ReadsEveryNumberTypeInEitherByteOrder) {
  const auto second = [&](const std::string& type, const std::string& data) {
    const auto table =
        data::read_npy(write(npy("'" + type + "'", "False", "(1, 2)", data)), binary64_, xy);
    EXPECT_TRUE(table.ok()) << type << ": " << table.error().to_string();
    return table.ok() ? text(*table, 0, 1) + " in " + table->origins[1].type->name() : "";
  };
  EXPECT_EQ(second("<f4", bytes_of<float>({1, -0.5F})), "-0.5 in s24e8");
  EXPECT_EQ(second(">f4", bytes_of<float>({1, -0.5F}, true)), "-0.5 in s24e8");
  EXPECT_EQ(second(">f8", bytes_of<double>({1, 0.1}, true)), "0.1 in s53e11");
  EXPECT_EQ(second("<f2", bytes_of<std::uint16_t>({0x3c00, 0xc000})), "-2 in s11e5");
  EXPECT_EQ(second("|i1", bytes_of<std::int8_t>({1, -128})), "-128 in int8");
  EXPECT_EQ(second("|u1", bytes_of<std::uint8_t>({1, 255})), "255 in uint8");
  EXPECT_EQ(second("<i2", bytes_of<std::int16_t>({1, -300})), "-300 in int16");
  EXPECT_EQ(second(">u2", bytes_of<std::uint16_t>({1, 65535}, true)), "65535 in uint16");
  EXPECT_EQ(second(">i4", bytes_of<std::int32_t>({1, -70000}, true)), "-70000 in int32");
  EXPECT_EQ(second("=i8", bytes_of<std::int64_t>({1, -(std::int64_t{1} << 40)})),
            "-1099511627776 in int64");
  EXPECT_EQ(second("<u8", bytes_of<std::uint64_t>({1, std::uint64_t{1} << 40})),
            "1099511627776 in uint64");
  EXPECT_EQ(second("<f8", bytes_of<double>({1, -0.0})), "-0 in s53e11");
  EXPECT_EQ(second("<f4", bytes_of<float>({1, -std::numeric_limits<float>::infinity()})),
            "-inf in s24e8");
  EXPECT_EQ(second("<f8", bytes_of<double>({1, std::numeric_limits<double>::quiet_NaN()})),
            "nan in s53e11");
  EXPECT_EQ(second("<f8", bytes_of<double>({1, 5e-324})), "5e-324 in s53e11");
}

TEST_F(NpyTest, CountsIntegersThatItRounds) {
  constexpr std::int64_t odd = (std::int64_t{1} << 53) + 1;
  const std::string integers = bytes_of<std::int64_t>({odd - 1, 7, -odd, odd + 1});
  const auto table =
      data::read_npy(write(npy("'<i8'", "False", "(2, 2)", integers)), binary64_, xy);
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  EXPECT_EQ(table->lost.count, 1U);
  EXPECT_EQ(table->lost.first, "-9007199254740993 in data, row 1, column 0, read in s53e11");
  const auto floats = data::read_npy(write(npy("'<f8'", "False", "(3, 2)", six)), binary16_, xy);
  ASSERT_TRUE(floats.ok()) << floats.error().to_string();
  EXPECT_EQ(floats->lost.count, 0U);
  const std::string small = bytes_of<double>({0, -0.0, 1, -1e-300});
  const auto zeros = data::read_npy(write(npy("'<f8'", "False", "(2, 2)", small)), binary16_, xy);
  ASSERT_TRUE(zeros.ok()) << zeros.error().to_string();
  EXPECT_EQ(zeros->lost.count, 1U);
  EXPECT_EQ(zeros->lost.first, "-1e-300 in data, row 1, column 1, read in s11e5");
}

TEST_F(NpyTest, CountsNumbersThatBecomeNan) {
  std::vector<data::WantedColumn> wanted(xy.begin(), xy.end());
  wanted[0].rounded_to = FloatFormat::e4m3();
  const auto lost = [&](const char* type, const std::string& numbers) {
    const auto table =
        data::read_npy(write(npy(type, "False", "(4, 2)", numbers)), binary64_, wanted);
    EXPECT_TRUE(table.ok()) << table.error().to_string();
    EXPECT_TRUE(table->format.is_nan(table->at(1, 0)));
    EXPECT_TRUE(table->format.is_nan(table->at(3, 0)));
    EXPECT_EQ(text(*table, 0, 0), "-448");
    EXPECT_EQ(text(*table, 1, 1), "500");
    return table->lost;
  };
  const auto floats =
      lost("'<f8'", bytes_of<double>({-449, 1, 465, 500, NAN, 1, double{INFINITY}, 1}));
  EXPECT_EQ(floats.count, 2U);
  EXPECT_EQ(floats.first, "465 in data, row 1, column 0, read in E4M3");
  const auto integers = lost("'<i8'", bytes_of<std::int64_t>({-448, 1, 465, 500, 3, 1, -999, 1}));
  EXPECT_EQ(integers.count, 2U);
  EXPECT_EQ(integers.first, "465 in data, row 1, column 0, read in E4M3");
}

TEST_F(NpyTest, StructuredArraysAreReadByFieldName) {
  std::string data;
  data += bytes_of<float>({0.25F}) + "abcd" + bytes_of<std::int16_t>({-1});
  data += bytes_of<float>({1.25F}) + "efgh" + bytes_of<std::int16_t>({0});
  const std::string type = "[('y', '<f4'), ('name', '|S4'), ('x', '<i2')]";
  const auto table = data::read_npy(write(npy(type, "False", "(2,)", data)), binary64_, fields);
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  EXPECT_EQ(text(*table, 0, 0), "-1");
  EXPECT_EQ(text(*table, 1, 1), "1.25");
  const auto name = data::columns_by_name(std::vector<std::string>{"name"});
  EXPECT_EQ(told(data::read_npy(path_, binary64_, name)),
            ": name: not numbers we read: received |S4; accepted floats of 2, 4, 8 bytes or "
            "integers of 1, 2, 4, 8");
  const auto other = data::columns_by_name(std::vector<std::string>{"nmae"});
  EXPECT_EQ(told(data::read_npy(path_, binary64_, other)),
            ": nmae: no such column: received nothing; accepted name (the nearest), y, x");
}

TEST_F(NpyTest, PlainColumnsGoByNumberAndMayBeMore) {
  const std::vector<data::WantedColumn> swapped = {{.name = "x", .column = std::uint64_t{2}},
                                                   {.name = "y", .column = std::uint64_t{0}}};
  for (const char* order : {"False", "True"}) {
    const auto table =
        data::read_npy(write(npy("'<f8'", order, "(2, 3)", six)), binary64_, swapped);
    ASSERT_TRUE(table.ok()) << table.error().to_string();
    EXPECT_EQ(table->columns, (std::vector<std::string>{"x", "y"}));
    const bool rows = std::string(order) == "False";
    EXPECT_EQ(text(*table, 1, 0), "0.1");
    EXPECT_EQ(text(*table, 0, 0), rows ? "3" : "5");
    EXPECT_EQ(text(*table, 1, 1), rows ? "4" : "2");
    EXPECT_EQ(table->origins[0].number, 2U);
    EXPECT_EQ(table->origins[0].name, "");
  }
}

TEST_F(NpyTest, FieldsGoByNumberWithoutTheNamelessOnesOfPadding) {
  std::string data;
  data += bytes_of<float>({0.25F}) + "pad!" + bytes_of<double>({2});
  const std::string type = "[('y', '<f4'), ('', '|V4'), ('x', '<f8')]";
  const auto table = data::read_npy(write(npy(type, "False", "(1,)", data)), binary64_, xy);
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  EXPECT_EQ(text(*table, 0, 0), "0.25");
  EXPECT_EQ(text(*table, 0, 1), "2");
  EXPECT_EQ(table->origins[1].name, "x");
}

TEST_F(NpyTest, NoOrderOfPlainColumnsIsImplied) {
  write(npy("'<f8'", "False", "(2, 3)", six));
  EXPECT_EQ(told(data::read_npy(path_, binary64_, fields)),
            ": the columns of a plain array have no names: received no number for x, y; accepted "
            "the number of each one's column, counted from 0 and below 3, for example { x = 0, "
            "y = 1 }");
  const std::vector<data::WantedColumn> partly = {{.name = "p_0", .column = std::uint64_t{0}},
                                                  {.name = "r", .column = "r"},
                                                  {.name = "p_1", .column = "p_1"},
                                                  {.name = "q", .column = "q"}};
  EXPECT_EQ(told(data::read_npy(path_, binary64_, partly)),
            ": the columns of a plain array have no names: received no number for r, p_1, q; "
            "accepted the number of each one's column, counted from 0 and below 3, for example "
            "{ p = [0, 2], r = 1, q = ? }");
  const Place place = {"s.toml", 9};
  const std::vector<data::WantedColumn> named = {
      {.name = "x", .column = "c0", .field = "data.columns.x", .place = place}};
  EXPECT_EQ(data::read_npy(path_, binary64_, named).error().to_string(),
            "s.toml:9: data.columns.x: the columns of data have no names: received \"c0\"; "
            "accepted a number below 3, the first column being 0");
  const std::vector<data::WantedColumn> beyond = {
      {.name = "x", .column = std::uint64_t{3}, .field = "data.columns.x", .place = place}};
  EXPECT_EQ(
      data::read_npy(path_, binary64_, beyond).error().to_string(),
      "s.toml:9: data.columns.x: no column of this number in data: received 3; accepted 0..2, "
      "counted from 0");
}

TEST_F(NpyTest, MistakesTellWhatWasFoundAndAccepted) {
  const auto error = [&](const std::string& bytes) {
    return told(data::read_npy(write(bytes), binary16_, xy));
  };
  EXPECT_EQ(
      error("PK\3\4 and so on"),
      ": npy header: not a .npy file: received \"PK?? a\"; accepted the bytes \\x93NUMPY first");
  EXPECT_EQ(error(npy("'<f8'", "False", "(3, 2)", six, 9)),
            ": npy header: unknown version: received 9; accepted 1, 2 or 3");
  EXPECT_EQ(error(npy("'<f8'", "False", "(6,)", six)),
            ": shape: not the shape of this data: received (6); accepted (rows, columns), or "
            "(rows,) for an array of named fields");
  EXPECT_EQ(error(npy("'<f8'", "False", "(3, 0)", six)),
            ": shape: not the shape of this data: received (3, 0); accepted at least one column");
  EXPECT_EQ(error(npy("'<f8', 'descr': '>f8'", "False", "(3, 2)", six)),
            ": npy header: a key given twice: received \"descr\"; accepted each key once");
  EXPECT_EQ(error(npy("'<f8'", "False", "(3, 2)} (", six)).substr(0, 31),
            ": npy header: malformed: receiv");
  EXPECT_EQ(
      told(data::read_npy(
          write(npy("[('x', '<f8'), ('y', '<f8'), ('x', '<f8')]", "False", "(2,)", six)), binary16_,
          fields)),
      ": descr: two fields of this name: received \"x\"; accepted names that differ, as NumPy "
      "has them");
  EXPECT_EQ(error(npy("'<f8'", "False", "(4, 2)", six)),
            ": data: the data do not fill the shape: received 48 bytes; accepted 64 bytes");
  EXPECT_EQ(error(npy("'<f8'", "False", "(18446744073709551615, 2)", six)).substr(0, 41),
            ": shape: not the shape of this data: rece");
  EXPECT_EQ(error(npy("'<c16'", "False", "(3, 2)", six)),
            ": descr: not numbers we read: received <c16; accepted floats of 2, 4, 8 bytes or "
            "integers of 1, 2, 4, 8");
  EXPECT_EQ(error(npy("'|O'", "False", "(3, 2)", six)).substr(0, 57),
            ": npy header: not a type of values: received \"|O\"; accept");
  EXPECT_EQ(error(npy("'<f8'", "Maybe", "(3, 2)", six)).substr(0, 33),
            ": npy header: malformed: received");
  EXPECT_EQ(error(npy("'<f8'", "False", "(3, 2)", six).substr(0, 40)),
            ": npy header: cut short: received 40 bytes in the file; accepted at least 128");
  EXPECT_EQ(
      error(npy("'<f8'", "False", "(1, 2)", bytes_of<double>({1, 1e5}))),
      ": row 0, column 1: out of range: received a number beyond the largest of s11e5; accepted a "
      "smaller one, or a format with more exponent bits");
}

TEST_F(NpyTest, MutatedFilesGiveErrorsNotCrashes) {
  const std::string plain = npy("'<f8'", "False", "(3, 2)", six);
  const std::string structured = npy("[('x', '<f8'), ('y', '<f8')]", "False", "(3,)", six, 2);
  std::mt19937 random(1);
  int errors = 0;
  for (int round = 0; round < 4000; ++round) {
    std::string bytes = round % 2 == 0 ? plain : structured;
    for (auto changes = 1 + random() % 3; changes > 0; --changes) {
      bytes[random() % std::min<std::size_t>(bytes.size(), 100)] =
          static_cast<char>(random() % 256);
    }
    if (random() % 4 == 0) bytes.resize(random() % bytes.size());
    errors += !data::read_npy(write(bytes), binary64_, round % 2 == 0 ? xy : fields).ok();
  }
  EXPECT_GT(errors, 1000);
}

}  // namespace
}  // namespace mixcmp::test::npy_test

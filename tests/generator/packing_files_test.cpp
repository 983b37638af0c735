#include "generator/project/packing_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>

#include "model/base/common/file.hpp"
#include "model/base/common/output_file.hpp"
#include "model/base/common/process.hpp"
#include "model/base/number/double.hpp"
#include "model/base/number/exact.hpp"
#include "tests/support/scratch_directory.hpp"

/// The packers in C, C++ and Python against the model's words.
namespace mixcmp::test::packing_files_test {
namespace {

using project::PackedRecord;

/// Formats on both sides of 64 bits and of double.
const std::vector<std::string> float_names = {
    "s53e11", "s24e8",   "s11e5",  "s8e8",  "s3e5",   "s2e2",   "s53e8",
    "s17e8",  "s52e11",  "s54e11", "s60e8", "s63e15", "s64e4",  "s65e9",
    "s66e3",  "s113e15", "s113e2", "s2e15", "s53e12", "s24e11", "E4M3"};
const std::vector<std::string> fixed_names = {"int10", "uint10", "uint1",  "int64",  "uint64",
                                              "int63", "uint63", "q3.12",  "uq4.12", "uq0.8",
                                              "q0.63", "uq1.62", "uint33", "int2"};

PackedRecord record_of(const std::vector<std::string>& names) {
  PackedRecord record{"operands", "s_axis_tdata", {}, {}, 0};
  for (const std::string& name : names) {
    record.operands.push_back(fmt::format("x{}", record.operands.size()));
    record.formats.push_back(*OperandFormat::parse(name));
  }
  record.bytes = (total_width(record.formats) + 7) / 8;
  return record;
}

/// A number as a program reads it, and the word that it must make of it.
struct Sample {
  std::string text;
  Bits word;
};

std::string text_of(double value) {
  return std::isnan(value) ? "nan" : fmt::format("{:a}", value);
}

Bits word_of(FloatFormat format, double value) {
  if (std::isnan(value)) return format.quiet_nan();
  if (std::isinf(value)) return format.beyond_largest(value < 0);
  return with_sign(format, std::signbit(value), from_rational(format, mpq_class(value)));
}

class Samples {
public:
  explicit Samples(unsigned seed) : engine_(seed) {}

  Sample of(const OperandFormat& format) {
    if (const FloatFormat* const floating = format.floating()) {
      const double value = number_near(*floating);
      return {text_of(value), word_of(*floating, value)};
    }
    return of(*format.fixed());
  }

  std::uint64_t bits(int count) { return count == 0 ? 0 : engine_() >> (64 - count); }

private:
  Sample of(const FixedFormat& format) {
    mpz_class steps = format.smallest() + mpz_class(std::to_string(bits(format.width)));
    if (bits(3) == 0) steps = bits(1) == 0 ? format.smallest() : format.largest();
    if (bits(3) == 0 && format.smallest() < 0) steps = -1;
    // Numbers with digits behind the point are multiples of 2^11 units, which a double holds.
    if (format.unit_exponent != 0) steps = mpz_class(std::trunc(steps.get_d() / 2048)) * 2048;
    if (steps < format.smallest() || steps > format.largest()) steps = format.smallest();
    Bits word = 0;
    mpz_class remainder;
    const mpz_class positive = steps < 0 ? steps + (mpz_class(1) << format.width) : steps;
    for (int k = format.width - 1; k >= 0; --k) {
      word = word << 1 | mpz_tstbit(positive.get_mpz_t(), k);
    }
    if (format.unit_exponent == 0) return {steps.get_str(), word};
    return {text_of(std::ldexp(steps.get_d(), format.unit_exponent)), word};
  }

  /// Doubles of every kind, many of them next to the middle between two numbers of the format, to
  /// its largest and to its least.
  double number_near(FloatFormat format) {
    const double sign = bits(1) == 0 ? 1 : -1;
    const int least = std::max(1 - format.bias() - format.precision(), -1074);
    const int most = std::min(format.max_exponent(), 1023);
    switch (bits(3)) {
      case 0: {
        const double special[] = {0,
                                  INFINITY,
                                  NAN,
                                  std::numeric_limits<double>::denorm_min(),
                                  std::numeric_limits<double>::min(),
                                  std::numeric_limits<double>::max(),
                                  1,
                                  1.5};
        return sign * special[bits(3)];
      }
      case 1: return std::bit_cast<double>(engine_());
      case 2:
        return sign * std::ldexp(1 + std::ldexp(double(bits(4)), -4), least + int(bits(2)) - 1);
      case 3:
        return sign * std::nextafter(std::ldexp(2 - std::ldexp(1.0, -int(bits(6))), most),
                                     bits(1) == 0 ? 0 : INFINITY);
      default: {
        const int kept = std::min(format.precision(), 52);
        double value = 1 + std::ldexp(double(bits(kept)), -kept);
        if (bits(1) == 0) value = std::nextafter(value, bits(1) == 0 ? 0 : 4);
        return sign * std::ldexp(value, least + int(bits(11)) % (most - least + 1));
      }
    }
  }

  std::mt19937_64 engine_;
};

std::string hexadecimal(const PackedRecord& record, const std::vector<Bits>& words) {
  std::vector<int> bytes(record.bytes);
  int at = 0;
  for (std::size_t k = 0; k < words.size(); ++k) {
    for (int bit = 0; bit < record.formats[k].width(); ++bit, ++at) {
      bytes[at / 8] |= static_cast<int>(words[k] >> bit & 1) << at % 8;
    }
  }
  std::string text;
  for (const int byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

/// The number of a word as a program writes it: an integer in decimal digits,
/// else as %a writes it.
std::string number_of(const OperandFormat& format, Bits word) {
  if (const FloatFormat* const floating = format.floating()) {
    return text_of(to_double(*floating, word));
  }
  const FixedFormat& fixed = *format.fixed();
  const bool is_negative = fixed.is_signed && (word >> (fixed.width - 1) & 1) != 0;
  mpz_class steps = mpz_class(std::to_string(static_cast<std::uint64_t>(word)));
  if (is_negative) steps -= mpz_class(1) << fixed.width;
  if (fixed.unit_exponent == 0) return steps.get_str();
  return text_of(std::ldexp(nearest_double(mpq_class(steps)), fixed.unit_exponent));
}

bool is_integer(const OperandFormat& format) {
  return format.fixed() != nullptr && format.fixed()->unit_exponent == 0;
}

/// Reads lines "p NUMBER..." and "u BYTES", and writes the bytes of the one and the numbers of the
/// other; "refused K" where the packer refuses operand K.
std::string c_program(const PackedRecord& record) {
  std::string reads, writes;
  for (std::size_t k = 0; k < record.operands.size(); ++k) {
    const std::string& name = record.operands[k];
    if (!is_integer(record.formats[k])) {
      reads += fmt::format("      from.{} = strtod(strtok(0, \" \\n\"), 0);\n", name);
      writes += fmt::format("      show(to.{});\n", name);
    } else if (record.formats[k].fixed()->is_signed) {
      reads += fmt::format("      from.{} = strtoll(strtok(0, \" \\n\"), 0, 10);\n", name);
      writes += fmt::format("      printf(\" %\" PRId64, to.{});\n", name);
    } else {
      reads += fmt::format("      from.{} = strtoull(strtok(0, \" \\n\"), 0, 10);\n", name);
      writes += fmt::format("      printf(\" %\" PRIu64, to.{});\n", name);
    }
  }
  return fmt::format(R"c(
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "integration/unit_packing.h"
void show(double value);
void show(double value) {{
  if (value != value) printf(" nan");
  else printf(" %a", value);
}}
int main(void) {{
  static char line[100000];
  while (fgets(line, sizeof line, stdin)) {{
    uint8_t bytes[UNIT_OPERANDS_BYTES];
    if (*strtok(line, " ") == 'p') {{
      struct unit_operands from;
{}      const int refused = unit_pack_operands(&from, bytes);
      if (refused != 0) printf("refused %d", refused);
      else for (int k = 0; k < UNIT_OPERANDS_BYTES; ++k) printf("%02x", bytes[k]);
    }} else {{
      const char *text = strtok(0, " \n");
      for (int k = 0; k < UNIT_OPERANDS_BYTES; ++k) {{
        const char pair[3] = {{text[2 * k], text[2 * k + 1], 0}};
        bytes[k] = (uint8_t)strtoul(pair, 0, 16);
      }}
      const struct unit_operands to = unit_unpack_operands(bytes);
{}    }}
    printf("\n");
  }}
  return 0;
}}
)c",
                     reads, writes);
}

/// The same, each kind of lines in one call.
constexpr const char* python_program = R"py(
import os
import sys
import numpy as np
sys.path.insert(0, os.path.join(os.path.dirname(__file__), "integration"))
import unit_packing as packing

lines = [line.split() for line in sys.stdin]
answers = [None] * len(lines)
packed = [k for k, line in enumerate(lines) if line[0] == "p"]
values = {}
for place, (name, form) in enumerate(packing.OPERANDS):
    texts = [lines[k][1 + place] for k in packed]
    if form[0] == "fixed" and form[3] == 0:
        values[name] = np.array([int(text) for text in texts],
                                np.int64 if any(text[0] == "-" for text in texts) else np.uint64)
    else:
        values[name] = np.array([float.fromhex(t) if "x" in t else float(t) for t in texts])
for k, row in zip(packed, packing.pack_operands(values)):
    answers[k] = row.tobytes().hex()
unpacked = [k for k, line in enumerate(lines) if line[0] == "u"]
tdata = np.array([list(bytes.fromhex(lines[k][1])) for k in unpacked], np.uint8)
columns = packing.unpack_operands(tdata)
for row, k in enumerate(unpacked):
    numbers = [columns[name][row] for name, _ in packing.OPERANDS]
    answers[k] = "".join(f" {int(n)}" if n.dtype.kind in "iu" else " " + float(n).hex()
                         for n in numbers)
print("\n".join(answers))
)py";

std::string output_of(const Command& words, const std::string& input) {
  const auto run = capture(words, {.input = input});
  EXPECT_TRUE(run.ok() && run->succeeded()) << (run.ok() ? run->errors : run.error().to_string());
  return run.ok() ? run->output + run->errors : "";
}

/// Numbers that were written in hexadecimal, each as %a writes it.
std::string normalised(const std::string& line) {
  std::istringstream words(line);
  std::string text;
  for (std::string word; words >> word;) {
    text += (text.empty() ? "" : " ") +
            (word.find("0x") != std::string::npos || word.find("inf") != std::string::npos
                 ? text_of(std::strtod(word.c_str(), nullptr))
                 : word);
  }
  return text;
}

/// The files of a record in a folder of their own, and programs that call them.
class Packers {
public:
  explicit Packers(const PackedRecord& record) {
    for (const emit::GeneratedFile& file :
         project::packing_files({"unit", {record}}, "// made up", "# made up")) {
      write(file.name, file.text);
    }
    write("run.c", c_program(record));
    write("run.py", python_program);
  }

  std::vector<std::string> c(const std::string& language, const std::string& input) const {
    const Command compile = {"gcc",
                             language,
                             "-Wall",
                             "-Wextra",
                             "-Wpedantic",
                             "-Wconversion",
                             "-Wno-unused-function",
                             "-Werror",
                             "-fsanitize=undefined",
                             "-fno-sanitize-recover",
                             "-O1",
                             "-o",
                             path("run"),
                             path("run.c"),
                             "-lm"};
    EXPECT_EQ(output_of(compile, ""), "");
    return lines_of(output_of({path("run")}, input));
  }

  std::vector<std::string> python(const std::string& input) const {
    return lines_of(output_of({MIXCMP_PYTHON, "-B", path("run.py")}, input));
  }

  /// The last line of what Python says where it leaves with an error.
  std::string python_error(const std::string& input) const {
    const auto run = capture({MIXCMP_PYTHON, "-B", path("run.py")}, {.input = input});
    EXPECT_TRUE(run.ok() && !run->succeeded());
    const std::string errors = run->errors.substr(0, run->errors.size() - 1);
    return errors.substr(errors.rfind('\n') + 1);
  }

private:
  std::string path(const std::string& name) const { return (scratch_.path() / name).string(); }

  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((scratch_.path() / name).parent_path());
    ASSERT_TRUE(write_file(scratch_.path() / name, text).ok());
  }

  static std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(normalised(line));
    return lines;
  }

  ScratchDirectory scratch_;
};

bool has_numpy() {
  const auto run = capture({MIXCMP_PYTHON, "-c", "import numpy"}, {});
  return run.ok() && run->succeeded();
}

void expect_lines(const std::vector<std::string>& lines, const std::vector<std::string>& expected) {
  ASSERT_EQ(lines.size(), expected.size());
  for (std::size_t k = 0; k < lines.size(); ++k) ASSERT_EQ(lines[k], expected[k]) << "line " << k;
}

class PackingFiles : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(PackingFiles, MakeTheWordsOfTheModelAndItsNumbers) {
  const PackedRecord record = record_of(GetParam());
  Samples samples(20'261'129);
  std::string input;
  std::vector<std::string> expected;
  for (int row = 0; row < 4000; ++row) {
    std::vector<Bits> words;
    std::string line;
    const bool packs = row % 2 == 0;
    for (const OperandFormat& format : record.formats) {
      const Sample sample = samples.of(format);
      Bits any = Bits{samples.bits(64)} << 64 | samples.bits(64);
      any &= low_mask(format.width());
      if (format.floating() != nullptr && format.floating()->is_nan(any))
        any = format.floating()->quiet_nan();
      words.push_back(packs ? sample.word : any);
      line += packs ? " " + sample.text : (line.empty() ? "" : " ") + number_of(format, any);
    }
    const std::string bytes = hexadecimal(record, words);
    input += packs ? fmt::format("p{}\n", line) : fmt::format("u {}\n", bytes);
    expected.push_back(packs ? bytes : line);
  }
  const Packers packers(record);
  expect_lines(packers.c("-std=c99", input), expected);
  expect_lines(packers.c("-xc++", input), expected);
  if (!has_numpy()) GTEST_SKIP() << "NumPy's half needs python3-numpy";
  expect_lines(packers.python(input), expected);
}

INSTANTIATE_TEST_SUITE_P(Of, PackingFiles, testing::Values(float_names, fixed_names));

/// All 256 words become numbers, and each number its word; between two numbers the nearest, of two
/// the even one; infinities and what rounds to more than 448 the NaN.
TEST(PackingFilesWithoutInfinities, EveryWordComesBack) {
  const PackedRecord record = record_of({"E4M3", "E4M3"});
  const FloatFormat format = *record.formats[0].floating();
  std::string input;
  std::vector<std::string> expected;
  const auto pack = [&](double value) {
    input += fmt::format("p {} {}\n", text_of(value), text_of(-value));
    expected.push_back(hexadecimal(record, {word_of(format, value), word_of(format, -value)}));
  };
  for (Bits word = 0; word < 256; ++word) {
    const double value = to_double(format, word);
    input += fmt::format("u {}\n", hexadecimal(record, {word, word ^ 1}));
    expected.push_back(number_of(record.formats[0], word) + " " +
                       number_of(record.formats[0], word ^ 1));
    pack(value);
    if (std::isnan(value) || std::isnan(to_double(format, word + 1))) continue;
    const double middle = (value + to_double(format, word + 1)) / 2;
    for (const double towards : {-1000.0, 1000.0}) pack(std::nextafter(middle, towards));
    pack(middle);
  }
  for (const double beyond :
       {464.0, 464.5, 479.0, 480.0, 496.0, 511.0, 512.0, 1e300, double{INFINITY}}) {
    pack(beyond);
  }
  EXPECT_EQ(expected.back(), "7f7f");
  const Packers packers(record);
  expect_lines(packers.c("-std=c99", input), expected);
  expect_lines(packers.c("-xc++", input), expected);
  if (!has_numpy()) GTEST_SKIP() << "NumPy's half needs python3-numpy";
  expect_lines(packers.python(input), expected);
}

/// Fields of such names would not compile, or would be two of one name.
TEST(PackingFilesRename, WhatCAndItsHeadersKeepForThemselves) {
  PackedRecord record = record_of(std::vector<std::string>(10, "s24e8"));
  record.operands = {"using",   "long", "long_", "NULL", "linux",
                     "int64_t", "int",  "_Bool", "M_PI", "x"};
  const std::vector<emit::GeneratedFile> files =
      project::packing_files({"unit", {record}}, "// made up", "# made up");
  const ScratchDirectory scratch;
  const std::string source = (scratch.path() / "unit.c").string();
  ASSERT_TRUE(write_file(source, files.front().text + "int main(void) { return 0; }\n").ok());
  for (const char* language : {"-std=c99", "-std=gnu17", "-xc++"}) {
    EXPECT_EQ(output_of({"gcc", language, "-fsyntax-only", "-include", "stdio.h", "-include",
                         "complex.h", "-Wall", "-Wno-unused-function", "-Werror", source},
                        ""),
              "");
  }
  EXPECT_NE(files.front().text.find("double long__;"), std::string::npos);
  EXPECT_NE(files.front().text.find("double x;"), std::string::npos);
}

TEST(PackingFilesRefuse, WhatAFixedPointFormatDoesNotHold) {
  const PackedRecord record = record_of({"s24e8", "int10", "uint10", "q3.2", "uq4.60", "int63"});
  const Packers packers(record);
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"p 1 512 0 0 0 0", "x1, row 1: received 512; expected an integer from -512 to 511"},
      {"p 1 -513 0 0 0 0", "x1, row 1: received -513; expected an integer from -512 to 511"},
      {"p 1 0 1024 0 0 0", "x2, row 1: received 1024; expected an integer from 0 to 1023"},
      {"p 1 0 0 8 0 0",
       "x3, row 1: received 8.0; expected a multiple of 2^-2 from -8 to less than 8"},
      {"p 1 0 0 0.125 0 0",
       "x3, row 1: received 0.125; expected a multiple of 2^-2 from -8 to less than 8"},
      {"p 1 0 0 nan 0 0",
       "x3, row 1: received nan; expected a multiple of 2^-2 from -8 to less than 8"},
      {"p 1 0 0 0 16 0",
       "x4, row 1: received 16.0; expected a multiple of 2^-60 from 0 to less than 16"},
      {"p 1 0 0 0 -0x1p-60 0",
       "x4, row 1: received -8.673617379884035e-19; expected a multiple of 2^-60 from 0 to less "
       "than 16"},
      {"p 1 0 0 0 0 4611686018427387904",
       "x5, row 1: received 4611686018427387904; expected an integer from -4611686018427387904 to "
       "4611686018427387903"}};
  std::string input;
  std::vector<std::string> expected;
  for (const auto& [line, message] : cases) {
    input += line + "\n";
    expected.push_back("refused " + std::to_string(message[1] - '0' + 1));
  }
  expect_lines(packers.c("-std=c99", input), expected);
  if (!has_numpy()) GTEST_SKIP() << "NumPy's half needs python3-numpy";
  for (const auto& [line, message] : cases) {
    EXPECT_EQ(packers.python_error("p 1 0 0 0 0 0\n" + line + "\n"), "ValueError: " + message);
  }
}

}  // namespace
}  // namespace mixcmp::test::packing_files_test

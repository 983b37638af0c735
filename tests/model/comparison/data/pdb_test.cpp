#include "model/comparison/data/pdb.hpp"

#include <fmt/core.h>

#include <random>

#include "model/base/common/file.hpp"
#include "tests/model/comparison/data/data_file_test.hpp"

namespace mixcmp::test::pdb_test {
namespace {

using PdbTest = DataFileTest;

const std::string alpha_carbon =
    "ATOM      2  CA  MET A 151      18.159  24.411   9.999  1.00 25.00           C  \n";

/// `line` with `text` from the 1-based `column` on.
std::string with(std::string line, std::size_t column, const std::string& text) {
  return line.replace(column - 1, text.size(), text);
}

std::string atom(const std::string& name, const std::string& element) {
  return with(with(alpha_carbon, 13, name), 77, element);
}

TEST_F(PdbTest, ReadsCoordinatesRadiusAndLabel) {
  const auto table = data::read_pdb(write("HEADER\n" + alpha_carbon + "TER\nEND\n"), binary64_);
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  ASSERT_EQ(table->columns, (std::vector<std::string>{"cx", "cy", "cz", "r"}));
  ASSERT_EQ(table->rows(), 1U);
  EXPECT_EQ(text(*table, 0, 0), "18.159");
  EXPECT_EQ(text(*table, 0, 1), "24.411");
  EXPECT_EQ(text(*table, 0, 2), "9.999");
  EXPECT_EQ(text(*table, 0, 3), "1.7");
  EXPECT_EQ(table->labels[0], "A 151 MET CA");
}

TEST_F(PdbTest, ReadsTheProteinOfTheExample) {
  const auto table =
      data::read_pdb(MIXCMP_SOURCE_DIR "/examples/protein_clash/1A8O.pdb", binary64_);
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  EXPECT_EQ(table->rows(), 644U);
  EXPECT_EQ(table->labels.size(), 644U);
  std::map<std::string, int> radii;
  for (std::size_t row = 0; row < table->rows(); ++row) ++radii[text(*table, row, 3)];
  // Counted by: grep -E '^(ATOM|HETATM)' 1A8O.pdb | cut -c77-78 | sort | uniq -c
  EXPECT_EQ(radii, (std::map<std::string, int>{
                       {"1.7", 346}, {"1.55", 96}, {"1.52", 196}, {"1.8", 2}, {"1.9", 4}}));
}

TEST_F(PdbTest, RadiiFollowTheElementElseTheName) {
  const auto radius = [&](const std::string& name, const std::string& element) {
    const auto table = data::read_pdb(write(atom(name, element)), binary64_);
    EXPECT_TRUE(table.ok()) << name << ": " << table.error().to_string();
    return table.ok() ? text(*table, 0, 3) : "";
  };
  EXPECT_EQ(radius(" CA ", " C"), "1.7");
  EXPECT_EQ(radius("CA  ", "CA"), "2.31");
  EXPECT_EQ(radius("SE  ", "SE"), "1.9");
  EXPECT_EQ(radius("SE  ", "Se"), "1.9");
  EXPECT_EQ(radius(" CA ", "  "), "1.7");   // carbon alpha
  EXPECT_EQ(radius("CA  ", "  "), "2.31");  // calcium
  EXPECT_EQ(radius("SE  ", "  "), "1.9");
  EXPECT_EQ(radius(" OXT", "  "), "1.52");
  EXPECT_EQ(radius("1HB ", "  "), "1.2");
  EXPECT_EQ(radius("HG11", "  "), "1.2");  // no mercury
  EXPECT_EQ(radius("HG  ", "  "), "1.55");
  EXPECT_EQ(radius(" N  ", "12"), "1.55");  // columns of an older format
}

TEST_F(PdbTest, HeteroAtomsAndWatersAreKept) {
  const std::string water =
      "HETATM  557  O   HOH A 222      20.000  20.000  20.000  1.00 20.00           O  \n";
  const auto table = data::read_pdb(write(alpha_carbon + water), binary64_);
  ASSERT_TRUE(table.ok());
  ASSERT_EQ(table->rows(), 2U);
  EXPECT_EQ(table->labels[1], "A 222 HOH O");
}

TEST_F(PdbTest, OfAlternateLocationsTheLikeliestCounts) {
  const auto x_of = [&](const std::vector<std::pair<std::string, std::string>>& conformers) {
    std::string lines;
    int x = 1;
    for (const auto& [letter, occupancy] : conformers) {
      lines += with(with(with(alpha_carbon, 17, letter), 55, occupancy), 31,
                    "   " + std::to_string(x++) + ".000");
    }
    const auto table = data::read_pdb(write(lines), binary64_);
    EXPECT_TRUE(table.ok());
    EXPECT_EQ(table->rows(), 1U);
    return text(*table, 0, 0);
  };
  EXPECT_EQ(x_of({{"A", "  0.40"}, {"B", "  0.60"}}), "2");
  EXPECT_EQ(x_of({{"A", "  0.60"}, {"B", "  0.40"}}), "1");
  EXPECT_EQ(x_of({{"A", "  0.50"}, {"B", "  0.50"}}), "1");
  EXPECT_EQ(x_of({{"A", "  0.30"}, {"B", "  0.35"}, {"C", "  0.35"}}), "2");
  EXPECT_EQ(x_of({{" ", "      "}, {"B", "  0.50"}}), "1");
}

TEST_F(PdbTest, DifferentResiduesAndAtomsDoNotCompete) {
  const std::string lines =
      with(alpha_carbon, 17, "A") + with(with(alpha_carbon, 17, "B"), 13, " CB ") +
      with(with(alpha_carbon, 17, "B"), 26, "2") + with(with(alpha_carbon, 17, "B"), 27, "Z") +
      with(with(alpha_carbon, 17, "B"), 22, "B");
  const auto table = data::read_pdb(write(lines), binary64_);
  ASSERT_TRUE(table.ok());
  EXPECT_EQ(table->labels, (std::vector<std::string>{"A 151 MET CA", "A 151 MET CB", "A 152 MET CA",
                                                     "A 151Z MET CA", "B 151 MET CA"}));
}

TEST_F(PdbTest, OnlyTheFirstModelCounts) {
  const auto table = data::read_pdb(write("MODEL        1\n" + alpha_carbon +
                                          "ENDMDL\nMODEL        2\n" + alpha_carbon + "ENDMDL\n"),
                                    binary64_);
  ASSERT_TRUE(table.ok());
  EXPECT_EQ(table->rows(), 1U);
}

TEST_F(PdbTest, CarriageReturnsAndMissingOccupancyAreTolerated) {
  std::string line = alpha_carbon.substr(0, 54) + "\r\n";
  const auto table = data::read_pdb(write(line), binary64_);
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  EXPECT_EQ(text(*table, 0, 2), "9.999");
  EXPECT_EQ(text(*table, 0, 3), "1.7");
}

TEST_F(PdbTest, NoAtomIsLostToAByteOrderMarkAndLabelsAreUtf8) {
  const auto table = data::read_pdb(
      write("\xef\xbb\xbf" + with(alpha_carbon, 18, "M\xffT") + alpha_carbon), binary64_);
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  ASSERT_EQ(table->rows(), 2U);
  EXPECT_NE(table->labels[0].find(" M?T "), std::string::npos) << table->labels[0];
}

TEST_F(PdbTest, BadLinesAreToldByLineAndField) {
  const auto error = [&](const std::string& line) {
    return told(data::read_pdb(write("HEADER\n" + alpha_carbon + line), binary64_));
  };
  EXPECT_EQ(error(with(alpha_carbon, 39, "  24.x11")).substr(0, 57),
            ":3: y (columns 39-46): not a number: received \"  24.x11\";");
  EXPECT_EQ(error(with(alpha_carbon, 31, "     nan")),
            ":3: x (columns 31-38): not a number: received \"     nan\"; accepted a finite decimal "
            "number");
  for (const std::size_t end : {46, 50, 53}) {
    EXPECT_EQ(error(alpha_carbon.substr(0, end)),
              fmt::format(":3: z (columns 47-54): the line ends before it does: received {} "
                          "columns; accepted a whole line",
                          end));
  }
  EXPECT_EQ(error(with(alpha_carbon, 55, "  much")).substr(0, 34),
            ":3: occupancy (columns 55-60): not");
  const std::string unknown = error(atom("XX  ", "XX"));
  EXPECT_EQ(
      unknown.substr(0, 83),
      ":3: element (columns 77-78): no van der Waals radius is known: received \"XX\"; accep");
  EXPECT_NE(unknown.find(" SE "), std::string::npos);
  EXPECT_EQ(
      told(data::read_pdb(write(alpha_carbon.substr(0, 54) + "\r" + alpha_carbon), binary64_)),
      ":1: not a line of a PDB file: received CR within it; accepted lines that end in LF or "
      "CR LF");
  EXPECT_EQ(told(data::read_pdb(write("HEADER\n"), binary64_)),
            ": no atoms: received no ATOM or HETATM record; accepted a PDB file with at least one");
}

TEST_F(PdbTest, CoordinatesBeyondTheFormatAreAMistake) {
  const auto table = data::read_pdb(write(with(alpha_carbon, 31, "99999.99")), binary16_);
  EXPECT_EQ(told(table).substr(0, 62),
            ":1: x (columns 31-38): beyond the largest number of s11e5: rec");
}

TEST_F(PdbTest, MutatedFilesGiveErrorsNotCrashes) {
  const std::string good =
      read_file(MIXCMP_SOURCE_DIR "/examples/protein_clash/1A8O.pdb").value().substr(60'000, 4000);
  std::mt19937 random(1);
  int errors = 0;
  for (int round = 0; round < 1500; ++round) {
    std::string bytes = good;
    for (auto changes = 1 + random() % 8; changes > 0; --changes) {
      const std::size_t place = random() % bytes.size();
      if (random() % 2 == 0)
        bytes[place] = static_cast<char>(random() % 256);
      else
        bytes.erase(place, random() % 100);
    }
    errors += !data::read_pdb(write(bytes), binary64_).ok();
  }
  EXPECT_GT(errors, 300);
}

}  // namespace
}  // namespace mixcmp::test::pdb_test

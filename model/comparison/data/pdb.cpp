#include "model/comparison/data/pdb.hpp"

#include <fmt/core.h>

#include <array>
#include <cctype>
#include <map>

#include "model/base/common/file.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/data/number.hpp"
#include "model/comparison/data/van_der_waals.hpp"

namespace mixcmp::data {
namespace {

/// The columns of a record's field, 1-based and inclusive as in the format's description. Columns
/// beyond the end of a line count as blank.
struct Columns {
  std::size_t first;
  std::size_t last;
};
constexpr Columns name_columns = {13, 16}, alternate_columns = {17, 17}, residue_columns = {18, 20},
                  chain_columns = {22, 22}, sequence_columns = {23, 27}, x_columns = {31, 38},
                  y_columns = {39, 46}, z_columns = {47, 54}, occupancy_columns = {55, 60},
                  element_columns = {77, 78};

std::string_view field(std::string_view line, Columns columns) {
  if (line.size() < columns.first) return {};
  return line.substr(columns.first - 1, columns.last - columns.first + 1);
}

struct Atom {
  std::array<Bits, 4> sphere;
  std::string label;
  std::string_view alternate;
  mpq_class occupancy;
};

bool is_element_symbol(std::string_view text) {
  if (text.empty()) return false;
  for (const unsigned char c : text) {
    if (std::isalpha(c) == 0) return false;
  }
  return true;
}

/// The element's symbol as given in the file, else from the atom's name. Columns 13-14 hold that
/// right-justified, except for four-character names of hydrogens, which start in column 13.
std::string_view element_of(std::string_view line) {
  const std::string_view given = trimmed(field(line, element_columns));
  if (is_element_symbol(given)) return given;
  const std::string_view name = field(line, name_columns);
  const std::string_view symbol = trimmed(name.substr(0, 2));
  const bool four_characters = trimmed(name).size() == 4;
  if (is_element_symbol(symbol) && !(four_characters && name.starts_with('H')) &&
      van_der_waals_radius(symbol)) {
    return symbol;
  }
  const std::size_t letter = name.find_first_not_of(" 0123456789");
  return letter == std::string_view::npos ? std::string_view() : name.substr(letter, 1);
}

Result<Bits> read_coordinate(std::string_view line, Columns columns, std::string_view axis,
                             FloatFormat format) {
  if (line.size() < static_cast<std::size_t>(columns.last)) {
    return Error{.field = fmt::format("{} (columns {}-{})", axis, columns.first, columns.last),
                 .message = "the line ends before it does",
                 .received = fmt::format("{} columns", line.size()),
                 .accepted = "a whole line"};
  }
  Result<Bits> bits = read_number(format, field(line, columns));
  const bool finite = bits.ok() && !format.is_nan(*bits) && !format.is_infinite(*bits);
  if (finite) return bits;
  Error error = bits.ok() ? Error{.message = "not a number",
                                  .received = in_quotes(field(line, columns)),
                                  .accepted = "a finite decimal number"}
                          : bits.error();
  error.field = fmt::format("{} (columns {}-{})", axis, columns.first, columns.last);
  return error;
}

/// Reads an atom's occupancy. Files of models leave it blank, which counts as 1.
Result<mpq_class> read_occupancy(std::string_view line) {
  const std::string_view text = trimmed(field(line, occupancy_columns));
  if (text.empty()) return mpq_class(1);
  const FloatFormat format = FloatFormat::parse("binary64").value();
  MIXCMP_TRY(bits, read_coordinate(line, occupancy_columns, "occupancy", format));
  return to_rational(format, bits);
}

Result<Atom> read_atom(std::string_view line, FloatFormat format) {
  MIXCMP_TRY(x, read_coordinate(line, x_columns, "x", format));
  MIXCMP_TRY(y, read_coordinate(line, y_columns, "y", format));
  MIXCMP_TRY(z, read_coordinate(line, z_columns, "z", format));
  MIXCMP_TRY(occupancy, read_occupancy(line));
  const std::string_view element = element_of(line);
  const auto radius = van_der_waals_radius(element);
  if (!radius) {
    return Error{.field = "element (columns 77-78)",
                 .message = "no van der Waals radius is known",
                 .received = in_quotes(element),
                 .accepted = known_elements()};
  }
  MIXCMP_TRY(r, read_number(format, *radius));
  return Atom{.sphere = {x, y, z, r},
              .label = printable(fmt::format(
                  "{} {} {} {}", field(line, chain_columns), trimmed(field(line, sequence_columns)),
                  trimmed(field(line, residue_columns)), trimmed(field(line, name_columns)))),
              .alternate = field(line, alternate_columns),
              .occupancy = occupancy};
}

/// The atoms read so far. For alternate locations only the chosen one.
class Molecule {
public:
  void add(std::string_view line, Atom atom) {
    // The chain, sequence number, insertion code and atom name: atoms with equal ones are
    // alternatives.
    const auto place = fmt::format("{}{}{}", field(line, chain_columns),
                                   field(line, sequence_columns), field(line, name_columns));
    const auto [known, is_new] = places_.emplace(place, atoms_.size());
    if (!is_new && atoms_[known->second].alternate != atom.alternate) {
      Atom& rival = atoms_[known->second];
      if (atom.occupancy > rival.occupancy) rival = std::move(atom);
      return;
    }
    atoms_.push_back(std::move(atom));
  }

  const std::vector<Atom>& atoms() const { return atoms_; }

private:
  std::vector<Atom> atoms_;
  std::map<std::string, std::size_t> places_;
};

Result<Molecule> read_molecule(std::string_view text, FloatFormat format) {
  Molecule molecule;
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.find('\r') != std::string_view::npos) {
      return Error{.line = number,
                   .message = "not a line of a PDB file",
                   .received = "CR within it",
                   .accepted = "lines that end in LF or CR LF"};
    }
    if (line.starts_with("ENDMDL")) break;
    if (!line.starts_with("ATOM  ") && !line.starts_with("HETATM")) continue;
    Result<Atom> atom = read_atom(line, format);
    if (!atom.ok()) {
      Error error = atom.error();
      error.line = number;
      return error;
    }
    molecule.add(line, std::move(atom).value());
  }
  return molecule;
}

}  // namespace

Result<Table> read_pdb(const std::filesystem::path& path, FloatFormat format) {
  MIXCMP_TRY(text, read_file(path));
  const Result<Molecule> molecule = read_molecule(text, format);
  if (!molecule.ok()) {
    Error error = molecule.error();
    error.file = path.string();
    return error;
  }
  Table table{.format = format, .columns = {"cx", "cy", "cz", "r"}};
  for (const Atom& atom : molecule->atoms()) {
    table.values.insert(table.values.end(), atom.sphere.begin(), atom.sphere.end());
    table.labels.push_back(atom.label);
  }
  if (table.labels.empty()) {
    return Error{.file = path.string(),
                 .message = "no atoms",
                 .received = "no ATOM or HETATM record",
                 .accepted = "a PDB file with at least one"};
  }
  return table;
}

}  // namespace mixcmp::data

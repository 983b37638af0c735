#include "model/cost/units/unit_areas.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "embedded/library_files.hpp"
#include "model/base/common/check.hpp"
#include "model/base/common/memo.hpp"
#include "model/base/common/quote.hpp"

namespace mixcmp::units {
namespace {

/// A column with one resource of an area.
struct AreaColumn {
  std::string_view name;
  int devices::Area::*amount;
};
constexpr std::array<AreaColumn, 6> area_columns = {{{"luts", &devices::Area::luts},
                                                     {"registers", &devices::Area::registers},
                                                     {"dsps", &devices::Area::dsps},
                                                     {"memories", &devices::Area::memories},
                                                     {"carries", &devices::Area::carries},
                                                     {"shift_luts", &devices::Area::shift_luts}}};

constexpr std::string_view synthesis_mark = "# synthesis: ";
constexpr std::string_view also_mark = "# also: ";

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t comma = std::min(line.find(','), line.size());
    cells.push_back(line.substr(0, comma));
    if (comma == line.size()) return cells;
    line.remove_prefix(comma + 1);
  }
}

std::optional<long long> integer_of(std::string_view text) {
  long long number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, failed] = std::from_chars(text.data(), end, number);
  return failed == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

/// Digits of base 16.
std::optional<Bits> bits_of(std::string_view digits) {
  Bits bits = 0;
  for (const char c : digits) {
    unsigned digit = 0;
    if (std::from_chars(&c, &c + 1, digit, 16).ec != std::errc()) return std::nullopt;
    bits = bits << 4 | digit;
  }
  return digits.empty() ? std::nullopt : std::optional(bits);
}

/// An integer, or a literal such as 14'h322a.
std::optional<Parameter> parameter_of(std::string name, std::string_view text) {
  constexpr std::string_view mark = "'h";
  const std::size_t at = text.find(mark);
  const std::optional<long long> number = integer_of(text.substr(0, at));
  if (!number) return std::nullopt;
  if (at == std::string_view::npos) return integer(std::move(name), *number);
  const std::optional<Bits> bits = bits_of(text.substr(at + mark.size()));
  if (!bits || *number < 1 || *number > 128) return std::nullopt;
  return Parameter{std::move(name), static_cast<int>(*number), *bits};
}

std::string text_of(const Parameter& parameter) {
  const int bits = parameter.literal_bits;
  if (parameter.is_literal()) return fmt::format("{}'h{}", bits, to_hex(parameter.bits, bits));
  return fmt::format("{}", static_cast<long long>(parameter.bits));
}

}  // namespace

/// Reads the text of a library line by line.
class LibraryReader {
public:
  LibraryReader(std::string_view text, const std::filesystem::path& path)
      : text_(text), path_(path) {}

  Result<UnitAreas> read() {
    if (!next() || !line_.starts_with(synthesis_mark)) {
      return mistake("no synthesis command", std::string(synthesis_mark) + "COMMAND");
    }
    UnitAreas areas{std::string(line_.substr(synthesis_mark.size()))};
    bool more = next();
    for (; more && line_.starts_with(also_mark); more = next()) {
      areas.also_.emplace_back(line_.substr(also_mark.size()));
    }
    while (more) {
      if (line_.empty()) {
        more = next();
        continue;
      }
      MIXCMP_TRY(section, read_section(more));
      areas.set(std::move(section));
    }
    return areas;
  }

private:
  bool next() {
    if (text_.empty()) return false;
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    line_ = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    ++number_;
    return true;
  }

  Error mistake(const std::string& message, const std::string& accepted) const {
    return {.file = path_.string(),
            .line = number_,
            .message = message,
            .received = in_quotes(line_),
            .accepted = accepted};
  }

  Result<TemplateAreas> read_section(bool& more) {
    constexpr std::string_view mark = "] rtl=";
    const std::size_t at = line_.find(mark);
    if (!line_.starts_with('[') || at == std::string_view::npos) {
      return mistake("no section of a template", "[fp_add] rtl=HASH");
    }
    TemplateAreas areas{.module = std::string(line_.substr(1, at - 1)),
                        .rtl = std::string(line_.substr(at + mark.size())),
                        .units = {},
                        .areas = {}};
    next();
    MIXCMP_TRY(names, read_names());
    while ((more = next()) && !line_.empty()) {
      MIXCMP_DO(read_row(names, areas));
    }
    return areas;
  }

  Result<std::vector<std::string>> read_names() const {
    const std::vector<std::string_view> cells = cells_of(line_);
    const bool ends_with_areas =
        cells.size() >= area_columns.size() &&
        std::equal(
            area_columns.begin(), area_columns.end(), cells.end() - area_columns.size(),
            [](const AreaColumn& column, std::string_view cell) { return column.name == cell; });
    if (!ends_with_areas) {
      return mistake("not the columns of a template",
                     "its parameters,luts,registers,dsps,memories,carries,shift_luts");
    }
    return std::vector<std::string>(cells.begin(), cells.end() - area_columns.size());
  }

  Result<Done> read_row(const std::vector<std::string>& names, TemplateAreas& areas) const {
    const std::vector<std::string_view> cells = cells_of(line_);
    const std::string form = fmt::format("{} values", names.size() + area_columns.size());
    if (cells.size() != names.size() + area_columns.size()) return mistake("not a row", form);
    Unit unit{.module = areas.module, .parameters = {}};
    for (std::size_t k = 0; k < names.size(); ++k) {
      std::optional<Parameter> parameter = parameter_of(names[k], cells[k]);
      if (!parameter) return mistake(names[k] + ": not a value", "an integer or 4'hf");
      unit.parameters.push_back(std::move(*parameter));
    }
    devices::Area area;
    for (std::size_t k = 0; k < area_columns.size(); ++k) {
      const auto amount = integer_of(cells[names.size() + k]);
      if (!amount || *amount < 0) {
        return mistake(std::string(area_columns[k].name) + ": not a count", "0 or more");
      }
      area.*area_columns[k].amount = static_cast<int>(*amount);
    }
    areas.units.push_back(std::move(unit));
    areas.areas.push_back(area);
    return Done{};
  }

  std::string_view text_;
  const std::filesystem::path& path_;
  std::string_view line_;
  int number_ = 0;
};

namespace {

bool has_embedded_products(const Unit& unit) {
  return std::any_of(unit.parameters.begin(), unit.parameters.end(), [](const Parameter& each) {
    return each.name == embedded_products && each.size() > 0;
  });
}

/// Templates whose bits lie side by side. A unit of more than `widest` bits is some units of
/// `repeated` bits and one of the rest, so that no wide unit has to be measured. 288 bits fill
/// whole primitives of memory in most families (of 3, 4, 6, 16, 18, 32, 36 or 72 bits), and all of
/// these but a fiftieth elsewhere.
struct Repetition {
  std::string_view module;
  int repeated = 0;
  int widest = 0;
};
constexpr std::array<Repetition, 2> repetitions = {
    {{.module = "delay_line", .repeated = 1, .widest = 1},
     {.module = "dual_port_memory", .repeated = 288, .widest = 575}}};

/// So many of the first unit and one of the second.
struct Split {
  Unit repeated;
  int count = 0;
  Unit rest;
};

std::optional<Split> split_of(const Unit& unit) {
  const auto* const found =
      std::find_if(repetitions.begin(), repetitions.end(),
                   [&](const Repetition& repetition) { return repetition.module == unit.module; });
  if (found == repetitions.end()) return std::nullopt;
  const auto width = std::find_if(unit.parameters.begin(), unit.parameters.end(),
                                  [](const Parameter& each) { return each.name == "WIDTH"; });
  if (width == unit.parameters.end() || width->size() <= found->widest) return std::nullopt;
  const auto place = static_cast<std::size_t>(width - unit.parameters.begin());
  const int bits = static_cast<int>(width->size());
  const int least = found->widest - found->repeated + 1;  // of the rest
  Split split{.repeated = unit, .count = (bits - least) / found->repeated, .rest = unit};
  split.repeated.parameters[place] = integer("WIDTH", found->repeated);
  split.rest.parameters[place] = integer("WIDTH", bits - split.count * found->repeated);
  return split;
}

bool same_names(const Unit& a, const Unit& b) {
  return std::equal(a.parameters.begin(), a.parameters.end(), b.parameters.begin(),
                    b.parameters.end(),
                    [](const Parameter& x, const Parameter& y) { return x.name == y.name; });
}

/// Two measured units that differ from a unit in one number, which lies between theirs.
struct Neighbours {
  std::size_t below = 0, above = 0;  ///< indices
  double share = 0;                  ///< of the way from below to above
};

/// Finds the neighbours of a unit, those whose numbers are the closest.
class NeighbourSearch {
public:
  NeighbourSearch(const std::vector<Unit>& units, const Unit& unit)
      : units_(units), unit_(unit), sides_(unit.parameters.size()) {
    for (std::size_t k = 0; k < units.size(); ++k) add(k);
  }

  std::optional<Neighbours> closest() const {
    std::optional<Neighbours> best;
    double least = farthest;
    for (std::size_t p = 0; p < sides_.size(); ++p) {
      if (!sides_[p].below || !sides_[p].above) continue;
      const double low = size(*sides_[p].below, p), high = size(*sides_[p].above, p);
      if (low <= 0 || high / low > least) continue;
      least = high / low;
      const double share = (unit_.parameters[p].size() - low) / (high - low);
      best = Neighbours{*sides_[p].below, *sides_[p].above, share};
    }
    return best;
  }

private:
  /// Between numbers that are a larger factor apart a line tells nothing.
  static constexpr double farthest = 2;

  struct Sides {
    std::optional<std::size_t> below, above;
  };

  double size(std::size_t unit, std::size_t parameter) const {
    return units_[unit].parameters[parameter].size();
  }

  void add(std::size_t k) {
    const auto& own = unit_.parameters;
    const auto& others = units_[k].parameters;
    const auto [mine, other] = std::mismatch(own.begin(), own.end(), others.begin());
    if (mine == own.end() || !std::equal(mine + 1, own.end(), other + 1)) return;
    if (mine->is_literal() || mine->name == embedded_products) return;
    const auto p = static_cast<std::size_t>(mine - own.begin());
    Sides& sides = sides_[p];
    const bool is_below = other->size() < mine->size();
    std::optional<std::size_t>& side = is_below ? sides.below : sides.above;
    const bool is_closer =
        !side || (is_below ? other->size() > size(*side, p) : other->size() < size(*side, p));
    if (is_closer) side = k;
  }

  const std::vector<Unit>& units_;
  const Unit& unit_;
  std::vector<Sides> sides_;  ///< by parameter
};

/// Whether no size of a unit is above the other's. Their literals are equal.
bool is_within(const Unit& unit, const Unit& other) {
  return std::equal(unit.parameters.begin(), unit.parameters.end(), other.parameters.begin(),
                    [](const Parameter& a, const Parameter& b) {
                      return a.is_literal() ? a == b : !b.is_literal() && a.size() <= b.size();
                    });
}

/// A predicted number of memories, moved to what measured units allow: no fewer than a smaller unit
/// has, no more than a larger one. Memories are few and whole, and a formula of sizes may miss one.
int within_measured_memories(const TemplateAreas& known, const Unit& unit, int memories) {
  int least = 0, most = std::numeric_limits<int>::max();
  for (std::size_t k = 0; k < known.units.size(); ++k) {
    const int measured = known.areas[k].memories;
    if (is_within(known.units[k], unit)) least = std::max(least, measured);
    if (is_within(unit, known.units[k])) most = std::min(most, measured);
  }
  return std::min(std::max(memories, least), std::max(most, least));
}

/// An amount of each resource.
using Amounts = std::array<double, area_columns.size()>;

}  // namespace

/// Formulas for the rests of one template's units beside their parts: of units with embedded
/// products and of those without, since a product is either in a multiplier or in LUTs. A unit
/// between two measured ones also has what the formulas miss there, on a line from one to the
/// other.
struct UnitAreas::Formulas {
  using OfColumns = std::array<Formula, area_columns.size()>;
  OfColumns with_products, without;
  std::vector<Amounts> misses;  ///< of the measured units

  Amounts by_formula(const Unit& unit) const {
    const OfColumns& of_columns = has_embedded_products(unit) ? with_products : without;
    Amounts rest;
    for (std::size_t c = 0; c < rest.size(); ++c) rest[c] = of_columns[c].of(unit);
    return rest;
  }

  Amounts of(const std::vector<Unit>& measured, const Unit& unit) const {
    Amounts rest = by_formula(unit);
    const std::optional<Neighbours> found = NeighbourSearch(measured, unit).closest();
    for (std::size_t c = 0; found && c < rest.size(); ++c) {
      rest[c] += std::lerp(misses[found->below][c], misses[found->above][c], found->share);
    }
    return rest;
  }
};

namespace {

const Parameter* parameter_of(const Unit& unit, std::string_view name) {
  const auto found = std::find_if(unit.parameters.begin(), unit.parameters.end(),
                                  [&](const Parameter& each) { return each.name == name; });
  return found == unit.parameters.end() ? nullptr : &*found;
}

devices::Area area_of_table(const Unit& unit, const Parameter& luts) {
  const Parameter* const cuts = parameter_of(unit, "CUTS");
  const Parameter* const width = parameter_of(unit, "WIDTH");
  MIXCMP_CHECK(cuts != nullptr && width != nullptr);
  return {.luts = static_cast<int>(luts.bits),
          .registers = static_cast<int>(cuts->size() * width->size())};
}

}  // namespace

struct UnitAreas::Known {
  Memo<std::string, Formulas> formulas;  ///< by template
  Memo<Unit, std::optional<devices::Area>> areas;
};

UnitAreas::UnitAreas(std::string synthesis)
    : synthesis_(std::move(synthesis)), known_(std::make_unique<Known>()) {}
UnitAreas::UnitAreas(UnitAreas&&) noexcept = default;
UnitAreas& UnitAreas::operator=(UnitAreas&&) noexcept = default;
UnitAreas::~UnitAreas() = default;

Result<UnitAreas> UnitAreas::read(std::string_view text, const std::filesystem::path& path) {
  return LibraryReader(text, path).read();
}

std::string UnitAreas::text() const {
  std::string text = fmt::format("{}{}\n", synthesis_mark, synthesis_);
  for (const std::string& command : also_) text += fmt::format("{}{}\n", also_mark, command);
  for (const auto& [module, areas] : templates_) {
    text += fmt::format("\n[{}] rtl={}\n", module, areas.rtl);
    for (const Parameter& parameter : areas.units.front().parameters) text += parameter.name + ",";
    for (const AreaColumn& column : area_columns) {
      text += fmt::format("{}{}", column.name, &column == &area_columns.back() ? "\n" : ",");
    }
    for (std::size_t k = 0; k < areas.units.size(); ++k) {
      for (const Parameter& parameter : areas.units[k].parameters) text += text_of(parameter) + ",";
      for (const AreaColumn& column : area_columns) {
        text += fmt::format("{}{}", areas.areas[k].*column.amount,
                            &column == &area_columns.back() ? "\n" : ",");
      }
    }
  }
  return text;
}

bool UnitAreas::holds_for(const std::string& synthesis) const {
  return synthesis == synthesis_ || std::find(also_.begin(), also_.end(), synthesis) != also_.end();
}

const TemplateAreas* UnitAreas::find(const std::string& module) const {
  const auto found = templates_.find(module);
  return found == templates_.end() ? nullptr : &found->second;
}

void UnitAreas::set(TemplateAreas areas) {
  known_ = std::make_unique<Known>();  // templates with such parts change as well
  const std::string module = areas.module;
  if (!areas.units.empty()) templates_.insert_or_assign(module, std::move(areas));
}

std::shared_ptr<const UnitAreas::Formulas> UnitAreas::formulas_of(
    const TemplateAreas& areas) const {
  return known_->formulas.of(areas.module, [&] { return fitted(areas); });
}

UnitAreas::Formulas UnitAreas::fitted(const TemplateAreas& areas) const {
  Formulas made;
  std::vector<Amounts> rests;
  for (std::size_t k = 0; k < areas.units.size(); ++k) {
    const devices::Area of_parts = area_of_parts(areas.units[k]);
    Amounts& rest = rests.emplace_back();
    for (std::size_t c = 0; c < rest.size(); ++c) {
      rest[c] = areas.areas[k].*area_columns[c].amount - of_parts.*area_columns[c].amount;
    }
  }
  for (const bool embedded : {false, true}) {
    std::vector<Unit> units;
    std::vector<std::size_t> rows;
    for (std::size_t k = 0; k < areas.units.size(); ++k) {
      if (has_embedded_products(areas.units[k]) != embedded) continue;
      units.push_back(areas.units[k]);
      rows.push_back(k);
    }
    if (units.empty()) continue;
    Formulas::OfColumns& of = embedded ? made.with_products : made.without;
    for (std::size_t c = 0; c < area_columns.size(); ++c) {
      std::vector<double> rest, whole;
      for (const std::size_t k : rows) {
        rest.push_back(rests[k][c]);
        whole.push_back(areas.areas[k].*area_columns[c].amount);
      }
      of[c] = fit(units, rest, whole);
    }
  }
  for (std::size_t k = 0; k < rests.size(); ++k) {
    Amounts& miss = made.misses.emplace_back(made.by_formula(areas.units[k]));
    for (std::size_t c = 0; c < miss.size(); ++c) miss[c] = rests[k][c] - miss[c];
  }
  return made;
}

void UnitAreas::take_apart(PartsOf parts_of) {
  parts_of_ = std::move(parts_of);
  known_ = std::make_unique<Known>();
}

const devices::Area* UnitAreas::measured(const Unit& unit) const {
  const TemplateAreas* const known = find(unit.module);
  if (known == nullptr) return nullptr;
  const auto same = std::find(known->units.begin(), known->units.end(), unit);
  if (same == known->units.end()) return nullptr;
  return &known->areas[static_cast<std::size_t>(same - known->units.begin())];
}

devices::Area UnitAreas::area_of_parts(const Unit& unit) const {
  devices::Area sum;
  if (!parts_of_) return sum;
  for (const Unit& part : parts_of_(unit)) {
    const std::optional<devices::Area> area = of(part);
    sum += area ? *area : area_of_parts(part);
  }
  return sum;
}

std::optional<devices::Area> UnitAreas::predicted(const Unit& unit) const {
  const TemplateAreas* const known = find(unit.module);
  if (known == nullptr || !same_names(known->units.front(), unit)) return std::nullopt;
  const Amounts rest = formulas_of(*known)->of(known->units, unit);
  devices::Area area = area_of_parts(unit);
  for (std::size_t c = 0; c < area_columns.size(); ++c) {
    int& amount = area.*area_columns[c].amount;
    amount = std::max(static_cast<int>(std::lround(amount + rest[c])), 0);
  }
  area.memories = within_measured_memories(*known, unit, area.memories);
  return area;
}

std::optional<devices::Area> UnitAreas::of(const Unit& unit) const {
  return *known_->areas.of(unit, [&] { return found(unit); });
}

std::optional<devices::Area> UnitAreas::found(const Unit& unit) const {
  if (const Parameter* luts = parameter_of(unit, table_luts)) return area_of_table(unit, *luts);
  const devices::Area* const as_measured = measured(unit);
  if (as_measured != nullptr) return *as_measured;
  const std::optional<Split> split = split_of(unit);
  if (!split) return predicted(unit);
  std::optional<devices::Area> area = of(split->rest);
  const std::optional<devices::Area> repeated = of(split->repeated);
  if (area && repeated) *area += split->count * *repeated;
  return area;
}

Result<std::vector<UnitAreas>> shipped_libraries() {
  std::vector<UnitAreas> libraries;
  for (const EmbeddedFile& file : library_files()) {
    MIXCMP_TRY(areas, UnitAreas::read(file.text, file.name));
    libraries.push_back(std::move(areas));
  }
  return libraries;
}

}  // namespace mixcmp::units

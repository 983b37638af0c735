#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/common/result.hpp"
#include "model/cost/devices/area.hpp"
#include "model/cost/units/area_formula.hpp"

namespace mixcmp::units {

/// The measured units of one template.
struct TemplateAreas {
  std::string module;
  std::string rtl;  ///< a hash of the template and those that it instantiates
  std::vector<Unit> units;
  std::vector<devices::Area> areas;  ///< of each unit
};

class LibraryReader;

/// The units that a unit instantiates, each as often as it does. Empty for a unit without parts and
/// for one that is kept whole.
using PartsOf = std::function<std::vector<Unit>(const Unit&)>;

/// A library: areas of units after one synthesis command. Threads may share one that no longer
/// changes. Its text has a section for each template:
///
///     # synthesis: synth_xilinx -family xc7 -flatten -noiopad -noclkbuf
///     # also: synth_xilinx -family xc6v -flatten -noiopad -noclkbuf
///
///     [fixed_sum] rtl=3f...
///     A_WIDTH,B_WIDTH,...,CUTS,luts,registers,dsps,memories,carries,shift_luts
///     15,15,...,1'b1,15,15,0,0,4,0
class UnitAreas {
public:
  /// Errors name the line and the column of `path`.
  static Result<UnitAreas> read(std::string_view text, const std::filesystem::path& path);
  std::string text() const;

  explicit UnitAreas(std::string synthesis);
  UnitAreas(UnitAreas&&) noexcept;
  UnitAreas& operator=(UnitAreas&&) noexcept;
  ~UnitAreas();

  /// Yosys' command.
  const std::string& synthesis() const { return synthesis_; }
  /// Whether the areas hold after this command: the library's, or one that maps alike.
  bool holds_for(const std::string& synthesis) const;
  /// The units of a template, in the order of the text; null without any.
  const TemplateAreas* find(const std::string& module) const;
  const std::map<std::string, TemplateAreas>& templates() const { return templates_; }
  void set(TemplateAreas areas);

  /// From now on units are taken apart.
  void take_apart(PartsOf parts_of);

  /// The area of a unit. One that is not in the library has the areas of its parts, and the rest by
  /// a formula fitted to the rests of its template's measured units. A part whose template is not
  /// in the library is taken apart in turn or, if it has no parts, belongs to the rest. A delay
  /// line is as many lines of one bit as it is wide, and a memory of more than 575 bits some of 288
  /// bits and one of the rest. None if the library has no unit of this template with these
  /// parameters' names.
  std::optional<devices::Area> of(const Unit& unit) const;

private:
  friend class LibraryReader;
  struct Formulas;
  struct Known;
  std::shared_ptr<const Formulas> formulas_of(const TemplateAreas& areas) const;
  const devices::Area* measured(const Unit& unit) const;
  std::optional<devices::Area> predicted(const Unit& unit) const;
  Formulas fitted(const TemplateAreas& areas) const;
  std::optional<devices::Area> found(const Unit& unit) const;
  /// The sum over the parts that the library knows.
  devices::Area area_of_parts(const Unit& unit) const;

  std::string synthesis_;
  std::vector<std::string> also_;
  std::map<std::string, TemplateAreas> templates_;
  std::unique_ptr<Known> known_;  ///< asked for before
  PartsOf parts_of_;
};

/// The libraries that come with the program.
Result<std::vector<UnitAreas>> shipped_libraries();

}  // namespace mixcmp::units

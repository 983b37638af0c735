#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mixcmp::devices {

struct KnownDevice;

/// One row of parts.csv. The figures are texts that stand for whole numbers.
struct Part {
  std::string_view name;    ///< "xc7a100t"
  std::string_view family;  ///< "artix7": a file of families/
  std::string_view luts;
  std::string_view registers;
  std::string_view dsps;
  std::string_view memories;
  std::string_view arguments;     ///< for the family's nextpnr, separated by blanks
  std::string_view vivado_part;   ///< empty: Vivado has none
  std::string_view quartus_part;  ///< empty: Quartus has none
  std::string_view device;        ///< the device file that describes the part; empty: none
};

/// One row of boards.csv.
struct Board {
  std::string_view name;  ///< "arty-a7-100"
  std::string_view part;  ///< "xc7a100t"
  std::string_view maker;
  std::string_view page;
};

std::vector<Part> parts();
std::vector<Board> boards();

/// The part of a name: the part itself, a number for orders, or a board; in capitals or not.
///     find_part("XC7A100TCSG324-1")->name == "xc7a100t"
std::optional<Part> find_part(std::string_view name);

/// The device file of a part by itself: its family, its figures and its names.
std::string device_file_of(const Part& part);

/// The devices that come with the program and have these letters, in capitals or not, in their
/// name, their other names, their family or the name of their clocks' tool.
std::vector<KnownDevice> devices_with(std::string_view letters);

/// A name as tables have it.
std::string lower_case(std::string_view name);

/// The names that a user may have meant by an unknown one, for an error: the parts of a family,
/// else the names that begin with it, those that contain it, or those with the nearest spelling.
///     "xc7a25t, xc7a35t, xc7a50t, xc7a100t, xc7a200t"
std::string candidates_for(std::string_view received);

}  // namespace mixcmp::devices

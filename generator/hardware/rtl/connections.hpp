#pragma once

#include <string>
#include <vector>

#include "generator/hardware/rtl/module.hpp"

/// Shorthands for the ports and connections of modules with streams.
namespace mixcmp::rtl {

inline constexpr int verdict_bits = 2;
inline constexpr int result_bits = 8;  ///< bits of a verdict with its flags, see ResultWord

inline void add_input(std::vector<Port>& ports, int width, const std::string& name,
                      bool vector = false) {
  ports.push_back({Direction::input, width, name, vector});
}

inline void add_output(std::vector<Port>& ports, int width, const std::string& name,
                       bool vector = false) {
  ports.push_back({Direction::output, width, name, vector});
}

/// Connects a port to the net of the same name.
inline Connection by_name(const std::string& name) {
  return {name, net(name)};
}

inline std::vector<Connection> clock_and_reset() {
  return {by_name("aclk"), by_name("aresetn")};
}

inline void append(std::vector<Connection>& connections, const std::vector<std::string>& names) {
  for (const std::string& name : names) connections.push_back(by_name(name));
}

}  // namespace mixcmp::rtl

#include "generator/datapath/delays.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>

namespace mixcmp::gen {
namespace {

struct Device {
  std::string_view name;
  DelayTable delays;
};

// Rough, from the switching characteristics in the vendors' data sheets (a LUT, a carry, a
// multiplier) plus a typical wire. They choose where registers go and are shown to nobody.
constexpr DelayTable virtex5 = {.lut_ns = 0.9,
                                .carry_start_ns = 1.0,
                                .carry_ns_per_bit = 0.025,
                                .multiplier_ns = 3.6,
                                .multiplier_add_ns = 1.6,
                                .register_ns = 0.8};
constexpr DelayTable virtex6 = {.lut_ns = 0.7,
                                .carry_start_ns = 0.8,
                                .carry_ns_per_bit = 0.02,
                                .multiplier_ns = 3.0,
                                .multiplier_add_ns = 1.2,
                                .register_ns = 0.6};
constexpr DelayTable ultrascale_plus = {.lut_ns = 0.4,
                                        .carry_start_ns = 0.4,
                                        .carry_ns_per_bit = 0.008,
                                        .multiplier_ns = 1.8,
                                        .multiplier_add_ns = 0.7,
                                        .register_ns = 0.3};
constexpr DelayTable ecp5 = {.lut_ns = 1.0,
                             .carry_start_ns = 1.1,
                             .carry_ns_per_bit = 0.035,
                             .multiplier_ns = 4.0,
                             .multiplier_add_ns = 2.0,
                             .register_ns = 0.9};
constexpr DelayTable ice40_hx = {.lut_ns = 1.3,
                                 .carry_start_ns = 1.4,
                                 .carry_ns_per_bit = 0.13,
                                 .multiplier_ns = 14,
                                 .multiplier_add_ns = 3,
                                 .register_ns = 1.2};
constexpr DelayTable ice40_up = {.lut_ns = 2.6,
                                 .carry_start_ns = 2.8,
                                 .carry_ns_per_bit = 0.28,
                                 .multiplier_ns = 12,
                                 .multiplier_add_ns = 6,
                                 .register_ns = 2.4};

constexpr std::array<Device, 7> devices = {{
    {"virtex5-lx330t", virtex5},
    {"virtex6-lx760", virtex6},
    {"artix7-200t", virtex6},
    {"ultrascale+-vu9p", ultrascale_plus},
    {"ecp5-85k", ecp5},
    {"ice40-hx8k", ice40_hx},
    {"ice40-up5k", ice40_up},
}};

}  // namespace

model::Result<DelayTable> delays_of(std::string_view device) {
  for (const Device& known : devices) {
    if (known.name == device) return known.delays;
  }
  return model::Error{.field = "system.device",
                      .message = "unknown device",
                      .received = fmt::format("\"{}\"", device),
                      .accepted = fmt::format("{}", fmt::join(known_devices(), ", "))};
}

std::vector<std::string_view> known_devices() {
  std::vector<std::string_view> names;
  for (const Device& device : devices) names.push_back(device.name);
  return names;
}

}  // namespace mixcmp::gen

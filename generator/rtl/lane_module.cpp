#include "generator/rtl/lane_module.hpp"

#include "generator/rtl/fixed_lane_module.hpp"
#include "generator/rtl/float_lane_module.hpp"
#include "model/common/cases.hpp"

namespace mixcmp::rtl {
namespace {

FloatFormat input_format(const design::Lane& lane) {
  return std::visit(Cases{[](const error::Lane& made) { return made.graph.input_format; },
                          [](const fixed::FixedLane& made) { return made.input_format; }},
                    lane);
}

}  // namespace

Module lane_module(const std::string& name, const std::vector<std::string>& inputs,
                   const design::Lane& lane, const datapath::Schedule& schedule) {
  const std::vector<InputPort> ports = operands_of_width(inputs, input_format(lane).width());
  return std::visit([&](const auto& made) { return lane_module(name, ports, made, schedule); },
                    lane);
}

}  // namespace mixcmp::rtl

#include "generator/rtl/lane_module.hpp"

#include "generator/rtl/fixed_lane_module.hpp"
#include "generator/rtl/float_lane_module.hpp"

namespace mixcmp::rtl {

Module lane_module(const std::string& name, const std::vector<std::string>& inputs,
                   const design::Lane& lane, const datapath::Schedule& schedule) {
  return std::visit([&](const auto& made) { return lane_module(name, inputs, made, schedule); },
                    lane);
}

}  // namespace mixcmp::rtl

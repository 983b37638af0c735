#pragma once

#include <string>
#include <vector>

#include "generator/emit/system_plan.hpp"

namespace mixcmp::gen {

/// One module with what its header says of it.
struct Described {
  rtl::Module module;
  std::vector<std::string> facts;
};

/// Every module of a system once, the top last, its engine
/// behind it; groups of the same hardware share theirs.
std::vector<Described> describe_modules(const model::Design& design, const SystemPlan& plan);

}  // namespace mixcmp::gen

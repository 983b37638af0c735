#include "generator/hardware/rtl/part_decision.hpp"

#include <fmt/core.h>

#include "generator/hardware/rtl/net_names.hpp"

namespace mixcmp::rtl {
namespace {

/// Concatenates one signal of every part, delayed to `cycle`; part 0 is in the lowest bits.
Operand gathered(DatapathBuilder& datapath, const std::vector<PartDecision>& parts,
                 Signal PartDecision::*signal, int cycle) {
  std::vector<Operand> fields;
  for (const PartDecision& part : parts) fields.push_back(datapath.at(part.*signal, cycle));
  return concatenation({fields.rbegin(), fields.rend()});
}

}  // namespace

PartDecision build_decision(DatapathBuilder& datapath, const datapath::Step& step, std::size_t part,
                            std::size_t parts, Decides decides, DecisionUnit unit) {
  const bool alone = parts == 1;
  const std::string suffix = part_suffix(part, parts);
  datapath.describe(step, alone ? unit.what : fmt::format("part {}, {}", part, unit.what));
  std::string instance = alone ? "decision" : datapath.pool().unique("decision" + suffix);
  const auto output = [&](const char* name, int width) {
    const std::string wire = alone ? name : datapath.pool().unique(name + suffix);
    if (!alone) datapath.add(Wire{width, wire, nullptr});
    unit.operands.push_back({name, net(wire)});
    return Signal{net(wire), wire, width, step.ready_cycle};
  };
  PartDecision decision{.verdict = output("verdict", 2), .decided = {}};
  if (decides == Decides::sometimes) decision.decided = output("decided", 1);
  datapath.add(unit_instance(step, std::move(instance), std::move(unit.parameters),
                             std::move(unit.operands)));
  return decision;
}

void build_combination(DatapathBuilder& datapath, Combination combination,
                       const std::vector<PartDecision>& parts, const datapath::Step& step) {
  if (parts.size() == 1) return;
  const bool any = combination == Combination::any;
  const int count = static_cast<int>(parts.size());
  const bool reference = parts.front().decided.value == nullptr;
  const Operand verdicts = gathered(datapath, parts, &PartDecision::verdict, step.start_cycle);
  const Operand known = reference
                            ? literal(count, low_mask(count))
                            : gathered(datapath, parts, &PartDecision::decided, step.start_cycle);
  datapath.describe(step, any ? "less if any part is." : "less if all parts are.");
  const std::string decided = reference ? datapath.pool().unique("unused_decided") : "decided";
  if (reference) datapath.add(Wire{1, decided, nullptr});
  datapath.add_unit(step, "combination", {{"PARTS", count}, {"ANY", any ? 1 : 0}},
                    {{"verdicts", verdicts},
                     {"known", known},
                     {"verdict", net("verdict")},
                     {"decided", net(decided)}});
}

}  // namespace mixcmp::rtl

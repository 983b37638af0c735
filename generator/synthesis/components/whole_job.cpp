#include "generator/synthesis/components/whole_job.hpp"

#include <fmt/core.h>

#include "generator/hardware/rtl/datapath_builder.hpp"
#include "generator/synthesis/components/synthesis_jobs.hpp"

namespace mixcmp::components {
namespace {

constexpr std::string_view alone = "mixcmp_references_alone";

/// The instance of reference k, connected to slice k of every operand and of the verdicts.
std::string instance(const characterise::SynthesisJob& reference,
                     const std::vector<rtl::InputPort>& inputs, int k) {
  std::string text = fmt::format("\n  {} reference_{} (\n    .aclk(aclk),\n", reference.top, k);
  for (const rtl::InputPort& input : inputs) {
    text += fmt::format("    .{0}({0}[{1}:{2}]),\n", input.name, (k + 1) * input.width - 1,
                        k * input.width);
  }
  return text + fmt::format("    .verdict(verdict[{}:{}])\n  );\n", 2 * k + 1, 2 * k);
}

/// The parts of `count` references.
characterise::NeededParts of_instances(const characterise::NeededParts& reference, int count) {
  characterise::NeededParts parts{.dsps = count * reference.dsps, .nets = {}};
  for (int k = 0; k < count; ++k) {
    for (characterise::NeededNet net : reference.nets) {
      net.name = fmt::format("reference_{}.{}", k, net.name);
      parts.nets.push_back(std::move(net));
    }
  }
  return parts;
}

std::string top_text(const characterise::SynthesisJob& reference,
                     const std::vector<rtl::InputPort>& inputs, int count) {
  std::string text =
      fmt::format("`default_nettype none\n\nmodule {} (\n  input  wire aclk,\n", alone);
  for (const rtl::InputPort& input : inputs) {
    text += fmt::format("  input  wire [{}:0] {},\n", count * input.width - 1, input.name);
  }
  text += fmt::format("  output wire [{}:0] verdict\n);\n", 2 * count - 1);
  for (int k = 0; k < count; ++k) text += instance(reference, inputs, k);
  return text + "\nendmodule\n\n`default_nettype wire\n";
}

std::vector<rtl::InputPort> ports_of(const scene::Scene& scene) {
  const std::vector<std::string> names = rtl::input_ports(scene.graph.inputs());
  std::vector<rtl::InputPort> ports;
  for (std::size_t k = 0; k < names.size(); ++k) {
    ports.push_back({names[k], scene.operand_formats[k].width()});
  }
  return ports;
}

}  // namespace

characterise::SynthesisJob system_job(const emit::GeneratedSystem& system) {
  const emit::Signature& signature = system.signature;
  characterise::SynthesisJob job{.sources = {},
                                 .top = signature.engine ? signature.engine->top : signature.top};
  for (const emit::GeneratedFile& file : system.files) {
    if (!file.name.ends_with(".v") && file.cells.empty()) continue;
    job.sources.push_back({file.name, without_comments(file.text), file.cells});
  }
  return job;
}

Result<characterise::SynthesisJob> references_job(const scene::Scene& scene, int count) {
  ComponentMaker maker(scene, nullptr);
  // These references take a comparison in every cycle, even if the system's are folded.
  MIXCMP_TRY(reference, maker.make(reference_key(
                            scene, {.multipliers = scene.reference_structure.multipliers,
                                    .target_mhz = scene.reference_structure.target_mhz})));
  characterise::SynthesisJob job = reference.job();
  job.sources.push_back(
      {fmt::format("{}.v", alone), top_text(reference.job(), ports_of(scene), count)});
  job.top = alone;
  job.needed = of_instances(reference.job().needed, count);
  return job;
}

}  // namespace mixcmp::components

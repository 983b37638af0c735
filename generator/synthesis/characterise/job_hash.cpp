#include "generator/synthesis/characterise/job_hash.hpp"

#include "generator/synthesis/characterise/static_timing.hpp"
#include "generator/synthesis/characterise/tools.hpp"
#include "model/base/common/content_hash.hpp"

namespace mixcmp::characterise {
namespace {

/// The version of our method. Raise it when synthesise() gets other results from the same tools.
constexpr std::string_view method = "2";

void add_timing(ContentHash& hash, const devices::Device& device, int seeds) {
  hash.add("timing").add(to_string(device.timing)).add(device.timing_synthesis);
  for (const std::string& argument : device.timing_arguments) hash.add(argument);
  if (device.timing == devices::TimingTool::yosys_sta) hash.add(shift_register_output().text);
  if (!is_routed(device)) return;
  hash.add(std::to_string(seeds));
  // A design that does not fit has no clock, so the device's size matters.
  for (const devices::Resource& resource : devices::bounded_resources) {
    hash.add(std::to_string(device.available.*resource.amount));
  }
}

}  // namespace

std::string job_hash(const SynthesisJob& job, const devices::Device& device,
                     const SynthesisOptions& options, const std::string& tools) {
  ContentHash hash;
  hash.add(method).add(tools).add(device.synthesis).add(job.top).add(job.clock_port);
  for (const SourceText& source : job.sources) {
    if (source.cells.empty() || is_cell_of(source, device)) hash.add(source.name).add(source.text);
  }
  switch (options.effort) {
    case TimingEffort::area_only: break;
    case TimingEffort::timing: add_timing(hash, device, options.seeds); break;
  }
  return hash.hex();
}

std::string imported_hash(const SynthesisJob& job, const std::string& tool) {
  ContentHash hash;
  hash.add("imported").add(tool).add(job.top).add(job.clock_port);
  for (const SourceText& source : job.sources) {
    if (source.cells.empty()) hash.add(source.name).add(source.text);  // vendors do not use cells
  }
  return hash.hex();
}

}  // namespace mixcmp::characterise

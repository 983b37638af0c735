#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "model/common/quote.hpp"
#include "model/data/sphere_family.hpp"
#include "model/scene/section.hpp"
#include "model/scene/sections.hpp"

namespace mixcmp::model {
namespace {

constexpr std::int64_t max_items = 1 << 24;
constexpr double largest_number = 1e30;

void read_data_file(Section& section, const std::filesystem::path& scene, DataSpec& spec) {
  std::string file;
  section.text("file", file);
  if (section.find("file") == nullptr) return;
  const std::array<std::string_view, 3> readable = {".pdb", ".csv", ".npy"};
  spec.file = scene.parent_path() / file;
  if (std::find(readable.begin(), readable.end(), spec.file.extension()) == readable.end()) {
    section.fail("file", "not a data file by its ending", fmt::format("\"{}\"", file),
                 "a file that ends in .pdb, .csv or .npy");
  }
}

void check_family(Section& section, const DataSpec& spec) {
  const bool given = section.find("family") != nullptr;
  if (spec.items != "sphere_family") {
    if (!given) return;
    section.fail("family", "only of items = \"sphere_family\"", in_quotes(spec.family),
                 "no family here");
    return;
  }
  const std::vector<std::string> names = sphere_family_names();
  if (!given) {
    section.fail("family", "required", "nothing", accepted_sphere_families(""));
  } else if (std::find(names.begin(), names.end(), spec.family) == names.end()) {
    section.fail("family", "not a family of sphere pairs", in_quotes(spec.family),
                 accepted_sphere_families(spec.family));
  }
  if (spec.all_pairs) {
    section.fail("pairs", "the rows of a family are pairs already", "\"all\"", "no pairs here");
  }
}

void check_data_source(Section& section, const DataSpec& spec, std::vector<std::string>& notes) {
  const bool items = section.find("items") != nullptr;
  const bool file = section.find("file") != nullptr;
  if (items == file) {
    section.fail("", items ? "two sources of data" : "no source of data",
                 items ? "items and file" : "neither items nor file",
                 "items = \"uniform_spheres\", or file = a .pdb, .csv or .npy file");
  }
  const bool family = spec.items == "sphere_family";
  if (items && !family && spec.items != "uniform_spheres") {
    section.fail("items", "not a choice", fmt::format("\"{}\"", spec.items),
                 "uniform_spheres, sphere_family");
  }
  check_family(section, spec);
  for (const char* key : {"count", "side", "radius_max", "seed"}) {
    if (section.find(key) == nullptr || !file) continue;
    notes.push_back(fmt::format("data.{} is not used: the data come from a file", key));
  }
  for (const char* key : {"side", "radius_max"}) {
    if (section.find(key) == nullptr || !family) continue;
    notes.push_back(fmt::format("data.{} is not used: a family has its own sizes", key));
  }
}

}  // namespace

Result<std::optional<DataSpec>> read_data(const Settings& settings,
                                          std::vector<std::string>& notes) {
  Section section(settings, "data");
  if (settings.root.find("data") == nullptr) return std::optional<DataSpec>();
  DataSpec spec{.line = section.line()};
  std::string pairs;
  section.text("items", spec.items);
  section.text("family", spec.family);
  read_data_file(section, settings.path, spec);
  section.integer("count", spec.count, 1, max_items);
  section.number("side", spec.side, 0, largest_number);
  section.number("radius_max", spec.radius_max, 0, largest_number);
  section.integer("seed", spec.seed, 0, std::numeric_limits<std::int64_t>::max());
  section.text("pairs", pairs);
  spec.all_pairs = pairs == "all";
  if (section.find("pairs") != nullptr && !spec.all_pairs) {
    section.fail("pairs", "not a choice", fmt::format("\"{}\"", pairs), "all");
  }
  check_data_source(section, spec, notes);
  if (const auto error = section.finish()) return *error;
  return std::optional<DataSpec>(spec);
}

}  // namespace mixcmp::model

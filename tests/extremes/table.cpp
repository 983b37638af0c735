#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "model/comparison/data/operand_source.hpp"
#include "model/comparison/data/sphere_family.hpp"
#include "model/judge/emulator/emulator.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/judge/workload/load_comparisons.hpp"
#include "model/plan/profile/lane_runner.hpp"
#include "model/plan/profile/schemes.hpp"

/// extremes_table SCENE CSV: every family of sphere pairs through every lane at some precisions.
/// Prints the tables of examples/extremes/README.md, writes the numbers to CSV; an error where a
/// certified lane is wrong. The profiled constants are those of the paper's uniform spheres.
namespace mixcmp {
namespace {

using profile::SchemeKind;

constexpr int shown_precisions[] = {8, 11, 17, 24, 32, 40, 52};

bool shown(int precision) {
  return std::find(std::begin(shown_precisions), std::end(shown_precisions), precision) !=
         std::end(shown_precisions);
}

bool shown(const std::string& family) {
  return !family.starts_with("near_tie_") || shown(std::stoi(family.substr(9)));
}

/// One family's comparisons, their true verdicts and the reference's verdicts.
class Family {
public:
  Family(std::string name, const scene::Scene& scene, const data::Comparisons& data)
      : name_(std::move(name)), block_(data.input_count(), data.size()) {
    const data::OperandSource source(data);
    source.fetch(0, data.size(), block_);
    std::vector<Bits> operands(data.input_count());
    for (std::uint64_t row = 0; row < data.size(); ++row) {
      data.fetch(row, operands);
      truth_.push_back(
          decision_of(golden::true_verdict(scene.graph, data.table().format, operands).value()));
    }
    reference_.resize(size());
    emulator::Emulator(reference_graph(scene.graph, scene.reference))
        .decide(block_.columns(), size(), reference_);
  }

  const std::string& name() const { return name_; }
  std::uint64_t size() const { return truth_.size(); }
  std::vector<Decision> decisions(const profile::LaneRunner& lane) const {
    std::vector<Decision> result(size());
    lane.decide(block_.columns(), size(), result);
    return result;
  }

  std::uint64_t ties() const { return count(truth_, Decision::equal); }
  std::uint64_t reference_wrong() const { return wrong(reference_); }
  std::uint64_t undecided(const std::vector<Decision>& decisions) const {
    return count(decisions, Decision::undecided);
  }
  /// Decided, and not as in truth.
  std::uint64_t wrong(const std::vector<Decision>& decisions) const {
    std::uint64_t wrong = 0;
    for (std::size_t row = 0; row < decisions.size(); ++row) {
      wrong += decisions[row] != Decision::undecided && decisions[row] != truth_[row] ? 1 : 0;
    }
    return wrong;
  }

private:
  static std::uint64_t count(const std::vector<Decision>& decisions, Decision counted) {
    return static_cast<std::uint64_t>(std::count(decisions.begin(), decisions.end(), counted));
  }

  std::string name_;
  data::OperandBlock block_;
  std::vector<Decision> truth_;
  std::vector<Decision> reference_;
};

struct Entry {
  std::string family;
  LaneInputs inputs;
  int precision;
  std::string scheme;
  SchemeKind kind;
  std::uint64_t comparisons, undecided, wrong;
};

Entry entry_of(const Family& family, LaneInputs inputs, int precision,
               const profile::SchemeLanes& scheme, const std::optional<design::Lane>& lane) {
  const std::vector<Decision> decisions = family.decisions(profile::LaneRunner(scheme.kind, lane));
  return {family.name(),
          inputs,
          precision,
          scheme.name,
          scheme.kind,
          family.size(),
          family.undecided(decisions),
          family.wrong(decisions)};
}

std::vector<Entry> entries_of(const Family& family, LaneInputs inputs, int first_precision,
                              const std::vector<profile::SchemeLanes>& schemes) {
  std::vector<Entry> entries;
  for (const profile::SchemeLanes& scheme : schemes) {
    for (std::size_t k = 0; k < scheme.lanes.size(); ++k) {
      const int precision = first_precision + static_cast<int>(k);
      if (!shown(precision) || !scheme.lanes[k]) continue;
      entries.push_back(entry_of(family, inputs, precision, scheme, scheme.lanes[k]));
    }
  }
  return entries;
}

/// The entry of the first scheme of this kind, whose bound a scene gets by default; or null.
const Entry* find(const std::vector<Entry>& entries, const std::string& family, LaneInputs inputs,
                  int precision, SchemeKind kind) {
  const auto entry = std::find_if(entries.begin(), entries.end(), [&](const Entry& candidate) {
    return candidate.family == family && candidate.inputs == inputs &&
           candidate.precision == precision && candidate.kind == kind;
  });
  return entry == entries.end() ? nullptr : &*entry;
}

std::string wrong_text(const Entry* entry) {
  return entry == nullptr ? "-" : fmt::format("{}", entry->wrong);
}

/// Per cent, two digits of it.
std::string rate_text(const Entry* entry) {
  if (entry == nullptr) return "-";
  if (entry->undecided == entry->comparisons) return "100";
  const double rate =
      100 * static_cast<double>(entry->undecided) / static_cast<double>(entry->comparisons);
  return rate >= 10 ? fmt::format("{:.0f}", rate) : fmt::format("{:.2g}", rate);
}

void print_head(const std::string& title, const std::string& columns) {
  fmt::print("\n{}\n\n| family |{}", title, columns);
  for (const int precision : shown_precisions) fmt::print(" L = {} |", precision);
  fmt::print("\n|---|");
  for (std::size_t k = 0; k < std::size(shown_precisions); ++k) fmt::print("---|");
  for (const char c : columns) fmt::print("{}", c == '|' ? "---|" : "");
  fmt::print("\n");
}

void print_wrong(const std::vector<Family>& families, const std::vector<Entry>& entries,
                 LaneInputs inputs) {
  print_head(fmt::format("Wrong verdicts of lanes with {} inputs: alone / profiled / certified",
                         to_string(inputs)),
             " ties | reference |");
  for (const Family& family : families) {
    fmt::print("| `{}` | {} | {} |", family.name(), family.ties(), family.reference_wrong());
    for (const int precision : shown_precisions) {
      const auto text = [&](SchemeKind kind) {
        return wrong_text(find(entries, family.name(), inputs, precision, kind));
      };
      fmt::print(" {} / {} / {} |", text(SchemeKind::lanes_alone), text(SchemeKind::profiled),
                 text(SchemeKind::certified));
    }
    fmt::print("\n");
  }
}

void print_rates(const std::vector<Family>& families, const std::vector<Entry>& entries,
                 LaneInputs inputs) {
  print_head(
      fmt::format("Recomputed, per cent, {} inputs: profiled / certified", to_string(inputs)), "");
  for (const Family& family : families) {
    fmt::print("| `{}` |", family.name());
    for (const int precision : shown_precisions) {
      const auto text = [&](SchemeKind kind) {
        return rate_text(find(entries, family.name(), inputs, precision, kind));
      };
      fmt::print(" {} / {} |", text(SchemeKind::profiled), text(SchemeKind::certified));
    }
    fmt::print("\n");
  }
}

/// The errors that the paper would have measured: all pairs of 8192 spheres, radii up to 25.
Result<std::vector<profile::ErrorProfile>> paper_errors(scene::Scene scene) {
  scene.data = data::DataSpec{.items = "uniform_spheres", .pairing = data::Pairing::all};
  MIXCMP_DO(profile::check_profile(scene, {}));
  MIXCMP_TRY(data, workload::load_comparisons(scene));
  return profile::profile_errors(scene, data, {LaneInputs::exact, LaneInputs::rounded}, {});
}

Result<std::vector<Family>> load_families(scene::Scene scene) {
  std::vector<Family> families;
  for (const std::string& name : data::sphere_family_names()) {
    if (!shown(name)) continue;
    scene.data->family = name;
    MIXCMP_TRY(data, workload::load_comparisons(scene));
    families.emplace_back(name, scene, data);
  }
  return families;
}

Result<Done> write_csv(const char* path, const std::vector<Entry>& entries) {
  std::ofstream file(path, std::ios::binary);
  file << "family,inputs,L,scheme,comparisons,undecided,wrong\n";
  for (const Entry& entry : entries) {
    file << fmt::format("{},{},{},{},{},{},{}\n", entry.family, to_string(entry.inputs),
                        entry.precision, entry.scheme, entry.comparisons, entry.undecided,
                        entry.wrong);
  }
  file.flush();
  if (file) return Done{};
  return Error{.file = path, .message = "cannot be written"};
}

Result<Done> check_certified(const std::vector<Entry>& entries) {
  for (const Entry& entry : entries) {
    if (entry.kind != SchemeKind::certified || entry.wrong == 0) continue;
    return Error{.message = fmt::format("{} with {} inputs is wrong on {} at L = {}", entry.scheme,
                                        to_string(entry.inputs), entry.family, entry.precision),
                 .received = fmt::format("{} wrong verdicts", entry.wrong),
                 .accepted = "none of a certified lane"};
  }
  return Done{};
}

Result<Done> run(const char* scene_path, const char* csv_path) {
  MIXCMP_TRY(scene, scene::load_scene(scene_path, {}));
  MIXCMP_TRY(errors, paper_errors(scene));
  MIXCMP_TRY(families, load_families(scene));
  std::vector<Entry> entries;
  for (const profile::ErrorProfile& measured : errors) {
    const auto schemes = make_schemes(scene, measured);
    for (const Family& family : families) {
      const auto found =
          entries_of(family, measured.inputs, measured.precisions.front().precision, schemes);
      entries.insert(entries.end(), found.begin(), found.end());
    }
    print_wrong(families, entries, measured.inputs);
    print_rates(families, entries, measured.inputs);
  }
  MIXCMP_DO(write_csv(csv_path, entries));
  return check_certified(entries);
}

}  // namespace
}  // namespace mixcmp

int main(int count, char** arguments) {
  if (count != 3) {
    fmt::print(stderr, "usage: extremes_table SCENE CSV\n");
    return 1;
  }
  const auto done = mixcmp::run(arguments[1], arguments[2]);
  if (done.ok()) return 0;
  fmt::print(stderr, "{}\n", done.error().to_string());
  return 1;
}

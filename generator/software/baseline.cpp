#include "generator/software/baseline.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <thread>

#include "generator/software/program.hpp"
#include "generator/software/source.hpp"
#include "model/base/number/double.hpp"
#include "model/base/number/verdict.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "model/scene/reference_model.hpp"

namespace mixcmp::software {
namespace {

// The most comparisons that are written out, since their operands fill memory.
constexpr std::uint64_t most_written_out = std::uint64_t{1} << 22;

/// A library's functions are not correctly rounded, so no filter has a proven bound.
Error no_function(const scene::Scene& scene, const Function& function) {
  return {.file = scene.path.string(),
          .field = "comparison",
          .message = "the program in double has no functions but sqrt, whose error is known",
          .received = applied_text(function, "x"),
          .accepted = "f and g of + - * / ^ sqrt abs min max"};
}

Error no_doubles(const scene::Scene& scene) {
  return {.file = scene.path.string(),
          .field = "reference.format",
          .message = "software computes in double, which does not hold the scene's numbers",
          .received = scene.reference.format.name(),
          .accepted = "at most 53 digits and 11 exponent bits"};
}

/// `count` rows of a table, or all of them, evenly spaced.
data::Table some_rows(const data::Table& table, std::uint64_t count) {
  const std::uint64_t taken = std::min<std::uint64_t>(count, table.rows());
  data::Table sample{.format = table.format, .columns = table.columns, .values = {}, .labels = {}};
  for (std::uint64_t k = 0; k < taken; ++k) {
    const auto first = table.values.begin() +
                       static_cast<std::ptrdiff_t>(k * table.rows() / taken * table.columns.size());
    sample.values.insert(sample.values.end(), first,
                         first + static_cast<std::ptrdiff_t>(table.columns.size()));
  }
  return sample;
}

/// At most `most` comparisons, evenly spaced. Each is written out as a row of its operands.
Result<data::Comparisons> written_out(const scene::Scene& scene, const data::Comparisons& data,
                                      std::uint64_t most) {
  const std::uint64_t taken = std::min(most, data.size());
  const std::size_t inputs = data.input_count();
  data::Table rows{
      .format = data.format(), .columns = scene.graph.inputs(), .values = {}, .labels = {}};
  rows.values.resize(taken * inputs);
  for (std::uint64_t k = 0; k < taken; ++k) {
    const auto index = static_cast<std::uint64_t>(Bits{k} * data.size() / taken);
    data.fetch(index, std::span(rows.values).subspan(k * inputs, inputs));
  }
  return data::Comparisons::rows(std::move(rows), scene.graph.inputs());
}

/// A sample of the data, of the same form, with about `wanted` comparisons.
Result<data::Comparisons> sample_of(const scene::Scene& scene, const data::Comparisons& data,
                                    std::uint64_t wanted) {
  const std::vector<std::string>& inputs = scene.graph.inputs();
  const auto side = [](double comparisons) {
    return static_cast<std::uint64_t>(std::sqrt(comparisons)) + 1;
  };
  const auto number = static_cast<double>(wanted);
  switch (data.pairing()) {
    case data::Pairing::rows:
      return data::Comparisons::rows(some_rows(data.table(), wanted), inputs);
    case data::Pairing::all:
      return data::Comparisons::all_pairs(some_rows(data.table(), side(2 * number)), inputs);
    case data::Pairing::cross:
      return data::Comparisons::cross(some_rows(data.tables()[0], side(number)),
                                      some_rows(data.tables()[1], side(number)), inputs);
    case data::Pairing::arg_min: break;
  }
  MIXCMP_CHECK(false);
}

char letter(Verdict verdict) {
  switch (verdict) {
    case Verdict::less: return '<';
    case Verdict::equal: return '=';
    case Verdict::greater: return '>';
    case Verdict::unordered: return 'u';
  }
  MIXCMP_CHECK(false);
}

constexpr char undetermined = '?';

char letter(const std::optional<Verdict>& truth) {
  return truth ? letter(*truth) : undetermined;
}

VerdictCounts count_letters(const std::string& letters) {
  const auto count = [&](char c) {
    return static_cast<std::uint64_t>(std::count(letters.begin(), letters.end(), c));
  };
  return {count('<'), count('='), count('>'), count('u')};
}

/// The letters that the judges give one comparison.
struct ExpectedLetters {
  char golden, reference, truth;
};

class Judges {
public:
  explicit Judges(const scene::Scene& scene)
      : scene_(scene),
        doubles_(reference_graph(scene.graph, {software_format()})),
        reference_(scene::reference_model(scene).value()) {}

  ExpectedLetters judge(const std::vector<Bits>& operands) const {
    std::vector<Bits> doubles;
    for (const Bits operand : operands) {
      const auto exact = golden::convert({software_format()}, scene_.reference.format, operand);
      doubles.push_back(exact.bits);
    }
    return {letter(golden::evaluate_reference(doubles_, doubles)),
            letter(golden::evaluate_reference(reference_, operands)),
            letter(golden::true_verdict(scene_.graph, software_format(), doubles))};
  }

private:
  const scene::Scene& scene_;
  TypedGraph doubles_;
  fixed::ReferenceDatapath reference_;
};

void count(BaselineCheck& check, const std::vector<KernelOutput>& kernels, std::size_t index,
           const ExpectedLetters& judgement) {
  const char exact = kernels.front().letters[index];
  const bool known = judgement.truth != undetermined;
  const bool defined = known && judgement.truth != letter(Verdict::unordered);
  check.undetermined += known ? 0 : 1;
  check.wrong += exact != judgement.golden ? 1 : 0;
  check.unlike_reference += exact != judgement.reference ? 1 : 0;
  check.not_true += defined && exact != judgement.truth ? 1 : 0;
  for (std::size_t k = 1; k < kernels.size(); ++k) {
    const char decided = kernels[k].letters[index];
    check.decided_wrongly += known && decided != '?' && decided != judgement.truth ? 1 : 0;
  }
}

Result<BaselineCheck> check_sample(const SoftwareProgram& program, const scene::Scene& scene,
                                   const data::Comparisons& data, std::uint64_t wanted) {
  MIXCMP_TRY(sample, sample_of(scene, data, wanted));
  MIXCMP_TRY(kernels, program.verdicts(sample));
  BaselineCheck check{.comparisons = sample.size()};
  const Judges judges(scene);
  std::vector<Bits> operands(sample.input_count());
  for (std::size_t index = 0; index < sample.size(); ++index) {
    sample.fetch(index, operands);
    count(check, kernels, index, judges.judge(operands));
  }
  // The letters are computed one comparison at a time. Long runs, which go through other code, must
  // count the same verdicts.
  const VerdictCounts expected = count_letters(kernels.front().letters);
  for (const KernelOutput& kernel : kernels) check.wrong += kernel.verdicts == expected ? 0 : 1;
  return check;
}

MeasuredRate over_rounds(const std::vector<MeasuredRate>& rates, unsigned threads) {
  std::vector<MeasuredRate> rounds;
  std::copy_if(rates.begin(), rates.end(), std::back_inserter(rounds),
               [&](const MeasuredRate& rate) { return rate.threads == threads; });
  MIXCMP_CHECK(!rounds.empty());
  std::sort(rounds.begin(), rounds.end(), [](const MeasuredRate& a, const MeasuredRate& b) {
    return a.best_per_s < b.best_per_s;
  });
  MeasuredRate all = rounds.back();
  const std::size_t half = rounds.size() / 2;
  all.median_per_s = (rounds[half].best_per_s + rounds[(rounds.size() - 1) / 2].best_per_s) / 2;
  return all;
}

std::string processor_name() {
  std::ifstream processors("/proc/cpuinfo");
  for (std::string line; std::getline(processors, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::optional<BoundKind> kind_of(const std::string& name) {
  for (const auto kind : {BoundKind::relative, BoundKind::running, BoundKind::constant}) {
    if (name == to_string(kind)) return kind;
  }
  return std::nullopt;
}

}  // namespace

bool Baseline::passed() const {
  return check.wrong == 0 && check.decided_wrongly == 0 &&
         std::all_of(kernels.begin(), kernels.end(), [this](const BaselineKernel& kernel) {
           return kernel.verdicts == exact().verdicts;
         });
}

const BaselineKernel& Baseline::fastest() const {
  return *std::max_element(kernels.begin(), kernels.end(),
                           [](const BaselineKernel& a, const BaselineKernel& b) {
                             return a.all_cores.best_per_s < b.all_cores.best_per_s;
                           });
}

Result<Baseline> software_baseline(const scene::Scene& scene, const data::Comparisons& data,
                                   const BaselineOptions& options) {
  if (!fits_double(scene.reference.format)) return no_doubles(scene);
  if (const auto function = scene.graph.first_function()) return no_function(scene, *function);
  if (!has_software_loops(data.pairing())) {
    MIXCMP_TRY(rows, written_out(scene, data, most_written_out));
    return software_baseline(scene, rows, options);
  }
  const FloatFilters filters = float_filters(scene);
  MIXCMP_TRY(program, SoftwareProgram::compile(scene, data, filters, options));
  MIXCMP_TRY(check, check_sample(program, scene, data, options.sample));
  const unsigned threads =
      options.threads != 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  MIXCMP_TRY(outputs, program.measure(data, threads));
  Baseline baseline{.scene = scene.name,
                    .processor = processor_name(),
                    .compiler = program.compiler(),
                    .compile_command = shell_line(program.command()),
                    .comparisons = data.size(),
                    .threads = threads,
                    .seconds = options.seconds,
                    .rounds = options.rounds,
                    .kernels = {},
                    .missing = filters.missing,
                    .check = check};
  for (const KernelOutput& output : outputs) {
    baseline.kernels.push_back({.filter = kind_of(output.name),
                                .verdicts = output.verdicts,
                                .recomputed = output.recomputed,
                                .one_core = over_rounds(output.rates, 1),
                                .all_cores = over_rounds(output.rates, threads)});
  }
  return baseline;
}

}  // namespace mixcmp::software

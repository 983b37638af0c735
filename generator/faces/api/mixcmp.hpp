#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// The C++ library of mixcmp: from a scene to Verilog, to the verdicts of its hardware, to a
/// simulation that checks them, to the counts of a profile and to a plan. docs/library.md shows it
/// at work.
///
/// Values are cheap to copy and own their contents. A value must not be used after it was moved
/// from. Functions that the header calls const may run in several threads at once. A user's mistake
/// throws Error; a failure of the machine, such as no memory, throws another std::exception. A
/// change that would break a program which uses this header comes with a new minor version as long
/// as the major version is 0.
namespace mixcmp::api {

#define MIXCMP_API __attribute__((visibility("default")))

/// "0.1.0", the version that stands in the header of generated files.
MIXCMP_API std::string version();

/// A user's mistake. what() returns the message that the program would print. Members that have no
/// meaning for the mistake are empty, or 0.
class MIXCMP_API Error : public std::runtime_error {
public:
  /// The place of a mistake, the text received there, and the accepted values.
  struct Details {
    std::string file;
    int line = 0;
    std::string field;  ///< the key of the scene, "reduced.format", or the option
    std::string message;
    std::string received;
    std::string accepted;
    bool missing_tool = false;  ///< a program is needed that is not installed
  };

  Error(const std::string& text, Details details);
  ~Error() override;

  const Details& details() const { return *details_; }

private:
  std::shared_ptr<const Details> details_;  ///< shared, so that copies cannot throw
};

/// The order of f and g. The values are those of the two verdict bits in hardware.
enum class Verdict : std::uint8_t {
  less = 0,
  equal = 1,
  greater = 2,
  unordered = 3,  ///< f or g has no value: a NaN, a division by zero, the root of a negative number
};

/// "less", "equal", "greater" or "unordered".
MIXCMP_API std::string_view to_string(Verdict verdict);

/// The answer of a system to one comparison, in the bits of m_axis_tdata (docs/ports.md). Bits 1
/// and 0 are the verdict. Bit 2 is set if a reference or a second lane has recomputed it. Bit 3 is
/// set if nothing decided it; the verdict then has no meaning.
class Answer {
public:
  static constexpr std::uint8_t verdict_mask = 3, recomputed_bit = 4, undecided_bit = 8;

  explicit constexpr Answer(std::uint8_t bits = undecided_bit) : bits_(bits) {}

  constexpr Verdict verdict() const { return static_cast<Verdict>(bits_ & verdict_mask); }
  constexpr bool is_recomputed() const { return (bits_ & recomputed_bit) != 0; }
  /// Never true for a system that has references.
  constexpr bool is_undecided() const { return (bits_ & undecided_bit) != 0; }
  constexpr std::uint8_t bits() const { return bits_; }

  friend constexpr bool operator==(const Answer&, const Answer&) = default;

private:
  std::uint8_t bits_;
};

struct SceneState;

/// A validated scene: the functions f and g, their inputs, the formats, the system and the data.
/// docs/scene_file.md lists the keys.
///
/// Operands of comparisons are given as rows: one number for each of inputs(), in that order, and
/// one row after the other. Each number is rounded to the reference format, as those of data files
/// are. It is an Error if the numbers fill no whole row, or if a finite one is beyond the largest
/// number of the format.
class MIXCMP_API Scene {
public:
  /// Reads a scene, or a plan with its scene. `settings` are "section.key=value", as --set has
  /// them.
  static Scene from_file(const std::filesystem::path& file,
                         const std::vector<std::string>& settings = {});
  /// Reads a scene from a text in TOML. File names in it are relative to `folder`.
  static Scene from_text(std::string_view toml, const std::vector<std::string>& settings = {},
                         const std::filesystem::path& folder = ".");

  Scene(const Scene&);
  Scene& operator=(const Scene&);
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;
  ~Scene();

  /// Returns a copy of the scene whose data are these comparisons instead of those of [data].
  Scene with_operands(std::span<const double> rows) const;

  const std::string& name() const;
  const std::vector<std::string>& inputs() const;
  std::string f() const;  ///< as written, on one line; several parts are separated by "; "
  std::string g() const;
  std::string reference_format() const;  ///< "s53e8"; of integers, that of the model
  std::string reduced_format() const;    ///< "s17e8", "q13", "block13" or "auto"
  /// Remarks for the user, such as on constants that the reference format rounds.
  const std::vector<std::string>& notes() const;

  std::uint64_t comparison_count() const;  ///< 0 without data
  /// The operands of `count` comparisons from number `first` on, as rows. It is an Error if the
  /// data have fewer, or where a reference format beyond double has a number that double has not.
  std::vector<double> operands(std::uint64_t first, std::size_t count) const;
  /// The order of the real numbers f and g of each row, by interval arithmetic of growing
  /// precision; none where the highest precision, which docs/verification.md names, still leaves
  /// the order open.
  std::vector<std::optional<Verdict>> true_verdicts(std::span<const double> rows) const;

  /// Return the output of `mixcmp check` for the scene, as text and as JSON.
  std::string summary() const;
  std::string summary_json() const;

private:
  friend struct Access;
  explicit Scene(std::shared_ptr<const SceneState> state);

  std::shared_ptr<const SceneState> state_;
};

/// One generated file.
struct File {
  std::string name;  ///< without folders
  std::string text;
};

/// Lanes of one kind.
struct LaneGroup {
  std::string format;  ///< "s17e8" or "q13"
  int count = 0;
  int latency_cycles = 0;
  bool certified = false;
  std::string decision;  ///< when such a lane decides, in words
};

/// The system that `mixcmp generate` writes for a scene: its files, and the answers it gives.
class MIXCMP_API System {
public:
  /// Makes every choice that the scene leaves open. It is an Error if an "auto" needs an option, or
  /// if a lane of the scene does not exist.
  explicit System(const Scene& scene);

  System(const System&);
  System& operator=(const System&);
  System(System&&) noexcept;
  System& operator=(System&&) noexcept;
  ~System();

  const std::string& top() const;  ///< the name of the top module
  bool certified() const;          ///< no lane can decide wrongly
  int lane_count() const;          ///< p_L
  int reference_count() const;     ///< p_H
  const std::vector<LaneGroup>& lanes() const;
  const std::vector<std::string>& notes() const;

  /// Computes the answers of a lane of group number `group` and of the second tier and references
  /// behind it, by the emulator. They equal those of the hardware bit for bit.
  std::vector<Answer> emulate(std::span<const double> rows, std::size_t group = 0) const;
  /// Computes the answers of emulate() by the golden model instead, in MPFR. It is slower, and it
  /// shares no arithmetic with the emulator.
  std::vector<Answer> evaluate(std::span<const double> rows, std::size_t group = 0) const;

  /// The files: Verilog, signature, file list, constraint. For a scene from a file they equal those
  /// of `mixcmp generate` byte for byte.
  const std::vector<File>& files() const;
  /// Writes the files as the whole content of `folder`. An existing folder is replaced only where
  /// it is empty or holds an earlier output.
  void write(const std::filesystem::path& folder) const;

private:
  struct State;
  std::shared_ptr<const State> state_;
};

enum class Simulator {
  verilator,
  icarus,  ///< for small systems and thousands of comparisons
};

enum class Traffic {
  full_rate,
  stressed,  ///< random gaps and backpressure
};

/// The verdicts that are also compared with the order of the real numbers f and g.
enum class Truth {
  off,
  recomputed,  ///< only those of references
  all,
};

/// The options of verify(), as `mixcmp verify` has them.
struct VerifyOptions {
  Simulator simulator = Simulator::verilator;
  Traffic traffic = Traffic::full_rate;
  Truth truth = Truth::off;
  std::optional<std::uint64_t> first;   ///< only the first N comparisons
  std::optional<std::uint64_t> sample;  ///< only N comparisons, spread over all
  std::optional<std::uint64_t> only;    ///< only this comparison, counted from 0
  std::uint64_t seed = 1;               ///< of `sample` and of stressed traffic
  int resets = 0;                       ///< resets in mid-stream, 0..1000000
  int jobs = 0;                         ///< simulators side by side; 0: one a processor
  bool find_counterexample = true;      ///< after a failure, look for a shorter run that fails
  /// The folder for Verilog, builds and logs; empty: TOP_simulation in the current folder. A later
  /// run finds its build there again.
  std::filesystem::path work;
  /// Called with a line on the current action; from any thread, but one call at a time. It must not
  /// throw.
  std::function<void(const std::string& line)> progress;
};

/// The findings of a simulation.
struct Verification {
  bool passed = false;  ///< each result came back once, right, and no stream broke its contract
  std::uint64_t comparisons = 0;  ///< results compared with the model
  std::uint64_t recomputations = 0;
  std::uint64_t undecided = 0;
  std::uint64_t mismatches = 0;       ///< results that differ from the model's
  std::uint64_t violations = 0;       ///< of the streams' contract
  std::vector<std::string> not_done;  ///< parts beside the verdicts that failed, with reasons
  std::string text;                   ///< the output of `mixcmp verify`
  std::string json;                   ///< its output with --json: docs/verification.md
};

/// Generates the scene's system, simulates it on the scene's data, and compares each result with
/// the model of its lane:
///
///     const Scene scene = Scene::from_file("scene.toml");
///     const Verification run = verify(scene, {.first = 1000, .work = "simulation"});
///     if (!run.passed) throw std::runtime_error(run.text);
///     log << run.comparisons << " comparisons, " << run.recomputations << " recomputed";
///     System(scene).write("rtl");  // its signature lists the run
///
/// It starts Verilator and a C++ compiler, or Icarus Verilog. It is an Error if the scene has no
/// data, if a selection names no comparison, or if the simulator is not installed: then
/// Error::Details::missing_tool is set. Wrong results are no Error. The result is kept on record in
/// $XDG_CACHE_HOME/mixcmp, from which the signatures of later systems of the same design list it.
MIXCMP_API Verification verify(const Scene& scene, const VerifyOptions& options = {});

/// Called with the name of a step and the share of it that is done, 0..1; from any thread, but one
/// call at a time. It must not throw.
using Progress = std::function<void(const std::string& step, double share)>;

/// The options of profile(), as `mixcmp profile` has them.
struct ProfileOptions {
  std::optional<int> first_precision;  ///< the lowest L; none: the lowest there is
  std::optional<int> last_precision;   ///< the highest L; none: the highest there is
  /// The number of comparisons on which relative errors are measured; 0: none, and there are no
  /// profiled lanes.
  std::uint64_t error_samples = 1'000'000;
  unsigned threads = 0;  ///< 0: one per processor; results do not depend on it
  Progress progress;
};

/// Counts of all comparisons in lanes of one kind at one precision.
struct Counts {
  int precision = 0;
  std::uint64_t undecided = 0;      ///< comparisons that a reference recomputes
  std::uint64_t wrong = 0;          ///< verdicts that differ from the order of the real f and g
  std::uint64_t wrong_by_lane = 0;  ///< of these, those that a lane decided; 0 if certified
};

/// One kind of lane: its error bound, and its counts at each precision at which it exists.
struct Scheme {
  std::string name;  ///< "relative", "running_4", ...; "lanes_alone": no bound, no recomputation
  bool certified = false;
  std::vector<Counts> counts;
};

/// Relative errors of f and g, measured on the data and proven; none where there is no bound.
struct RelativeErrors {
  int precision = 0;
  std::optional<double> f, g;
  std::optional<double> f_bound, g_bound;
};

/// Errors, recomputations and wrong verdicts of a scene's data: docs/choosing.md.
struct Profile {
  std::uint64_t comparisons = 0;
  std::uint64_t reference_wrong = 0;  ///< wrong verdicts if references decide all
  std::uint64_t undetermined = 0;     ///< comparisons whose true verdict is not known
  std::vector<RelativeErrors> errors;
  std::vector<Scheme> schemes;
};

/// Counts errors, recomputations and wrong verdicts on the scene's data, for lanes with the scene's
/// kind of inputs. It is an Error if the scene has no data.
MIXCMP_API Profile profile(const Scene& scene, const ProfileOptions& options = {});

/// The options of plan(), as `mixcmp optimise` has them.
struct PlanOptions {
  /// Areas and clocks, made by `mixcmp characterise`; empty: the default place beside the scene.
  std::filesystem::path table;
  std::optional<int> first_precision;
  std::optional<int> last_precision;
  std::optional<double> lane_mhz;  ///< in place of the table's clocks
  std::optional<double> reference_mhz;
  /// The path at which the caller will write Plan::toml. The plan names its scene relative to this
  /// path. If it is empty, the path is plan.toml beside the scene.
  std::filesystem::path plan_file;
  Progress progress;
};

/// The best plan at one precision.
struct PlanPoint {
  int precision = 0;
  int lanes = 0;       ///< p_L; 0: nothing fits
  int references = 0;  ///< p_H
  double clock_mhz = 0;
  double recomputation_rate = 0;
  double throughput_per_s = 0;
  std::string kinds;  ///< "95 x s12e8 exact relative embedded"; where nothing fits, why
};

/// The plans of a scene on its device.
struct Plan {
  std::optional<PlanPoint> best;  ///< none: no plan fits the device
  std::vector<PlanPoint> points;  ///< by precision: figure 9 of the paper
  double baseline_per_s = 0;      ///< of the device filled with references only
  std::vector<std::string> notes;
  std::string text;  ///< the output of `mixcmp optimise` for one formulation
  /// A plan file with the best plan. Scene::from_file and the program read it in place of the
  /// scene. Empty where no plan fits, and for a scene from a text, which a file cannot name.
  std::string toml;
};

/// Finds L, p_L, p_H and the kinds of lanes with the highest throughput: docs/choosing.md. A
/// variant of the scene is planned by itself, with the setting comparison.variant. It is an Error
/// if there is no table, or if the scene has no data to count recomputations on.
MIXCMP_API Plan plan(const Scene& scene, const PlanOptions& options = {});

}  // namespace mixcmp::api

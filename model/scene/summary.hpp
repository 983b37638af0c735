#pragma once

#include <cstdint>

#include "model/comparison/data/comparisons.hpp"
#include "model/comparison/data/input_sources.hpp"
#include "model/lane/error/range_analysis.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::scene {

struct OperatorCount {
  Operation operation;
  FloatFormat operand_format;
  FloatFormat format;
  int count;
};

enum class Possibility {
  ruled_out,
  possible,
  unknown,  ///< an input that matters has no declared range
};
std::string_view to_string(Possibility possibility);

/// A question that the declared ranges may answer: whether an event, or a sign, is possible.
struct RangeQuestion {
  std::string question;
  Possibility answer = Possibility::ruled_out;
  std::vector<std::string> operations;  ///< where the event may happen, as expressions
  std::vector<std::string> rangeless;   ///< the inputs whose missing range leaves the answer open
};

/// f or g in the reference format.
struct SideSummary {
  std::string name;
  std::string text;
  Range value;  ///< the reference's finite results
  RangeQuestion negative;
  RangeQuestion zero;
};

/// The hardware that a certified lane saves, by its range checks or known signs.
struct LaneSavings {
  std::vector<std::string> checked_inputs;
  int operations = 0;  ///< operations that have a hardware unit
  int without_special_operands = 0, without_overflow = 0, without_underflow = 0;
  int sums = 0;
  int without_cancellation = 0;
};

/// The reference datapath or a lane.
struct DatapathSummary {
  std::string name;
  Arithmetic arithmetic;
  std::vector<OperatorCount> operators;  ///< in order of first use
  std::vector<RangeQuestion> events;     ///< one per event that its operations can have
  std::optional<LaneSavings> savings;    ///< for certified lanes; none for others
};

/// Whether the reference rounds at all in this scene.
struct Exactness {
  bool exact = false;          ///< every verdict of a reference is the order of the real numbers
  std::string first_rounding;  ///< the first operation that may round, as an expression
  /// The first fused sum that, within the declared ranges, may err by more than the composed one,
  /// as an expression; empty if there is none (docs/error_bounds.md, theorem 12).
  std::string first_loose_sum;
};

struct DataSummary {
  std::string source;
  data::Pairing pairing = data::Pairing::rows;
  std::uint64_t rows = 0;
  std::string with;             ///< the second table, if there is one
  std::uint64_t with_rows = 0;  ///< rows of the second table; with arg_min, the candidates
  std::uint64_t comparisons = 0;
  std::uint64_t out_of_range = 0;  ///< numbers of the table that break a declared range
  std::string first_out_of_range;  ///< the first of them in words; empty if none
  std::uint64_t off_grid =
      0;  ///< numbers of the table that are no multiple of their grid, promised or declared
  std::string first_off_grid;
  data::LostNumbers lost;
  std::vector<data::InputSource> inputs;  ///< which column feeds which input
};

/// The content of `mixcmp check`'s report.
struct Summary {
  const Scene* scene;
  std::vector<SideSummary> sides;          ///< f, g; for several parts f[0], g[0], f[1], ...
  std::vector<DatapathSummary> datapaths;  ///< reference; lanes, except those in format "auto"
  Exactness reference;
  std::optional<DataSummary> data;
};

/// The label of each of scene.lane_groups(): "lane" if there is one, else "lanes 0-5", "lane 6".
std::vector<std::string> lane_group_labels(const Scene& scene);

/// The summary keeps a pointer to `scene`, which must outlive it. `data`: the scene's comparisons;
/// null if they were not read.
Summary summarise(const Scene& scene, const data::Comparisons* data);

}  // namespace mixcmp::scene

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/rtl_templates/fp/units_program.hpp"
#include "tests/rtl_templates/fp/units_under_test.hpp"

namespace mixcmp::test {

/// Columns of UnitsUnderTest, both ends included.
struct ColumnRange {
  int first;
  int last;

  bool contains(int slot) const {
    const int column = slot % UnitsUnderTest::columns;
    return first <= column && column <= last;
  }
  bool has_promises() const { return last >= UnitsUnderTest::masks; }
};

/// Feeds one stimulus a cycle, and compares every slot's answer with the golden model's in the very
/// cycle that the slot's latency names.
class Regression {
public:
  /// `columns` are the columns that were built. `program` is printed in the command that repeats a
  /// failure.
  Regression(Simulation& simulation, const UnitsUnderTest& units, ColumnRange columns,
             std::string program);

  void feed(const Stimulus& stimulus);
  /// Feeds until the last answer is out.
  void drain();

  uint64_t vectors() const { return cycle_; }
  uint64_t answers() const { return answers_; }
  uint64_t failures() const { return failures_; }
  /// The built slots to which every stimulus broke a promise.
  std::vector<int> idle_slots() const;
  /// The origin of a vector, which a failure prints.
  void set_origin(std::string origin) { origin_ = std::move(origin); }

private:
  struct Expectation {
    Stimulus stimulus;
    std::array<Answer, UnitsUnderTest::behaviours> answers;
    std::array<HazardSet, UnitsUnderTest::behaviours> hazards;
  };

  void compare(int slot);
  void judge(int slot, const Stimulus& stimulus, const Answer& expected);
  void report(int slot, const Stimulus& stimulus, const Answer& expected) const;

  Simulation& simulation_;
  const UnitsUnderTest& units_;
  ColumnRange columns_;
  std::string program_;
  std::string origin_;
  std::vector<Expectation> history_;  ///< a ring of max_latency + 1 cycles
  uint64_t cycle_ = 0;
  uint64_t answers_ = 0;
  std::array<uint64_t, UnitsUnderTest::slots> kept_promises_ = {};
  uint64_t failures_ = 0;
};

}  // namespace mixcmp::test

// The programs that test fp_units. The command line says which vectors a program feeds.
#include "tests/rtl_templates/fp/units_program.hpp"

#include <fmt/core.h>

#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

#include "tests/rtl_templates/fp/regression.hpp"
#include "tests/rtl_templates/fp/vectors.hpp"

namespace mixcmp::test {
namespace {

template <class Number>
Number parse(std::string_view text, int base) {
  Number value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (status != std::errc{} || end != text.data() + text.size()) {
    fmt::print(stderr, "not a number: {}\n", text);
    std::exit(2);
  }
  return value;
}

/// Hexadecimal digits, with or without 0x in front.
Bits parse_bits(std::string_view text) {
  if (text.starts_with("0x")) text.remove_prefix(2);
  const std::string padded =
      std::string(32 - std::min<size_t>(32, text.size()), '0') + std::string(text);
  return Bits{parse<uint64_t>(padded.substr(0, 16), 16)} << 64 |
         parse<uint64_t>(padded.substr(16), 16);
}

FloatFormat format(int precision, int exponent_bits) {
  return FloatFormat::make(precision, exponent_bits).value();
}

void feed_every_pair(Regression& regression, FloatFormat operands) {
  const Bits count = Bits{1} << operands.width();
  regression.set_origin("every pair");
  for (Bits a = 0; a < count; ++a) {
    for (Bits b = 0; b < count; ++b) regression.feed({a, b, (a ^ b) % 7 == 3});
  }
}

void feed_special_pairs(Regression& regression, const UnitsUnderTest& units) {
  const std::vector<Bits> values = special_values(units.operands(), units.result());
  regression.set_origin("special values");
  for (const Bits a : values) {
    for (const Bits b : values) regression.feed({a, b});
  }
}

using Generator = Stimulus (*)(FloatFormat, FloatFormat, uint64_t, uint64_t);

void feed_random(Regression& regression, const UnitsUnderTest& units, Generator generate,
                 std::span<const std::string_view> arguments) {
  const uint64_t count = parse<uint64_t>(arguments[1], 10);
  const uint64_t seed = parse<uint64_t>(arguments[2], 10);
  for (uint64_t i = 0; i < count; ++i) {
    regression.set_origin(fmt::format("{} {} {}, number {}", arguments[0], count, seed, i));
    regression.feed(generate(units.operands(), units.result(), seed, i));
  }
}

/// Writes the three files that fp_units_tb.v reads.
void write_vectors(const UnitsUnderTest& units, std::span<const std::string_view> arguments) {
  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  std::ofstream latencies(folder / "latencies.hex"), stimuli(folder / "stimuli.hex"),
      answers(folder / "answers.hex");
  for (int slot = 0; slot < UnitsUnderTest::slots; ++slot) {
    latencies << fmt::format("{:x}\n", units.latency_cycles(slot));
  }
  const uint64_t count = parse<uint64_t>(arguments[2], 10);
  const uint64_t seed = parse<uint64_t>(arguments[3], 10);
  for (uint64_t i = 0; i < count; ++i) {
    const Stimulus stimulus = random_stimulus(units.operands(), units.result(), seed, i);
    stimuli << fmt::format("{:d}{}{}\n", stimulus.exceptional, to_hex(stimulus.a, 128),
                           to_hex(stimulus.b, 128));
    for (int behaviour = 0; behaviour < UnitsUnderTest::behaviours; ++behaviour) {
      const Answer answer = units.answer(behaviour, stimulus);
      const int flags = 4 * answer.y_matters + 2 * answer.flag_matters + answer.flag;
      answers << fmt::format("{:x}{}\n", flags, to_hex(answer.y, 128));
    }
  }
}

/// Feeds the stimuli that the arguments name; false if it does not understand them.
bool feed(Regression& regression, const UnitsUnderTest& units,
          std::span<const std::string_view> arguments) {
  const std::string_view mode = arguments.empty() ? "" : arguments[0];
  const size_t count = arguments.size();
  if (mode == "exhaustive" && count == 1) {
    feed_every_pair(regression, units.operands());
  } else if (mode == "special" && count == 1) {
    feed_special_pairs(regression, units);
  } else if (mode == "random" && count == 3) {
    feed_random(regression, units, random_stimulus, arguments);
  } else if (mode == "neighbours" && count == 3) {
    feed_random(regression, units, neighbour_stimulus, arguments);
  } else if (mode == "pair" && (count == 3 || count == 4)) {
    regression.set_origin("the command line");
    regression.feed(
        {parse_bits(arguments[1]), parse_bits(arguments[2]), count == 4 && arguments[3] == "1"});
  } else {
    return false;
  }
  regression.drain();
  return true;
}

/// Whether some stimulus kept the promises of every slot. If every stimulus broke them, anything
/// would pass.
bool every_slot_tested(const Regression& regression, const UnitsUnderTest& units) {
  for (const int slot : regression.idle_slots()) {
    fmt::print("{}: every pair broke a promise\n", units.name(slot));
  }
  return regression.idle_slots().empty();
}

}  // namespace

int run_units(const BuiltUnits& built, Simulation& simulation, int argc, char** argv) {
  const char* program = argv[0];
  const std::vector<std::string_view> arguments(argv + 1, argv + argc);
  const UnitsUnderTest units(format(built.precision, built.exponent_bits),
                             format(built.result_precision, built.result_exponent_bits),
                             parse_bits(built.some_cuts));
  if (arguments.size() == 4 && arguments[0] == "write") {
    write_vectors(units, arguments);
    return 0;
  }
  Regression regression(simulation, units, {built.first_column, built.last_column}, program);
  const auto start = std::chrono::steady_clock::now();
  if (!feed(regression, units, arguments)) {
    fmt::print(stderr,
               "usage: {} exhaustive | special | neighbours COUNT SEED | random COUNT SEED |"
               " pair A B [FLAG]\n",
               program);
    return 2;
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  fmt::print("{} -> {}: {} vectors, {} answers, {} wrong, {:.1f} s\n", units.operands().name(),
             units.result().name(), regression.vectors(), regression.answers(),
             regression.failures(), seconds.count());
  const bool thorough = arguments[0] != "exhaustive" || every_slot_tested(regression, units);
  return regression.failures() == 0 && thorough ? 0 : 1;
}

}  // namespace mixcmp::test

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/generator/project_fixture.hpp"

namespace mixcmp::test::packing_command_test {
namespace {

class Packing : public ProjectTest {};

/// A vector is the expected result and the operands, highest digit first.
TEST_F(Packing, MakesTheOperandsOfTheVectors) {
  generate("--project yosys --vectors 64");
  write("again.c", R"(
#include <stdio.h>
#include <stdlib.h>
#include "rtl/integration/scene_s8e8_2x1_packing.h"
int main(void) {
  char line[1000];
  while (fgets(line, sizeof line, stdin)) {
    if (strchr("/\n", line[0]) != NULL) continue;
    uint8_t bytes[SCENE_S8E8_2X1_OPERANDS_BYTES], again[SCENE_S8E8_2X1_OPERANDS_BYTES];
    const char *digits = strchr(line, '_') + 1;
    for (int k = 0; k < (int)sizeof bytes; ++k) {
      const char *place = digits + 2 * (sizeof bytes - 1 - k);
      const char pair[3] = {place[0], place[1], 0};
      bytes[k] = (uint8_t)strtoul(pair, 0, 16);
    }
    const struct scene_s8e8_2x1_operands to = scene_s8e8_2x1_unpack_operands(bytes);
    if (scene_s8e8_2x1_pack_operands(&to, again) != 0) return 1;
    if (memcmp(bytes, again, sizeof bytes) != 0) return 2;
    printf("%a,%a\n", to.a, to.b);
  }
  return 0;
}
)");
  const Outcome run = in_folder(
      "cc -std=c99 -Wall -Wextra -pedantic -Werror again.c -o again && "
      "./again < rtl/testbench/scene_s8e8_2x1_tb.hex");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const auto rows_of = [](const std::string& text) {
    std::vector<std::pair<float, float>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      rows.emplace_back(std::strtof(line.c_str(), nullptr),
                        std::strtof(line.c_str() + line.find(',') + 1, nullptr));
    }
    return rows;
  };
  const auto vectors = rows_of(run.output), data = rows_of(read("data.csv"));
  EXPECT_EQ(vectors.size(), 64);
  const auto of_data = std::count_if(vectors.begin(), vectors.end(), [&](const auto& vector) {
    return std::find(data.begin(), data.end(), vector) != data.end();
  });
  EXPECT_GE(of_data, 56) << "an eighth has special values";
}

}  // namespace
}  // namespace mixcmp::test::packing_command_test

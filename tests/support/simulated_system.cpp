#include "tests/support/simulated_system.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "generator/hardware/emit/system.hpp"

namespace mixcmp::test {

namespace fs = std::filesystem;

fs::path test_work_dir(const std::string& name) {
  return fs::path(MIXCMP_TEST_WORK_DIR) / name;
}

fs::path generate_to(const design::Design& design, const std::string& folder) {
  const auto system = emit::generate_system(design, "mixcmp generate test.toml");
  EXPECT_TRUE(system.ok()) << system.error().to_string();
  const fs::path directory = test_work_dir(folder);
  const auto written = emit::write_system(*system, directory);
  EXPECT_TRUE(written.ok()) << written.error().to_string();
  return directory;
}

verilator_tb::VerifyReport simulate(const design::Design& design, const data::Comparisons& data,
                                    verilator_tb::VerifyOptions options) {
  // Tests run side by side: each process has its Verilog, all share the builds.
  const fs::path rtl = generate_to(design, fmt::format("rtl_{}", getpid()));
  options.work_dir = test_work_dir("builds");
  const auto report =
      verilator_tb::verify(design, data, verilator_tb::load_system(rtl).value(), options);
  std::error_code ignored;
  fs::remove_all(rtl, ignored);
  EXPECT_TRUE(report.ok()) << report.error().to_string();
  return report.ok() ? *report : verilator_tb::VerifyReport{};
}

}  // namespace mixcmp::test

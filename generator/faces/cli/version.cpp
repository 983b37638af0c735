#include "generator/faces/cli/version.hpp"

#include <fmt/core.h>
#include <gmp.h>
#include <mpfr.h>

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "generator/faces/cli/commit.hpp"
#include "generator/faces/cli/doctor.hpp"
#include "generator/hardware/emit/version.hpp"
#include "generator/present/report/json_text.hpp"
#include "model/base/common/quote.hpp"

namespace mixcmp::cli {
namespace {

std::string compiler() {
#ifdef __clang__
  return fmt::format("Clang {}", __clang_version__);
#else
  return fmt::format("GCC {}", __VERSION__);
#endif
}

/// Libraries whose rounding or exactness every result rests on, with the versions that run.
std::vector<std::pair<std::string, std::string>> libraries() {
  return {{"MPFR", mpfr_get_version()}, {"GMP", gmp_version}};
}

}  // namespace

std::string version_text(VersionDetail detail) {
  std::string text = fmt::format("mixcmp {} (commit {})\n", emit::version, commit());
  if (detail == VersionDetail::line) return text;
  const auto add = [&text](const std::string& name, const std::string& version) {
    text += fmt::format("  {:<27} {}\n", name, printable_line(version));
  };
  add("compiler", compiler());
  for (const auto& [name, version] : libraries()) add(name, version);
  for (const FoundTool& tool : find_tools()) {
    add(tool.name, tool.version.ok() ? *tool.version : "not found");
  }
  return text;
}

std::string version_json() {
  nlohmann::ordered_json report = {
      {"version", emit::version}, {"commit", commit()}, {"compiler", compiler()}};
  for (const auto& [name, version] : libraries()) report["libraries"][name] = version;
  for (const FoundTool& tool : find_tools()) {
    report["tools"][tool.name] =
        tool.version.ok() ? nlohmann::ordered_json(*tool.version) : nlohmann::ordered_json(nullptr);
  }
  return report::json_text(report);
}

}  // namespace mixcmp::cli

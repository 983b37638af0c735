#include "generator/synthesis/characterise/vendor_report.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "generator/synthesis/characterise/vendor_parsers.hpp"
#include "model/base/common/check.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/quote.hpp"

namespace mixcmp::characterise {
namespace {

/// A part's name as in reports: in lower case, without "xc", hyphens and blanks.
std::string plain_part(std::string_view text) {
  std::string part;
  for (const char c : text) {
    if (c != '-' && c != ' ')
      part += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return part.starts_with("xc") ? part.substr(2) : part;
}

/// The error of a file that is none of the four reports. For summaries of the same tools it names
/// the missing contents.
Error not_a_report(const ReportText& report) {
  const std::string accepted =
      "utilisation_by_instance.rpt, timing.rpt (Vivado), TOP.fit.rpt, TOP.sta.rpt (Quartus)";
  const std::string first = report.size() == 0 ? "" : report.line(1);
  if (first.starts_with("Fitter Status")) {
    return report.error(1, "Quartus' fit summary has no areas by instance", in_quotes(first),
                        accepted);
  }
  if (report.size() >= 2 && report.line(2).starts_with("Timing Analyzer Summary")) {
    return report.error(2, "Quartus' timing summary names no tool and no device",
                        in_quotes(report.line(2)), accepted);
  }
  return report.error(1, "not a report of Vivado or Quartus", in_quotes(first), accepted);
}

}  // namespace

std::string_view to_string(Vendor vendor) {
  switch (vendor) {
    case Vendor::vivado: return "Vivado";
    case Vendor::quartus: return "Quartus";
  }
  MIXCMP_CHECK(false);
}

std::string version_of(std::string_view text) {
  std::istringstream words{std::string(text)};
  std::string version;
  for (std::string word, before; words >> word; before = word) {
    if (word.starts_with("(")) continue;
    version += (version.empty() ? "" : " ") + word;
    if (before == "Build") break;
  }
  return version;
}

Result<VendorReport> read_vendor_report(const std::filesystem::path& path) {
  MIXCMP_TRY(text, read_file(path));
  const ReportText report(path, text);
  constexpr int head_lines = 5;
  for (int line = 1; line <= std::min(head_lines, report.size()); ++line) {
    const std::string& words = report.line(line);
    if (words.starts_with("| Tool Version")) return parse_vivado_report(report);
    if (words.starts_with("Fitter report for ")) return parse_quartus_fit(report);
    if (words.starts_with("Timing Analyzer report for ") ||
        words.starts_with("TimeQuest Timing Analyzer report for ")) {
      return parse_quartus_timing(report);
    }
  }
  return not_a_report(report);
}

bool is_part(const VendorReport& report, const std::string& part) {
  const std::string named = plain_part(report.device);
  return !named.empty() && plain_part(part).starts_with(named);
}

}  // namespace mixcmp::characterise

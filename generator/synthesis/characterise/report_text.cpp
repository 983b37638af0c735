#include "generator/synthesis/characterise/report_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "model/base/common/quote.hpp"

namespace mixcmp::characterise {
namespace {

constexpr double most_of_a_resource = 1e9;

}  // namespace

ReportText::ReportText(std::filesystem::path path, std::string_view text) : path_(std::move(path)) {
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) {
    if (line.ends_with('\r')) line.pop_back();
    lines_.push_back(std::move(line));
  }
}

int ReportText::find(std::string_view words, int from) const {
  for (int number = from; number <= size(); ++number) {
    if (line(number).find(words) != std::string::npos) return number;
  }
  return 0;
}

Error ReportText::error(int line, std::string message, std::string received,
                        std::string accepted) const {
  return {.file = path_.string(),
          .line = line,
          .message = std::move(message),
          .received = std::move(received),
          .accepted = std::move(accepted)};
}

Error ReportText::missing(const std::string& what) const {
  return error(0, "a part of the report is missing", fmt::format("{} lines without it", size()),
               what);
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

std::vector<std::string> cells_of(const std::string& line, char separator) {
  std::vector<std::string> cells;
  std::size_t start = line.find(separator);
  while (start != std::string::npos) {
    const std::size_t end = line.find(separator, start + 1);
    if (end == std::string::npos) break;
    cells.push_back(line.substr(start + 1, end - start - 1));
    start = end;
  }
  return cells;
}

ReportTable::ReportTable(const ReportText& report, int header_line, char separator)
    : report_(report), separator_(separator) {
  for (const std::string& name : cells_of(report.line(header_line), separator)) {
    names_.push_back(trimmed(name));
  }
  for (int line = header_line + 2; line <= report.size(); ++line) {
    if (!report.line(line).starts_with(separator)) break;
    records_.push_back(line);
  }
}

std::optional<std::size_t> ReportTable::column(std::string_view name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names_.begin());
}

std::vector<std::size_t> ReportTable::columns_that(bool (*wanted)(const std::string& name)) const {
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < names_.size(); ++k) {
    if (wanted(names_[k])) columns.push_back(k);
  }
  return columns;
}

Result<std::string> ReportTable::cell(int line, std::size_t column) const {
  const std::vector<std::string> cells = cells_of(report_.line(line), separator_);
  if (cells.size() == names_.size()) return cells[column];
  return report_.error(line, "a record of the table is not whole",
                       fmt::format("{} cells", cells.size()),
                       fmt::format("{}, as its header has", names_.size()));
}

Result<int> ReportTable::count(int line, std::size_t column) const {
  MIXCMP_TRY(text, cell(line, column));
  const std::optional<double> number = leading_number(trimmed(text));
  if (number && *number >= 0 && *number <= most_of_a_resource) {
    return static_cast<int>(std::ceil(*number));
  }
  return report_.error(line, names_[column] + " is no number", in_quotes(trimmed(text)),
                       "a number of at least 0");
}

std::optional<double> leading_number(std::string_view text) {
  std::string digits;
  for (const char c : text) {
    if (c == ' ' || c == '(') break;
    if (c != ',') digits += c;  // Quartus writes 1,632
  }
  double value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, failed] = std::from_chars(digits.data(), end, value);
  if (failed != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace mixcmp::characterise

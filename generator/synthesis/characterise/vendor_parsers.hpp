#pragma once

#include "generator/synthesis/characterise/report_text.hpp"
#include "generator/synthesis/characterise/vendor_report.hpp"

/// One parser for each kind of report; read_vendor_report chooses among them.
namespace mixcmp::characterise {

Result<VendorReport> parse_vivado_report(const ReportText& report);
Result<VendorReport> parse_quartus_fit(const ReportText& report);
Result<VendorReport> parse_quartus_timing(const ReportText& report);

/// The version in a text such as "v.2019.2 (lin64) Build 2708876 Wed Nov  6 ...", without platform
/// and date: the text up to the number after "Build", without parentheses.
std::string version_of(std::string_view text);

}  // namespace mixcmp::characterise

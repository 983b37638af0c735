#include "generator/faces/cli/optimise_on.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/faces/cli/exit.hpp"
#include "generator/present/report/plan_fields.hpp"
#include "generator/present/table/table.hpp"
#include "model/cost/devices/parts.hpp"

namespace mixcmp::cli {
namespace {

using table::Fields;
using table::Json;
using table::Table;
using tasks::DevicePlan;
using tasks::OptimiseOnResult;

std::vector<std::string> devices_of_word(const std::string& word) {
  std::vector<std::string> names;
  for (const devices::KnownDevice& each : devices::devices_with(word == "all" ? "" : word)) {
    names.push_back(each.device.name);
  }
  if (!names.empty()) return names;
  auto device = devices::find_device(word);
  if (device.ok()) return {word};
  Error error = device.error();
  if (error.field == "system.device") {
    error.field = "--on";
    error.message = "no device has this in its names";
    error.accepted = "all, or " + error.accepted;
  }
  fail(error);
}

/// The columns that describe a device.
Fields<DevicePlan> device_fields() {
  return {{{"device", "device", 16, 1}, [](const DevicePlan& each) { return each.device.name; }},
          {{"family", "family", 18}, [](const DevicePlan& each) { return each.device.family; }},
          {{"six_input_luts", "LUTs", 8, 1, "{:.0f}"}, &DevicePlan::six_input_luts}};
}

/// The columns of the plan on a device.
Fields<DevicePlan> figures() {
  const auto plan = table::within<DevicePlan>(report::plan_choice(), &DevicePlan::plan);
  const Fields<DevicePlan> used = {
      {{"used_share", "used", 6, 1, "{:.0f} %", 0.01},
       [](const DevicePlan& each) { return each.used.share; }},
      {{"most_used", "of", 6, 1}, [](const DevicePlan& each) {
         return each.used.resource == nullptr ? "" : each.used.resource->name;
       }}};
  return plan + used;
}

/// The row of a device; without a plan it says why.
template <class AllFields>
Table table_with(const AllFields& fields, const OptimiseOnResult& result) {
  Table table = table_of(fields, {});
  table.remark_name = "no_plan";
  for (const DevicePlan& each : result.devices) {
    table.rows.push_back(row_of(fields, each, each.plan.precision == 0 ? each.why_none : ""));
  }
  return table;
}

std::string smallest_of(const OptimiseOnResult& result) {
  return result.smallest ? result.smallest->best().found.device.name : "";
}

}  // namespace

void add_on_option(const Verb& verb, std::vector<std::string>& words) {
  verb.list_option(
          "--on", [&words](const std::vector<std::string>& given) { words = given; },
          "plan, on predicted areas, on all devices that match in place of the scene's: all, or "
          "letters as mixcmp devices takes them: artix7,ecp5; with --at-least the smallest of them "
          "is chosen")
      .separated_by(',')
      .excludes("--table")
      .excludes("--plans");
}

std::vector<std::string> devices_on(const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const std::string& word : words) {
    for (std::string& name : devices_of_word(word)) {
      const bool known = std::find(names.begin(), names.end(), name) != names.end();
      if (!known) names.push_back(std::move(name));
    }
  }
  return names;
}

std::string to_text(const OptimiseOnResult& result) {
  const Fields<DevicePlan> mark = {
      {{"", "", 1, 0}, [chosen = smallest_of(result)](const DevicePlan& each) {
         return each.device.name == chosen ? "*" : "";
       }}};
  const Fields<DevicePlan> rest = {
      {{"alike", "alike", 5}, [](const DevicePlan& each) { return each.alike.size(); }},
      {{"interface", "interface"}, &DevicePlan::interface}};
  std::string text = "the fastest plan on each device, on predicted areas\n" +
                     to_text(table_with(mark + device_fields() + figures() + rest, result)) +
                     "  devices by LUTs of six inputs; three of four inputs count as two. LUTs of "
                     "two families, their\n  DSPs, memories and clocks differ in more, so only the "
                     "order within a family is exact\n";
  if (result.passed_over > 0) {
    text += fmt::format(
        "  {} others are not planned: a smaller one of their family is fast enough, or one with no "
        "less is not\n",
        result.passed_over);
  }
  return text;
}

Json to_json(const OptimiseOnResult& result) {
  const Fields<DevicePlan> rest = {{{"interface"}, &DevicePlan::interface},
                                   {{"settings"}, &DevicePlan::settings},
                                   {{"alike"}, &DevicePlan::alike}};
  return {{"devices", to_json(table_with(device_fields() + figures() + rest, result))},
          {"devices_passed_over", result.passed_over}};
}

}  // namespace mixcmp::cli

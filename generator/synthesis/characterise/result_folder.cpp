#include "generator/synthesis/characterise/result_folder.hpp"

#include <nlohmann/json.hpp>

#include "model/base/common/file.hpp"
#include "model/base/common/output_file.hpp"

namespace mixcmp::characterise {
namespace {

using measured::Clock;
using measured::ClockSource;

using Json = nlohmann::ordered_json;

Json to_json(const Clock& clock) {
  return {{"mhz", clock.mhz},
          {"low_mhz", clock.low_mhz},
          {"high_mhz", clock.high_mhz},
          {"seeds", clock.seeds},
          {"source", to_string(clock.source)}};
}

Clock clock_in(const Json& json) {
  const bool routed = json.at("source") == to_string(ClockSource::routed);
  return {.mhz = json.at("mhz"),
          .low_mhz = json.at("low_mhz"),
          .high_mhz = json.at("high_mhz"),
          .seeds = json.at("seeds"),
          .source = routed ? ClockSource::routed : ClockSource::estimate_before_routing};
}

SynthesisResult result_in(const Json& json) {
  SynthesisResult result{.area = {.luts = json.at("luts"),
                                  .registers = json.at("registers"),
                                  .dsps = json.at("dsps"),
                                  .memories = json.at("memories"),
                                  .carries = json.at("carries"),
                                  .shift_luts = json.at("shift_luts")},
                         .clock = {},
                         .no_clock = json.at("no_clock")};
  if (json.contains("clock")) result.clock = clock_in(json.at("clock"));
  return result;
}

}  // namespace

std::filesystem::path ResultFolder::file_of(const std::string& hash) const {
  return folder_ / (hash + ".json");
}

std::optional<SynthesisResult> ResultFolder::find(const std::string& hash) const {
  const Result<std::string> text = read_file(file_of(hash));
  if (!text.ok()) return std::nullopt;
  try {
    const Json json = Json::parse(*text);
    if (json.at("hash") != hash) return std::nullopt;
    return result_in(json);
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

Result<Done> ResultFolder::add(const std::string& hash, const SynthesisResult& result,
                               const std::string& tools) const {
  Json json = {{"hash", hash},
               {"tools", tools},
               {"luts", result.area.luts},
               {"registers", result.area.registers},
               {"dsps", result.area.dsps},
               {"memories", result.area.memories},
               {"carries", result.area.carries},
               {"shift_luts", result.area.shift_luts}};
  if (result.clock) json["clock"] = to_json(*result.clock);
  json["no_clock"] = result.no_clock;
  constexpr auto replace = Json::error_handler_t::replace;  // a tool's message may be invalid UTF-8
  return write_kept_file(file_of(hash), json.dump(2, ' ', false, replace) + "\n");
}

}  // namespace mixcmp::characterise

#include "generator/present/report/json_text.hpp"

#include <nlohmann/json.hpp>

namespace mixcmp::report {

std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

nlohmann::ordered_json to_json(const Error& error) {
  nlohmann::ordered_json json = {{"text", error.to_string()}};
  if (!error.file.empty()) json["file"] = error.file;
  if (error.line > 0) json["line"] = error.line;
  if (error.line > 0 && error.column > 0) json["column"] = error.column;
  if (!error.field.empty()) json["field"] = error.field;
  json["message"] = error.message;
  if (!error.received.empty()) json["received"] = error.received;
  if (!error.accepted.empty()) json["accepted"] = error.accepted;
  return json;
}

}  // namespace mixcmp::report

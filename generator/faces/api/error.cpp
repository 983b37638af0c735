#include <utility>

#include "generator/faces/api/state.hpp"

namespace mixcmp::api {

Error::Error(const std::string& text, Details details)
    : std::runtime_error(text), details_(std::make_shared<const Details>(std::move(details))) {}

Error::~Error() = default;

void fail(const mixcmp::Error& error) {
  throw Error(error.to_string(), {.file = error.file,
                                  .line = error.line,
                                  .field = error.field,
                                  .message = error.message,
                                  .received = error.received,
                                  .accepted = error.accepted,
                                  .missing_tool = error.kind == ErrorKind::missing_tool});
}

}  // namespace mixcmp::api

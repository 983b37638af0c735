#include "model/comparison/data/npy_header.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "model/base/common/quote.hpp"

namespace mixcmp::data {
namespace {

constexpr std::string_view magic = "\x93NUMPY";

Error header_error(std::string message, std::string received, std::string accepted) {
  return {.field = "npy header",
          .message = std::move(message),
          .received = std::move(received),
          .accepted = std::move(accepted)};
}

/// Unpacks "<f8"; the byte count is known for every kind but Python objects.
Result<NpyField> parse_type(std::string name, std::string_view type) {
  const auto wrong = [&] {
    return header_error("not a type of values", in_quotes(type),
                        "f2 f4 f8 i1 i2 i4 i8 u1 u2 u4 u8, with '<', '>', '|' or '=' before");
  };
  NpyField field{.name = std::move(name), .type = std::string(type)};
  if (type.size() < 3 || std::string_view("<>|=").find(type[0]) == std::string_view::npos) {
    return wrong();
  }
  int count = 0;
  const auto [end, status] = std::from_chars(type.data() + 2, type.data() + type.size(), count);
  if (status != std::errc{} || end != type.data() + type.size() || count < 0) return wrong();
  const char kind = type[1];
  field.bytes = static_cast<std::size_t>(count) * (kind == 'U' ? 4 : 1);
  const bool size_of_float = count == 2 || count == 4 || count == 8;
  const bool size_of_integer = count == 1 || size_of_float;
  if ((kind == 'f' && size_of_float) || ((kind == 'i' || kind == 'u') && size_of_integer)) {
    field.scalar = NpyScalar{.big_endian = type[0] == '>', .kind = kind, .bytes = count};
  }
  return field;
}

/// Reads the header's Python dictionary, of which only a handful of forms occur.
class DictionaryReader {
public:
  explicit DictionaryReader(std::string_view text) : text_(text) {}

  Result<NpyHeader> read() {
    NpyHeader header;
    bool has_type = false, has_order = false, has_shape = false;
    if (!take('{')) return unexpected("'{'");
    while (!take('}')) {
      MIXCMP_TRY(key, string());
      if (!take(':')) return unexpected("':'");
      const bool again = (key == "descr" && has_type) || (key == "fortran_order" && has_order) ||
                         (key == "shape" && has_shape);
      if (again) return header_error("a key given twice", in_quotes(key), "each key once");
      if (key == "descr") {
        MIXCMP_DO(type(header));
        has_type = true;
      } else if (key == "fortran_order") {
        MIXCMP_TRY(order, truth());
        header.fortran_order = order;
        has_order = true;
      } else if (key == "shape") {
        MIXCMP_TRY(shape, tuple());
        header.shape = shape;
        has_shape = true;
      } else {
        return header_error("unknown key", in_quotes(key), "descr, fortran_order, shape");
      }
      take(',');
    }
    if (!at_end()) return unexpected("the end of the header");
    if (has_type && has_order && has_shape) return header;
    return header_error("a key is missing", "the header's dictionary",
                        "descr, fortran_order and shape");
  }

private:
  bool take(char wanted) {
    while (!text_.empty() && (text_[0] == ' ' || text_[0] == '\n')) text_.remove_prefix(1);
    if (text_.empty() || text_[0] != wanted) return false;
    text_.remove_prefix(1);
    return true;
  }

  bool at_end() const { return text_.find_first_not_of(" \n") == std::string_view::npos; }

  Error unexpected(std::string accepted) const {
    return header_error("malformed", in_quotes(text_.substr(0, 20)), std::move(accepted));
  }

  Result<std::string> string() {
    const char quote = take('\'') ? '\'' : '"';
    if (quote == '"' && !take('"')) return unexpected("a quoted string");
    const std::size_t end = text_.find(quote);
    if (end == std::string_view::npos) return unexpected("a quoted string");
    std::string value(text_.substr(0, end));
    text_.remove_prefix(end + 1);
    return value;
  }

  Result<bool> truth() {
    take(' ');
    for (const bool value : {false, true}) {
      const std::string_view word = value ? "True" : "False";
      if (!text_.starts_with(word)) continue;
      text_.remove_prefix(word.size());
      return value;
    }
    return unexpected("True or False");
  }

  Result<std::vector<std::uint64_t>> tuple() {
    std::vector<std::uint64_t> values;
    if (!take('(')) return unexpected("'('");
    while (!take(')')) {
      std::uint64_t value = 0;
      const auto [end, status] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
      if (status != std::errc{}) return unexpected("a whole number");
      text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
      values.push_back(value);
      take(',');
    }
    return values;
  }

  /// 'descr': a type, or a list of (name, type).
  Result<Done> type(NpyHeader& header) {
    if (!take('[')) {
      MIXCMP_TRY(text, string());
      MIXCMP_TRY(field, parse_type({}, text));
      header.fields = {field};
      return Done{};
    }
    header.structured = true;
    std::size_t offset = 0;
    while (!take(']')) {
      if (!take('(')) return unexpected("'(' before a field");
      MIXCMP_TRY(name, string());
      take(',');
      MIXCMP_TRY(text, string());
      if (!take(')')) return unexpected("')' after a field of single values");
      MIXCMP_TRY(field, parse_type(name, text));
      field.offset = offset;
      offset += field.bytes;
      header.fields.push_back(field);
      take(',');
    }
    return Done{};
  }

  std::string_view text_;
};

}  // namespace

Result<NpyHeader> parse_npy_header(std::string_view file) {
  if (!file.starts_with(magic) || file.size() < magic.size() + 4) {
    return header_error("not a .npy file", in_quotes(file.substr(0, magic.size())),
                        "the bytes \\x93NUMPY first");
  }
  const int version = static_cast<unsigned char>(file[magic.size()]);
  if (version < 1 || version > 3) {
    return header_error("unknown version", fmt::format("{}", version), "1, 2 or 3");
  }
  const std::size_t length_bytes = version == 1 ? 2 : 4;
  const std::size_t begin = magic.size() + 2 + length_bytes;
  std::size_t length = 0;
  for (std::size_t k = std::min(length_bytes, file.size() - magic.size() - 2); k > 0; --k) {
    length = length << 8 | static_cast<unsigned char>(file[magic.size() + 1 + k]);
  }
  if (file.size() < begin || file.size() - begin < length) {
    return header_error("cut short", fmt::format("{} bytes in the file", file.size()),
                        fmt::format("at least {}", begin + length));
  }
  MIXCMP_TRY(header, DictionaryReader(file.substr(begin, length)).read());
  header.data_offset = begin + length;
  return header;
}

}  // namespace mixcmp::data

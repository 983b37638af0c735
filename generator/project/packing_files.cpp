#include "generator/project/packing_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "generator/project/builders.hpp"
#include "model/base/common/check.hpp"
#include "model/base/number/double.hpp"

namespace mixcmp::project {
namespace {

using Function = std::string (*)(const std::string& module, const std::string& field, int at,
                                 const OperandFormat& format);

/// The keywords of C and C++, and the lower-case names that their usual headers or compilers
/// define, each between blanks.
constexpr std::string_view reserved_words =
    " alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t"
    " char32_t char8_t class co_await co_return co_yield compl concept const const_cast"
    " consteval constexpr constinit continue decltype default delete do double dynamic_cast"
    " else enum explicit export extern false float for friend goto if inline int long mutable"
    " namespace new noexcept not not_eq nullptr operator or or_eq private protected public"
    " register reinterpret_cast requires restrict return short signed sizeof static"
    " static_assert static_cast struct switch template this thread_local throw true try"
    " typedef typeid typename typeof typeof_unqual union unsigned using virtual void volatile"
    " wchar_t while xor xor_eq I errno linux stderr stdin stdout unix far near"
    " ";

/// Whether a field of this name may be a keyword of C or C++, or a macro or type of their headers.
bool is_reserved(const std::string& name) {
  const bool is_macro = name.size() > 1 && std::none_of(name.begin(), name.end(), [](char letter) {
                          return 'a' <= letter && letter <= 'z';
                        });
  const bool is_internal =
      name.size() > 1 && name[0] == '_' && (name[1] == '_' || ('A' <= name[1] && name[1] <= 'Z'));
  return is_macro || is_internal || name.ends_with("_t") ||
         reserved_words.find(" " + name + " ") != std::string_view::npos;
}

/// The names of the operands' fields: with `_` behind those that are reserved, or that would be
/// taken twice.
std::vector<std::string> c_fields(const PackedRecord& record) {
  std::set<std::string> taken(record.operands.begin(), record.operands.end());
  std::vector<std::string> fields;
  for (const std::string& operand : record.operands) {
    std::string field = operand;
    if (is_reserved(operand)) {
      do field += '_';
      while (!taken.insert(field).second);
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

bool is_integer(const FixedFormat& format) {
  return format.unit_exponent == 0;
}

std::string c_type(const OperandFormat& format) {
  const FixedFormat* const fixed = format.fixed();
  if (fixed == nullptr || !is_integer(*fixed)) return "double";
  return fixed->is_signed ? "int64_t" : "uint64_t";
}

/// A power of two, at least 1, as a constant of C's double.
std::string c_power(int exponent) {
  return fmt::format("{:.1f}", std::ldexp(1.0, exponent));
}

/// The expression in C for a number with digits behind the point, in units of its format.
std::string c_steps(const std::string& value, const FixedFormat& format) {
  return fmt::format("{} * {}", value, c_power(-format.unit_exponent));
}

/// The condition of C under which a format in fixed point does not hold `value`; empty if it holds
/// all.
std::string c_is_refused(const std::string& value, const FixedFormat& format,
                         const std::string& module) {
  const int bits = format.magnitude_bits();
  if (!is_integer(format)) {
    return fmt::format("!{}_holds({}, {}, {})", module, c_steps(value, format),
                       format.is_signed ? "-" + c_power(bits) : "0", c_power(bits));
  }
  if (format.width == 64) return "";
  const std::string most = format.largest().get_str();
  if (!format.is_signed) return fmt::format("{} > {}", value, most);
  return fmt::format("{0} < -{1} - 1 || {0} > {1}", value, most);
}

/// The call of a packer's function of a floating-point format: "unit_word(value, 4, 5)".
std::string c_float_call(const std::string& module, const std::string& function,
                         const std::string& argument, const FloatFormat& format) {
  const int digits = format.precision(), exponent_bits = format.exponent_bits();
  if (format.has_infinities()) {
    return fmt::format("{}_{}({}, {}, {})", module, function, argument, digits, exponent_bits);
  }
  return fmt::format("{}_{}_no_infinities({}, {}, {}, {})", module, function, argument, digits,
                     exponent_bits, c_power(OperandFormat(format).scaled_float().scale));
}

std::string c_pack(const std::string& module, const std::string& field, int at,
                   const OperandFormat& format) {
  const std::string value = "from->" + field;
  if (const FloatFormat* const floating = format.floating()) {
    if (!fits_double(*floating)) {
      return fmt::format("  {}_put_wide(tdata, {}, {}, {}, {});\n", module, at,
                         floating->precision(), floating->exponent_bits(), value);
    }
    return fmt::format("  {}_put(tdata, {}, {}, {});\n", module, at, floating->width(),
                       c_float_call(module, "word", value, *floating));
  }
  const FixedFormat& fixed = *format.fixed();
  std::string word = is_integer(fixed) ? value : fmt::format("({})", c_steps(value, fixed));
  if (fixed.is_signed && !is_integer(fixed)) word = "(int64_t)" + word;
  if (fixed.is_signed || !is_integer(fixed)) word = "(uint64_t)" + word;
  return fmt::format("  {}_put(tdata, {}, {}, {});\n", module, at, fixed.width, word);
}

std::string c_unpack(const std::string& module, const std::string& field, int at,
                     const OperandFormat& format) {
  if (const FloatFormat* const floating = format.floating()) {
    if (!fits_double(*floating)) {
      return fmt::format("  to.{} = {}_get_wide(tdata, {}, {}, {});\n", field, module, at,
                         floating->precision(), floating->exponent_bits());
    }
    const std::string word = fmt::format("{}_get(tdata, {}, {})", module, at, floating->width());
    return fmt::format("  to.{} = {};\n", field, c_float_call(module, "number", word, *floating));
  }
  const FixedFormat& fixed = *format.fixed();
  std::string steps = fmt::format("{}_get{}(tdata, {}, {})", module,
                                  fixed.is_signed ? "_signed" : "", at, fixed.width);
  if (!is_integer(fixed)) {
    steps = fmt::format("(double){} / {}", steps, c_power(-fixed.unit_exponent));
  }
  return fmt::format("  to.{} = {};\n", field, steps);
}

std::string of_each(const PackedRecord& record, const std::string& module, Function function) {
  const std::vector<std::string> fields = c_fields(record);
  std::string text;
  int at = 0;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    text += function(module, fields[k], at, record.formats[k]);
    at += record.formats[k].width();
  }
  return text;
}

std::string c_struct(const PackedRecord& record, const std::string& module) {
  const std::vector<std::string> fields = c_fields(record);
  std::size_t type_width = 0, field_width = 0;
  for (std::size_t k = 0; k < record.operands.size(); ++k) {
    type_width = std::max(type_width, c_type(record.formats[k]).size());
    field_width = std::max(field_width, fields[k].size() + 1);
  }
  std::string text = fmt::format(
      "// {} bytes of {}, in little-endian order.\n#define {}_{}_BYTES {}\nstruct {}_{} "
      "{{\n",
      record.bytes, record.port, in_capitals(module), in_capitals(record.name), record.bytes,
      module, record.name);
  for (std::size_t k = 0; k < record.operands.size(); ++k) {
    text += fmt::format("  {:<{}} {:<{}}  // {}\n", c_type(record.formats[k]), type_width,
                        fields[k] + ";", field_width, record.formats[k].name());
  }
  return text + "};\n";
}

std::string c_refusals(const PackedRecord& record, const std::string& module) {
  const std::vector<std::string> fields = c_fields(record);
  std::string text;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const FixedFormat* const fixed = record.formats[k].fixed();
    if (fixed == nullptr) continue;
    const std::string refused = c_is_refused("from->" + fields[k], *fixed, module);
    if (!refused.empty()) text += fmt::format("  if ({}) return {};\n", refused, k + 1);
  }
  return text;
}

std::string c_record(const PackedRecord& record, const std::string& module) {
  const std::string type = fmt::format("struct {}_{}", module, record.name);
  return c_struct(record, module) +
         fmt::format(
             "\n// Returns 0, or the number, from 1, of the first operand that its format does "
             "not\n"
             "// hold. Then `tdata` is as before.\n"
             "static inline int {0}_pack_{1}(\n    const {2} *from, uint8_t *tdata) {{\n{3}"
             "  memset(tdata, 0, {4}_{5}_BYTES);\n{6}  return 0;\n}}\n\n"
             "static inline {2} {0}_unpack_{1}(\n    const uint8_t *tdata) {{\n  {2} to;\n{7}"
             "  return to;\n}}",
             module, record.name, type, c_refusals(record, module), in_capitals(module),
             in_capitals(record.name), of_each(record, module, c_pack),
             of_each(record, module, c_unpack));
}

std::string python_format(const OperandFormat& format) {
  if (const FloatFormat* const floating = format.floating()) {
    return fmt::format("(\"float\", {}, {}, {})", floating->precision(), floating->exponent_bits(),
                       floating->has_infinities() ? "True" : "False");
  }
  const FixedFormat& fixed = *format.fixed();
  return fmt::format("(\"fixed\", {}, {}, {})", fixed.width, fixed.is_signed ? "True" : "False",
                     -fixed.unit_exponent);
}

std::string python_table(const PackedRecord& record) {
  std::string text = fmt::format("{} = (\n", in_capitals(record.name));
  for (std::size_t k = 0; k < record.operands.size(); ++k) {
    text += fmt::format("    (\"{}\", {}),  # {}\n", record.operands[k],
                        python_format(record.formats[k]), record.formats[k].name());
  }
  return text + ")";
}

std::string python_functions(const PackedRecord& record) {
  return fmt::format(
      "def pack_{0}(values):\n"
      "    \"\"\"Bytes of {1}, an array of shape (rows, {2}), from columns of numbers by name.\n\n"
      "    ValueError: a number that its format does not hold.\"\"\"\n"
      "    return _pack({3}, values)\n\n\n"
      "def unpack_{0}(tdata):\n"
      "    \"\"\"Columns of numbers by name, from bytes of {1}.\"\"\"\n"
      "    return _unpack({3}, tdata)",
      record.name, record.port, record.bytes, in_capitals(record.name));
}

std::string c_example(const PackedRecord& record, const std::string& module) {
  return fmt::format(
      "//   struct {0}_{1} from = {{0}};\n//   uint8_t tdata[{2}_{3}_BYTES];\n"
      "//   from.{4} = 1;\n//   if ({0}_pack_{1}(&from, tdata) != 0) ...\n"
      "//   struct {0}_{1} again = {0}_unpack_{1}(tdata);",
      module, record.name, in_capitals(module), in_capitals(record.name), c_fields(record).front());
}

std::string python_example(const PackedRecord& record, const std::string& module) {
  std::vector<std::string> columns;
  for (const std::string& operand : record.operands) {
    columns.push_back(columns.size() < 2 ? fmt::format("\"{}\": [1]", operand) : "...");
    if (columns.size() > 2) break;
  }
  return fmt::format(
      "    import {0}_packing as packing\n    tdata = packing.pack_{1}({{{2}}})\n"
      "    columns = packing.unpack_{1}(tdata)",
      module, record.name, fmt::join(columns, ", "));
}

}  // namespace

std::vector<GeneratedFile> packing_files(const PackingSpec& spec, const std::string& c_head,
                                         const std::string& python_head) {
  MIXCMP_CHECK(!spec.records.empty());
  const PackedRecord& first = spec.records.front();
  std::vector<std::string> c_records, tables, functions;
  bool has_floats = false, has_wide = false, has_fractions = false, any_without_infinities = false;
  for (const PackedRecord& record : spec.records) {
    c_records.push_back(c_record(record, spec.module));
    tables.push_back(python_table(record));
    functions.push_back(python_functions(record));
    for (const OperandFormat& format : record.formats) {
      const FloatFormat* const floating = format.floating();
      has_floats = has_floats || (floating != nullptr && fits_double(*floating));
      has_wide = has_wide || (floating != nullptr && !fits_double(*floating));
      any_without_infinities =
          any_without_infinities || (floating != nullptr && !floating->has_infinities());
      has_fractions = has_fractions || (format.fixed() != nullptr && !is_integer(*format.fixed()));
    }
  }
  const std::string name = fmt::format("integration/{}_packing", spec.module);
  return {file_from(name + ".h", "packing.h",
                    {{"MODULE", spec.module},
                     {"NAME", in_capitals(spec.module)},
                     {"HEAD", c_head},
                     {"EXAMPLE", c_example(first, spec.module)},
                     {"FLOATS", has_floats ? "yes" : ""},
                     {"NO_INFINITIES", any_without_infinities ? "yes" : ""},
                     {"WIDE", has_wide ? "yes" : ""},
                     {"FRACTIONS", has_fractions ? "yes" : ""},
                     {"RECORDS", fmt::format("{}", fmt::join(c_records, "\n\n"))}}),
          file_from(name + ".py", "packing.py",
                    {{"MODULE", spec.module},
                     {"HEAD", python_head},
                     {"EXAMPLE", python_example(first, spec.module)},
                     {"NO_INFINITIES", any_without_infinities ? "yes" : ""},
                     {"TABLES", fmt::format("{}", fmt::join(tables, "\n"))},
                     {"FUNCTIONS", fmt::format("{}", fmt::join(functions, "\n\n\n"))}})};
}

}  // namespace mixcmp::project

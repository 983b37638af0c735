#include "model/comparison/expression/name.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mixcmp::inline expression {
namespace {

// Keywords of IEEE 1800-2017 annex B, sorted. They include those of IEEE 1364-2001: simulators may
// read .v files as either.
constexpr std::array<std::string_view, 248> keywords = {"accept_on",
                                                        "alias",
                                                        "always",
                                                        "always_comb",
                                                        "always_ff",
                                                        "always_latch",
                                                        "and",
                                                        "assert",
                                                        "assign",
                                                        "assume",
                                                        "automatic",
                                                        "before",
                                                        "begin",
                                                        "bind",
                                                        "bins",
                                                        "binsof",
                                                        "bit",
                                                        "break",
                                                        "buf",
                                                        "bufif0",
                                                        "bufif1",
                                                        "byte",
                                                        "case",
                                                        "casex",
                                                        "casez",
                                                        "cell",
                                                        "chandle",
                                                        "checker",
                                                        "class",
                                                        "clocking",
                                                        "cmos",
                                                        "config",
                                                        "const",
                                                        "constraint",
                                                        "context",
                                                        "continue",
                                                        "cover",
                                                        "covergroup",
                                                        "coverpoint",
                                                        "cross",
                                                        "deassign",
                                                        "default",
                                                        "defparam",
                                                        "design",
                                                        "disable",
                                                        "dist",
                                                        "do",
                                                        "edge",
                                                        "else",
                                                        "end",
                                                        "endcase",
                                                        "endchecker",
                                                        "endclass",
                                                        "endclocking",
                                                        "endconfig",
                                                        "endfunction",
                                                        "endgenerate",
                                                        "endgroup",
                                                        "endinterface",
                                                        "endmodule",
                                                        "endpackage",
                                                        "endprimitive",
                                                        "endprogram",
                                                        "endproperty",
                                                        "endsequence",
                                                        "endspecify",
                                                        "endtable",
                                                        "endtask",
                                                        "enum",
                                                        "event",
                                                        "eventually",
                                                        "expect",
                                                        "export",
                                                        "extends",
                                                        "extern",
                                                        "final",
                                                        "first_match",
                                                        "for",
                                                        "force",
                                                        "foreach",
                                                        "forever",
                                                        "fork",
                                                        "forkjoin",
                                                        "function",
                                                        "generate",
                                                        "genvar",
                                                        "global",
                                                        "highz0",
                                                        "highz1",
                                                        "if",
                                                        "iff",
                                                        "ifnone",
                                                        "ignore_bins",
                                                        "illegal_bins",
                                                        "implements",
                                                        "implies",
                                                        "import",
                                                        "incdir",
                                                        "include",
                                                        "initial",
                                                        "inout",
                                                        "input",
                                                        "inside",
                                                        "instance",
                                                        "int",
                                                        "integer",
                                                        "interconnect",
                                                        "interface",
                                                        "intersect",
                                                        "join",
                                                        "join_any",
                                                        "join_none",
                                                        "large",
                                                        "let",
                                                        "liblist",
                                                        "library",
                                                        "local",
                                                        "localparam",
                                                        "logic",
                                                        "longint",
                                                        "macromodule",
                                                        "matches",
                                                        "medium",
                                                        "modport",
                                                        "module",
                                                        "nand",
                                                        "negedge",
                                                        "nettype",
                                                        "new",
                                                        "nexttime",
                                                        "nmos",
                                                        "nor",
                                                        "noshowcancelled",
                                                        "not",
                                                        "notif0",
                                                        "notif1",
                                                        "null",
                                                        "or",
                                                        "output",
                                                        "package",
                                                        "packed",
                                                        "parameter",
                                                        "pmos",
                                                        "posedge",
                                                        "primitive",
                                                        "priority",
                                                        "program",
                                                        "property",
                                                        "protected",
                                                        "pull0",
                                                        "pull1",
                                                        "pulldown",
                                                        "pullup",
                                                        "pulsestyle_ondetect",
                                                        "pulsestyle_onevent",
                                                        "pure",
                                                        "rand",
                                                        "randc",
                                                        "randcase",
                                                        "randsequence",
                                                        "rcmos",
                                                        "real",
                                                        "realtime",
                                                        "ref",
                                                        "reg",
                                                        "reject_on",
                                                        "release",
                                                        "repeat",
                                                        "restrict",
                                                        "return",
                                                        "rnmos",
                                                        "rpmos",
                                                        "rtran",
                                                        "rtranif0",
                                                        "rtranif1",
                                                        "s_always",
                                                        "s_eventually",
                                                        "s_nexttime",
                                                        "s_until",
                                                        "s_until_with",
                                                        "scalared",
                                                        "sequence",
                                                        "shortint",
                                                        "shortreal",
                                                        "showcancelled",
                                                        "signed",
                                                        "small",
                                                        "soft",
                                                        "solve",
                                                        "specify",
                                                        "specparam",
                                                        "static",
                                                        "string",
                                                        "strong",
                                                        "strong0",
                                                        "strong1",
                                                        "struct",
                                                        "super",
                                                        "supply0",
                                                        "supply1",
                                                        "sync_accept_on",
                                                        "sync_reject_on",
                                                        "table",
                                                        "tagged",
                                                        "task",
                                                        "this",
                                                        "throughout",
                                                        "time",
                                                        "timeprecision",
                                                        "timeunit",
                                                        "tran",
                                                        "tranif0",
                                                        "tranif1",
                                                        "tri",
                                                        "tri0",
                                                        "tri1",
                                                        "triand",
                                                        "trior",
                                                        "trireg",
                                                        "type",
                                                        "typedef",
                                                        "union",
                                                        "unique",
                                                        "unique0",
                                                        "unsigned",
                                                        "until",
                                                        "until_with",
                                                        "untyped",
                                                        "use",
                                                        "uwire",
                                                        "var",
                                                        "vectored",
                                                        "virtual",
                                                        "void",
                                                        "wait",
                                                        "wait_order",
                                                        "wand",
                                                        "weak",
                                                        "weak0",
                                                        "weak1",
                                                        "while",
                                                        "wildcard",
                                                        "wire",
                                                        "with",
                                                        "within",
                                                        "wor",
                                                        "xnor",
                                                        "xor"};
static_assert(std::is_sorted(keywords.begin(), keywords.end()));

/// Words that are no keywords of a standard, but that Icarus (bool, wreal) or Verilator (the types
/// of package std) reserves.
constexpr std::array<std::string_view, 5> words_of_tools = {"bool", "mailbox", "process",
                                                            "semaphore", "wreal"};

/// Names stand at the beginning of comments, and Verilator obeys comments that begin with this
/// word.
constexpr std::string_view comment_word = "verilator";

static_assert(!keywords.back().empty());

constexpr bool is_letter(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_';
}
constexpr bool is_digit(char c) {
  return '0' <= c && c <= '9';
}

}  // namespace

std::string name_problem(std::string_view name) {
  return name.size() > max_name_length ? "the name is too long" : identifier_problem(name);
}

std::string identifier_problem(std::string_view name) {
  if (name.empty()) return "the name is empty";
  const auto allowed = [](char c) { return is_letter(c) || is_digit(c); };
  if (!is_letter(name[0]) || !std::all_of(name.begin(), name.end(), allowed)) {
    return "not a name";
  }
  if (std::binary_search(keywords.begin(), keywords.end(), name)) {
    return fmt::format("\"{}\" is a Verilog or SystemVerilog keyword", name);
  }
  if (std::find(words_of_tools.begin(), words_of_tools.end(), name) != words_of_tools.end()) {
    return fmt::format("\"{}\" is a word that Icarus or Verilator takes for its own", name);
  }
  if (name.starts_with(comment_word)) {
    return fmt::format("Verilator obeys comments that begin with \"{}\"", comment_word);
  }
  return {};
}

std::string_view accepted_names() {
  return "a letter or '_', then letters, digits and '_', at most 64, no Verilog or SystemVerilog "
         "keyword, no simulator's own word";
}

std::string name_spelling(std::string name) {
  std::replace(name.begin(), name.end(), '[', '_');
  std::erase(name, ']');
  return name;
}

std::string subscript_problem(std::string_view key) {
  const std::size_t first = key.find_first_of("[]");
  if (first == 0) return "a subscript of nothing";
  std::string_view rest = first == std::string_view::npos ? "" : key.substr(first);
  while (!rest.empty()) {
    if (rest[0] != '[' && rest[0] != ']') return "text behind a subscript";
    const std::size_t end = rest.find(']');
    if (rest[0] == ']' || end == std::string_view::npos) return "a bracket without its other half";
    const std::string_view subscript = rest.substr(1, end - 1);
    const bool starred = subscript.find('*') != std::string_view::npos;
    const auto allowed = [](char c) { return is_digit(c) || c == '*'; };
    if (subscript.empty() || !std::all_of(subscript.begin(), subscript.end(), allowed)) {
      return "a subscript that is no number";
    }
    const bool padded = !starred && subscript.size() > 1 && subscript[0] == '0';
    if (padded) return "a subscript with a 0 before it";
    rest.remove_prefix(end + 1);
  }
  return {};
}

std::string_view accepted_subscripts() {
  return "\"p[2]\", the pattern \"p[*]\", or the name p_2";
}

}  // namespace mixcmp::inline expression

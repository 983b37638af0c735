#include "generator/hardware/emit/template_parts.hpp"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <utility>

#include "generator/hardware/emit/constants.hpp"
#include "generator/hardware/emit/template_ports.hpp"
#include "generator/hardware/emit/templates.hpp"
#include "model/base/common/check.hpp"
#include "model/base/common/memo.hpp"

namespace mixcmp::emit {
namespace {

bool is_one_of(Token token, std::initializer_list<Token> words) {
  return std::find(words.begin(), words.end(), token) != words.end();
}

/// Reads the body of a module, and collects the instances of templates.
class BodyReader {
public:
  std::vector<rtl::TemplateInstance> parts;
  bool is_refused = false;

  void read_items(Cursor& cursor, Constants& constants) {
    while (!is_one_of(cursor.peek(), {"end", "endmodule"})) read_item(cursor, constants);
  }

private:
  void read_item(Cursor& cursor, Constants& constants) {
    const Token first = cursor.peek();
    if (first == "(") {
      cursor.take_bracketed();  // an attribute
    } else if (is_one_of(first, {"wire", "reg", "integer", "genvar", "assign", "initial"})) {
      take_statement(cursor);
    } else if (!cursor.take_if("generate") && !cursor.take_if("endgenerate")) {
      read_item_with_parts(cursor, constants);
    }
  }

  void read_item_with_parts(Cursor& cursor, Constants& constants) {
    if (cursor.take_if("localparam")) {
      define(cursor, constants);
    } else if (cursor.take_if("function")) {
      constants.define_function(cursor);
    } else if (cursor.take_if("always")) {
      cursor.expect("@");
      if (!cursor.take_if("*")) cursor.take_bracketed();
      take_statement(cursor);
    } else if (cursor.take_if("if")) {
      read_if(cursor, constants);
    } else if (cursor.take_if("for")) {
      read_for(cursor, constants);
    } else {
      read_instance(cursor, constants);
    }
  }

  static void define(Cursor& cursor, Constants& constants) {
    if (cursor.peek() == "[") cursor.take_bracketed();
    const Token name = cursor.take();
    cursor.expect("=");
    constants.define(name, cursor.take_until({";"}));
    cursor.expect(";");
  }

  void read_block(const Tokens& block, const Constants& outer) {
    Cursor cursor(block);
    Constants constants(&outer);
    cursor.expect("begin");
    if (cursor.take_if(":")) cursor.take();
    read_items(cursor, constants);
  }

  void read_if(Cursor& cursor, const Constants& constants) {
    const bool holds = constants.value(cursor.take_bracketed()) != 0;
    const Tokens yes = take_statement(cursor);
    if (holds) read_block(yes, constants);
    if (!cursor.take_if("else")) return;
    if (cursor.peek() == "begin") {
      const Tokens no = take_statement(cursor);
      if (!holds) read_block(no, constants);
    } else {
      const Tokens next = take_statement(cursor);
      Cursor inner(next);
      inner.expect("if");
      if (!holds) read_if(inner, constants);
    }
  }

  void read_for(Cursor& cursor, const Constants& outer) {
    Cursor head(cursor.take_bracketed());
    const Tokens body = take_statement(cursor);
    Constants constants(&outer);
    constants.assign(head.take_until({";"}));
    head.expect(";");
    const Tokens condition = head.take_until({";"});
    head.expect(";");
    const Tokens step = head.take_until({Token()});
    for (; constants.value(condition) != 0; constants.assign(step)) read_block(body, constants);
  }

  void read_instance(Cursor& cursor, const Constants& constants) {
    rtl::TemplateInstance instance{std::string(cursor.take()), {}};
    if (cursor.take_if("#")) {
      Cursor given(cursor.take_bracketed());
      while (given.take_if(".")) {
        std::string name(given.take());
        const Tokens value = given.take_bracketed();
        instance.parameters.push_back({std::move(name), constants.value(value)});
        given.take_if(",");
      }
    }
    take_statement(cursor);  // its name and ports
    // A template refuses parameters by a module that does not exist.
    is_refused = is_refused || !is_template(instance.module);
    parts.push_back(std::move(instance));
  }
};

/// The tokens after a template's head, cached: area prediction asks for them thousands of times.
const Tokens& body_of(const std::string& module) {
  static Memo<std::string, Tokens> known;
  return *known.of(module, [&] {
    Cursor cursor(tokens_of(template_text(module)));
    cursor.take_until({";"});
    cursor.expect(";");
    return cursor.take_until({Token()});
  });
}

}  // namespace

std::vector<rtl::TemplateInstance> template_parts(const rtl::TemplateInstance& instance) {
  Constants constants;
  const std::vector<rtl::Parameter> parameters = template_parameters(instance);
  set_integers(constants, parameters);
  Cursor cursor(body_of(instance.module));
  BodyReader reader;
  reader.read_items(cursor, constants);
  if (reader.is_refused) return {};
  return std::move(reader.parts);
}

}  // namespace mixcmp::emit

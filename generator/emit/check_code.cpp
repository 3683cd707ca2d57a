// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/check_code.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "generator/emit/tokens.hpp"
#include "runtime/base/error.hpp"

namespace kanec::emit {
namespace {

using NameSet = std::unordered_set<std::string_view>;

template <std::size_t N>
bool is_one_of(std::string_view word, const std::array<std::string_view, N>& list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

constexpr std::array<std::string_view, 8> qualifiers = {"const",    "static",   "constexpr", "inline",
                                                        "typename", "unsigned", "extern",    "KANEC_APART"};
constexpr std::array<std::string_view, 8> types = {"void", "bool", "char", "short", "int", "float", "double", "auto"};
constexpr std::array<std::string_view, 13> statements = {"return", "case",    "default", "break",  "else",
                                                         "if",     "switch",  "new",     "delete", "sizeof",
                                                         "public", "private", "noexcept"};
constexpr std::array<std::string_view, 5> value_words = {"true", "false", "nullptr", "this", "static_cast"};

class Reader {
 public:
  Reader(std::string_view code, const std::vector<std::string>& around) : list_(tokens(code)), scopes_(1) {
    for (const std::string& name : around) scopes_[0].insert(name);
    scopes_[0].insert("std");
    scopes_.emplace_back();
  }

  void all() {
    while (now().kind != TokenKind::end) statement();
  }

 private:
  // --- tokens

  const Token& now(std::size_t ahead = 0) const { return list_[std::min(at_ + ahead, list_.size() - 1)]; }
  bool is(std::string_view text, std::size_t ahead = 0) const {
    return now(ahead).text == text && now(ahead).kind != TokenKind::text;
  }
  bool is_word(std::size_t ahead = 0) const { return now(ahead).kind == TokenKind::word; }
  bool take(std::string_view text) {
    if (!is(text)) return false;
    ++at_;
    return true;
  }
  // Past what is of no interest.
  void skip() {
    if (now().kind == TokenKind::end) fail("more is missing at ", "the end");
    ++at_;
  }
  void expect(std::string_view text) {
    if (!take(text)) fail("'" + std::string(text) + "' is missing before ", now().text);
  }
  std::string_view take_word() {
    if (!is_word()) fail("a name is missing before ", now().text);
    return list_[at_++].text;
  }

  [[noreturn]] void fail(const std::string& what, std::string_view name) const {
    throw InternalError("emitted code: " + what + std::string(name) +
                        (function_.empty() ? "" : " (in " + std::string(function_) + ")"));
  }

  // --- names

  void declare(std::string_view name) {
    if (!scopes_.back().insert(name).second) fail("a second definition of ", name);
  }

  void use(std::string_view name) const {
    const auto has = [name](const NameSet& scope) { return scope.count(name) > 0; };
    if (std::any_of(scopes_.rbegin(), scopes_.rend(), has) || has(pending_) || is_one_of(name, qualifiers) ||
        is_one_of(name, types) || is_one_of(name, statements) || is_one_of(name, value_words))
      return;
    fail("use before the definition of ", name);
  }

  void use_member(std::string_view owner, std::string_view name) const {
    const auto known = members_.find(owner);
    if (known != members_.end() && known->second.count(name) == 0)
      fail("use before the definition of " + std::string(owner) + "::", name);
  }

  // Of the struct that pieces share: set once, and before it is read. Arrays are filled by calls.
  void set_shared(std::string_view field) {
    if (!set_.insert(field).second) fail("set twice: shared.", field);
  }
  void use_shared(std::string_view field) const {
    if (field != "cosines" && field != "sines" && set_.count(field) == 0) fail("read before it is set: shared.", field);
  }

  // --- statements

  void statement() {
    if (take(";")) return;
    if (is("{")) return scoped([this] { block(); });
    if (take("template")) return parameters_of_template();
    if (take("namespace")) return named_block(qualified_name());
    if (take("using")) return import();
    if (is("typedef") && !is("struct", 1)) ++at_;
    if (take("typedef")) return type();
    if ((is("struct") || is("class")) && is_word(1)) return type();
    if (is("enum")) return enumeration();
    if (take("for")) return scoped([this] { loop(); });
    if (take("if") || take("switch")) return choice();
    if (take("else")) return statement();
    if (is("public") || is("private") || is("default")) return void(at_ += 2);
    if (take("case")) {
      expression(":");
      return expect(":");
    }
    if (is_declaration()) return declaration();
    if (is("shared") && (is(".", 1) || is("->", 1)) && is("=", 3)) return assignment_to_shared();
    some_expression(";");
    expect(";");
  }

  template <class Work>
  void scoped(const Work& work) {
    scopes_.emplace_back(std::exchange(pending_, {}));
    work();
    scopes_.pop_back();
  }

  void block() {
    expect("{");
    while (!is("}")) {
      if (now().kind == TokenKind::end) fail("a brace is open at ", "the end");
      statement();
    }
    expect("}");
  }

  std::string_view qualified_name() {
    std::string_view name = take_word();
    while (take("::")) name = take_word();
    return name;
  }

  void named_block(std::string_view name) {
    scopes_.back().insert(name);  // a namespace may be opened again
    scopes_.emplace_back(std::exchange(pending_, {}));
    block();
    NameSet& members = members_[name];
    members.insert(scopes_.back().begin(), scopes_.back().end());
    scopes_.pop_back();
    take(";");
  }

  void type() {
    ++at_;
    const std::string_view name = take_word();
    scopes_.back().insert(name);  // again where it is specialised
    if (take("<")) skip_to_close(1);
    while (!is("{") && !is(";")) skip();
    if (take(";")) return;
    if (name.ends_with("Shared")) set_.clear();  // of another function
    named_block(name);
  }

  // enum : int { a, b, count };
  void enumeration() {
    while (!is("{")) skip();
    skip();
    while (!take("}")) {
      declare(take_word());
      while (!is(",") && !is("}")) skip();
      take(",");
    }
    expect(";");
  }

  // Behind an opening angle bracket.
  void skip_to_close(int depth) {
    for (; depth > 0; skip()) depth += is("<") ? 1 : is(">") ? -1 : 0;
  }

  void parameters_of_template() {
    expect("<");
    while (!take(">")) {
      skip();  // class, typename, int
      if (is_word()) pending_.insert(take_word());
      take(",");
    }
  }

  void import() {
    if (take("namespace")) {
      const auto known = members_.find(qualified_name());
      if (known != members_.end()) scopes_.back().insert(known->second.begin(), known->second.end());
      return expect(";");
    }
    do {
      const std::string_view name = qualified_name();
      scopes_.back().insert(name);
      if (is("=")) expression(";");
    } while (take(","));
    expect(";");
    pending_.clear();  // of an alias template
  }

  void loop() {
    expect("(");
    if (is_declaration()) {
      declarators();
      if (take(":")) expression(")");
    }
    while (!take(")")) {
      if (!take(";")) some_expression(is_before_close() ? ")" : ";");
    }
    statement();
  }

  // Whether what is left of a loop's head holds no further semicolon.
  bool is_before_close() const {
    int depth = 0;
    for (std::size_t i = at_; i < list_.size(); ++i) {
      const std::string_view text = list_[i].text;
      if (text == ";") return false;
      if (text == "(") ++depth;
      if (text == ")" && depth-- == 0) return true;
    }
    return true;
  }

  void choice() {
    expect("(");
    expression(")");
    expect(")");
    statement();
  }

  // shared.a = a;
  void assignment_to_shared() {
    const std::string_view field = now(2).text;
    at_ += 4;
    expression(";");
    expect(";");
    set_shared(field);
  }

  // --- declarations

  // The place behind a type that begins here; here where none does. No names are looked up.
  std::size_t behind_type() const {
    std::size_t i = 0;
    const auto is_qualifier = [&] { return is_word(i) && is_one_of(now(i).text, qualifiers); };
    bool is_type = false;
    while (is_qualifier()) is_type |= now(i++).text == "unsigned";
    if (is_word(i) && !is_one_of(now(i).text, statements) && !is_one_of(now(i).text, value_words)) {
      ++i;
      while (is("::", i) && is_word(i + 1)) i += 2;
      if (is("<", i)) {
        int depth = 0;
        std::size_t j = i;
        do depth += is("<", j) ? 1 : is(">", j) ? -1 : 0;
        while (++j, depth > 0 && !is(";", j - 1) && at_ + j < list_.size());
        if (depth > 0) return 0;
        i = j;
      }
      is_type = true;
    }
    if (!is_type) return 0;
    while (is("*", i) || is("&", i) || is("const", i)) ++i;
    return i;
  }

  bool is_declaration() const {
    const std::size_t i = behind_type();
    if (i == 0) return false;
    if (is("[", i)) return is("&", i - 1) || is("auto", i - 1);  // const auto& [a, b] = ...
    return is_word(i) && !is_one_of(now(i).text, statements) &&
           (is("=", i + 1) || is(";", i + 1) || is("[", i + 1) || is("{", i + 1) || is(",", i + 1) || is("(", i + 1) ||
            is(":", i + 1) || is(")", i + 1));
  }

  void declaration() {
    declarators();
    take(";");
  }

  // A type, then names with what they are; declared behind their values, which may not speak of them.
  void declarators() {
    use_type(at_ + behind_type());
    if (is("[")) return binding();
    do {
      while (take("*") || take("&") || take("const")) {
      }
      const std::string_view name = take_word();
      if (is("(")) return function(name);
      while (take("[")) {
        expression("]");
        expect("]");
      }
      if (take("="))
        expression(",");
      else if (is("{"))
        braces();
      pending_.clear();  // of a variable template
      declare(name);
    } while (take(","));
  }

  void use_type(std::size_t end) {
    for (; at_ < end; ++at_)
      if (is_word() && (at_ == 0 || list_[at_ - 1].text != "::")) use_qualified();
  }

  // A name of a type with what it is qualified by.
  void use_qualified() const {
    const std::string_view name = now().text;
    is("::", 1) ? use_member(name, now(2).text) : use(name);
  }

  // const auto& [a, b] = table[row];
  void binding() {
    expect("[");
    std::vector<std::string_view> names;
    do names.push_back(take_word());
    while (take(","));
    expect("]");
    expect("=");
    expression(";");
    for (const std::string_view name : names) declare(name);
  }

  void function(std::string_view name) {
    declare(name);
    NameSet inside = std::exchange(pending_, {});
    const std::string_view before = std::exchange(function_, name);
    scopes_.push_back(std::move(inside));
    expect("(");
    if (is("void") && is(")", 1)) ++at_;
    while (!take(")")) {
      const std::size_t end = at_ + behind_type();
      use_type(end);
      declare(take_word());
      if (!is(")")) expect(",");
    }
    while (!is("{") && !is(";")) skip();
    if (!take(";")) block();
    scopes_.pop_back();
    function_ = before;
  }

  // --- expressions

  void braces() {
    expect("{");
    while (!take("}"))
      if (!take(",")) some_expression("}");
  }

  // Up to `stop` or a comma, semicolon or bracket that closes, whichever comes first; a comma ends it where it is asked
  // for.
  void expression(std::string_view stop) {
    int depth = 0;
    for (;; ++at_) {
      const Token& token = now();
      if (token.kind == TokenKind::end) fail("no end of an expression before ", "the end");
      if (depth == 0 && (is(stop) || is(";"))) return;
      if (is("(") || is("[") || is("{")) ++depth;
      if (is(")") || is("]") || is("}")) {
        if (depth == 0) return;
        --depth;
      }
      if (token.kind == TokenKind::word) word();
    }
  }

  // One that is not empty.
  void some_expression(std::string_view stop) {
    const std::size_t begin = at_;
    expression(stop);
    if (at_ == begin) fail("no expression before ", now().text);
  }

  void word() {
    const std::string_view name = now().text;
    const std::string_view before = at_ > 0 ? list_[at_ - 1].text : "";
    if (before == "." || before == "->") {
      if (at_ > 1 && list_[at_ - 2].text == "shared") use_shared(name);
      return;
    }
    if (before == "::") {
      const bool has_owner = at_ > 1 && list_[at_ - 2].kind == TokenKind::word;
      return has_owner ? use_member(list_[at_ - 2].text, name) : void();
    }
    use(name);
  }

  std::vector<Token> list_;
  std::size_t at_ = 0;
  std::vector<NameSet> scopes_;
  NameSet pending_;                                        // parameters of the template that follows
  std::unordered_map<std::string_view, NameSet> members_;  // of namespaces and types
  NameSet set_;                                            // fields of `shared`
  std::string_view function_;
};

}  // namespace

void check_code(std::string_view code, const std::vector<std::string>& around) { Reader(code, around).all(); }

}  // namespace kanec::emit

// SPDX-License-Identifier: BSD-3-Clause
#include "tests/symbolic/latex_check.hpp"

#include <cctype>
#include <set>

namespace kanec::test {
namespace {

const std::set<std::string>& known_commands() {
  static const std::set<std::string> known = {
      "begin", "end", "section", "subsection", "row", "brk", "brkin", "brkfac", "text", "mathrm", "operatorname",
      "tilde", "widetilde", "dot", "ddot", "bar", "tfrac", "sqrt", "sum", "left", "right", "lvert", "rvert",
      // letters, signs, functions
      "omega", "theta", "varepsilon", "lambda", "mu", "rho", "tau", "pi", "dim", "cdot", "times", "prime", "sin", "cos",
      "tan", "arcsin", "arccos", "tanh", "exp", "ln", "min", "max",
      // tables
      "small", "relpenalty", "binoppenalty", "hbadness", "raggedright", "arraybackslash", "linewidth", "hline",
      "noalign", "vspace", "endhead", "allowbreak",
      // characters in names
      "textbackslash", "textasciitilde", "textasciicircum", "textless", "textgreater", "textbar"};
  return known;
}

struct Group {
  bool math = false, began_as_math = false;
  bool is_script = false;
  bool is_environment = false;  // the name of one that begins or ends
  std::size_t start = 0;
  // of the letter before the place that is read
  bool has_letter = false, has_sub = false, has_super = false;
};

class Check {
 public:
  explicit Check(const std::string& text) : text_(text), groups_(1) {}

  std::vector<std::string> faults() {
    const std::size_t body = text_.find("\\begin{document}");
    if (body == std::string::npos) fault("no document");
    while (at_ < text_.size()) read();
    if (groups_.size() > 1) fault("a brace is open at the end");
    if (groups_.back().math) fault("a formula is open at the end");
    if (!environments_.empty()) fault("environment " + environments_.back() + " is open at the end");
    return faults_;
  }

 private:
  Group& group() { return groups_.back(); }
  bool is_in_body() const { return in_body_; }

  void read() {
    const char c = text_[at_];
    if (c != '\n' && (c < ' ' || c > '~')) fault("not printable");
    switch (c) {
      case '\\':
        return command();
      case '{':
        return open();
      case '}':
        return close();
      case '$':
        group().math = !group().math;
        group().has_letter = false;
        break;
      case '%':
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
        return;
      case '_':
      case '^':
        return script(c);
      case '\'':
        if (group().math) mark(group().has_super, "two superscripts");
        break;
      case '&':
        group().has_letter = false;
        break;
      case ' ':
      case '\n':
        break;
      default:
        letter();
    }
    ++at_;
  }

  void letter() { group().has_letter = true, group().has_sub = group().has_super = false; }

  void mark(bool& known, const char* what) {
    if (known) fault(what);
    known = true;
  }

  void script(char c) {
    if (!is_in_body()) {
      ++at_;
      return;
    }
    if (!group().math) fault("a script outside of a formula");
    if (!group().has_letter) fault("a script on nothing");
    mark(c == '_' ? group().has_sub : group().has_super, c == '_' ? "two subscripts" : "two superscripts");
    const char next = ++at_ < text_.size() ? text_[at_] : ' ';
    if (next == '{')
      push(group().math, true);
    else if (std::isalnum(static_cast<unsigned char>(next)))
      ++at_;
    else
      fault("an empty script");
  }

  void push(bool math, bool is_script) {
    groups_.push_back({.math = math, .began_as_math = math, .is_script = is_script, .start = ++at_});
  }

  void open() {
    bool math = group().math;
    if (formulas_ahead_ > 0 && groups_.size() == depth_of_formulas_) {
      --formulas_ahead_;
      math = true;
    }
    if (text_ahead_) math = false;
    text_ahead_ = false;
    const bool is_environment = environment_ahead_ != 0;
    letter();
    push(math, false);
    group().is_environment = is_environment;
  }

  void close() {
    if (groups_.size() == 1) {
      fault("a brace too many");
      ++at_;
      return;
    }
    const Group done = group();
    if (done.math != done.began_as_math) fault("a formula that does not end with its braces");
    groups_.pop_back();
    const std::string inside = text_.substr(done.start, at_ - done.start);
    if (done.is_script && inside.find_first_not_of(' ') == std::string::npos) fault("an empty script");
    if (done.is_environment) environment(inside);
    ++at_;
  }

  void environment(const std::string& name) {
    if (environment_ahead_ == 'b') {
      environments_.push_back(name);
      if (name == "document") in_body_ = true;
      if (name == "rows") expect_formulas(1);
    } else if (environments_.empty() || environments_.back() != name) {
      fault("the end of " + name + ", which is not open");
    } else {
      environments_.pop_back();
    }
    environment_ahead_ = 0;
  }

  void expect_formulas(int n) {
    formulas_ahead_ = n;
    depth_of_formulas_ = groups_.size();
  }

  void command() {
    std::size_t end = at_ + 1;
    while (end < text_.size() && std::isalpha(static_cast<unsigned char>(text_[end]))) ++end;
    const std::string name = text_.substr(at_ + 1, end - at_ - 1);
    if (name.empty()) {
      const char symbol = end < text_.size() ? text_[end] : ' ';
      if (std::string("\\,;_#%&${}").find(symbol) == std::string::npos) fault("an unknown command");
      letter();
      if (symbol == '\\') group().has_letter = false;
      at_ = end + 1;
      return;
    }
    at_ = end;
    const bool is_definition = !is_in_body() && (name == "newcommand" || name == "newenvironment");
    if (is_definition) return skip_definition();
    if (is_in_body() && known_commands().count(name) == 0) fault("the unknown command " + name);
    if (name == "begin" || name == "end") environment_ahead_ = name[0];
    if (name == "row") expect_formulas(2);
    text_ahead_ = name == "text" || name == "operatorname";
    letter();
  }

  // What a definition in the preamble holds need not match within itself but for braces.
  void skip_definition() {
    int depth = 0;
    for (; at_ < text_.size(); ++at_) {
      depth += (text_[at_] == '{') - (text_[at_] == '}');
      if (text_[at_] == '\n' && depth == 0) return;
    }
  }

  void fault(const std::string& what) {
    const std::size_t from = at_ < 40 ? 0 : at_ - 40;
    faults_.push_back(what + ": " + text_.substr(from, 60));
  }

  const std::string& text_;
  std::vector<Group> groups_;
  std::vector<std::string> environments_;
  std::vector<std::string> faults_;
  std::size_t at_ = 0;
  bool in_body_ = false;
  int formulas_ahead_ = 0;
  std::size_t depth_of_formulas_ = 0;
  bool text_ahead_ = false;
  char environment_ahead_ = 0;
};

}  // namespace

std::vector<std::string> latex_faults(const std::string& document) { return Check(document).faults(); }

}  // namespace kanec::test

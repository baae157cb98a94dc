#include "import/formula.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <map>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"
#include "base/math.h"

namespace repose {
namespace {

constexpr int deepest = 200;  // parentheses within one another

struct Function {
  std::size_t arguments;
  double (*value)(const double*);
};

const std::map<std::string, Function, std::less<>>& functions() {
  static const std::map<std::string, Function, std::less<>> known = {
      {"sqrt", {1, [](const double* x) { return std::sqrt(x[0]); }}},
      {"exp", {1, [](const double* x) { return std::exp(x[0]); }}},
      {"ln", {1, [](const double* x) { return std::log(x[0]); }}},
      {"log", {1, [](const double* x) { return std::log10(x[0]); }}},
      {"abs", {1, [](const double* x) { return std::fabs(x[0]); }}},
      {"sin", {1, [](const double* x) { return std::sin(x[0]); }}},
      {"cos", {1, [](const double* x) { return std::cos(x[0]); }}},
      {"tan", {1, [](const double* x) { return std::tan(x[0]); }}},
      {"asin", {1, [](const double* x) { return std::asin(x[0]); }}},
      {"acos", {1, [](const double* x) { return std::acos(x[0]); }}},
      {"atan", {1, [](const double* x) { return std::atan(x[0]); }}},
      {"atan2", {2, [](const double* x) { return std::atan2(x[0], x[1]); }}},
      {"ceil", {1, [](const double* x) { return std::ceil(x[0]); }}},
      {"floor", {1, [](const double* x) { return std::floor(x[0]); }}},
      {"round", {1, [](const double* x) { return std::round(x[0]); }}},
  };
  return known;
}

/// By recursive descent, one function per level of precedence, the loosest first.
class Parser {
 public:
  Parser(std::string_view text, const NamedValue& value_of) : text_(text), value_of_(value_of) {}

  double whole() {
    const double value = disjunction();
    skip_blanks();
    if (at_ < text_.size()) fail(fmt::format("\"{}\" is not expected", text_.substr(at_)));
    if (!std::isfinite(value)) fail("it is not finite");
    return value;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw DeckError(fmt::format("formula \"{}\": {}", text_, what));
  }
  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  bool take(std::string_view symbol) {
    skip_blanks();
    if (!text_.substr(at_).starts_with(symbol)) return false;
    at_ += symbol.size();
    return true;
  }

  using Operand = double (Parser::*)();
  struct Operator {
    std::string_view symbol;
    double (*value)(double, double);
  };
  /// Operands between operators that bind alike, from the left; a longer symbol stands before its own beginning.
  double chain(Operand operand, std::initializer_list<Operator> operators) {
    double value = (this->*operand)();
    while (true) {
      const auto found =
          std::find_if(operators.begin(), operators.end(), [&](const Operator& o) { return take(o.symbol); });
      if (found == operators.end()) return value;
      value = found->value(value, (this->*operand)());
    }
  }
  static double truth(bool holds) { return holds ? 1.0 : 0.0; }

  double disjunction() {
    return chain(&Parser::conjunction, {{"||", [](double a, double b) { return truth(a != 0.0 || b != 0.0); }}});
  }
  double conjunction() {
    return chain(&Parser::equality, {{"&&", [](double a, double b) { return truth(a != 0.0 && b != 0.0); }}});
  }
  double equality() {
    return chain(&Parser::comparison, {{"==", [](double a, double b) { return truth(a == b); }},
                                       {"!=", [](double a, double b) { return truth(a != b); }}});
  }
  double comparison() {
    return chain(&Parser::sum, {{"<=", [](double a, double b) { return truth(a <= b); }},
                                {">=", [](double a, double b) { return truth(a >= b); }},
                                {"<", [](double a, double b) { return truth(a < b); }},
                                {">", [](double a, double b) { return truth(a > b); }}});
  }
  double sum() {
    return chain(&Parser::product,
                 {{"+", [](double a, double b) { return a + b; }}, {"-", [](double a, double b) { return a - b; }}});
  }

  double product() {
    double value = power();
    for (;;) {
      if (take("*")) {
        value *= power();
      } else if (take("/")) {
        value /= divisor();
      } else if (take("%")) {
        value = std::fmod(value, divisor());
      } else {
        return value;
      }
    }
  }

  double divisor() {
    const double value = power();
    if (value == 0.0) fail("a division by zero");
    return value;
  }

  double power() {
    return chain(&Parser::sign, {{"^", [](double a, double b) { return std::pow(a, b); }}});
  }

  /// Tighter than ^: -2^2 is 4.
  double sign() {
    if (++depth_ > deepest) fail("it is nested too deeply");
    double value = 0.0;
    if (take("-")) {
      value = -sign();
    } else if (take("!")) {
      value = sign() == 0.0 ? 1.0 : 0.0;
    } else {
      value = item();
    }
    --depth_;
    return value;
  }

  double item() {
    if (take("(")) {
      if (++depth_ > deepest) fail("it is nested too deeply");
      const double value = disjunction();
      if (!take(")")) fail("a parenthesis is not closed");
      --depth_;
      return value;
    }
    skip_blanks();
    double value = 0.0;
    const auto [end, problem] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    const char first = at_ < text_.size() ? text_[at_] : '\0';
    if (problem == std::errc{} && (std::isdigit(static_cast<unsigned char>(first)) != 0 || first == '.')) {
      at_ = static_cast<std::size_t>(end - text_.data());
      return value;
    }
    return named();
  }

  double named() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_'))
      ++at_;
    const std::string name(text_.substr(begin, at_ - begin));
    if (name.empty())
      fail(begin < text_.size() ? fmt::format("\"{}\" is not expected", text_[begin]) : "it ends early");
    if (name == "PI") return pi;
    const auto found = functions().find(name);
    if (found == functions().end()) {
      if (const std::optional<double> value = value_of_(name)) return *value;
      fail(fmt::format("\"{}\" is no constant, or known only while the simulation runs", name));
    }
    return call(name, found->second);
  }

  double call(const std::string& name, const Function& function) {
    if (!take("(")) fail(fmt::format("{} needs its arguments in parentheses", name));
    if (++depth_ > deepest) fail("it is nested too deeply");
    std::array<double, 2> arguments{};
    for (std::size_t k = 0; k < function.arguments; ++k) {
      if (k > 0 && !take(",")) fail(fmt::format("{} takes {} arguments", name, function.arguments));
      arguments.at(k) = disjunction();
    }
    if (!take(")"))
      fail(fmt::format("{} takes {} argument{}", name, function.arguments, function.arguments > 1 ? "s" : ""));
    --depth_;
    return function.value(arguments.data());
  }

  std::string_view text_;
  const NamedValue& value_of_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

double evaluate(std::string_view formula, const NamedValue& value_of) { return Parser(formula, value_of).whole(); }

}  // namespace repose

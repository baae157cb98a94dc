#include "commands/options.h"

#include <cmath>
#include <cstdlib>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "base/error.h"

namespace repose {

void Options::argument(const std::string& name, std::string& value, const std::string& meaning, Need need) {
  app_.add_option(name, value, meaning)->required(need == Need::must);
}

void Options::arguments(const std::string& name, std::vector<std::string>& values, const std::string& meaning,
                        int count, const std::string& shown) {
  CLI::Option* option = app_.add_option(name, values, meaning)->required();
  if (count > 0) option->expected(count)->type_name(shown);
}

void Options::option(const std::string& name, std::string& value, const std::string& kind, const std::string& meaning,
                     Need need) {
  app_.add_option(name, value, meaning)->required(need == Need::must)->type_name(kind);
}

void Options::repeatable(const std::string& name, std::vector<std::string>& values, const std::string& kind,
                         const std::string& meaning) {
  app_.add_option(name, values, meaning)->type_name(kind)->allow_extra_args(false);  // arguments may follow
}

void Options::choice(const std::string& name, std::string& value, const std::vector<std::string>& choices,
                     const std::string& meaning, Need need) {
  CLI::Option* option = app_.add_option(name, value, meaning)->check(CLI::IsMember(choices));
  if (need == Need::must) {
    option->required();
  } else {
    option->capture_default_str();
  }
}

void Options::parsed(const std::string& name, std::function<void(const std::string&)> read, const std::string& kind,
                     const std::string& meaning) {
  app_.add_option_function<std::string>(name, std::move(read), meaning)->type_name(kind);
}

void Options::quantity(const std::string& name, double& value, const Quantity& what, const std::string& meaning) {
  const auto read = [name, what, &value](const std::string& text) {
    const char* const first = text.c_str();
    char* rest = nullptr;
    const double number = std::strtod(first, &rest);
    const repose::Quantity given =
        rest != first && *rest == '\0' ? repose::Quantity{number, ""} : parse_quantity(text, what.unit);
    value = given.value;
    if (given.problem.empty() && std::isfinite(value) && what.range.contains(value)) return;
    throw DeckError(fmt::format("{} {}: must be {}", name, text, what.wanted));
  };
  parsed(name, read, what.kind, meaning);
}

void Options::flag(const std::string& name, bool& value, const std::string& meaning) {
  app_.add_flag(name, value, meaning);
}

void declare_overrides(Options& options, std::vector<std::string>& overrides) {
  options.repeatable("--set", overrides, "KEY=VALUE", "replace a key of the deck, such as time.step=2e-6; repeatable");
}

void declare_deck(Options& options, std::string& deck, std::vector<std::string>& overrides) {
  options.argument("DECK", deck, "deck (TOML)");
  declare_overrides(options, overrides);
}

}  // namespace repose

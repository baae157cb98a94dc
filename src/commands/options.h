#pragma once

#include <functional>
#include <string>
#include <vector>

#include "deck/key.h"

namespace CLI {
class App;
}

namespace repose {

/// Declares what a command takes on the command line. The variables get their values when the command line is parsed;
/// they have to live until then.
class Options {
 public:
  explicit Options(CLI::App& app) : app_(app) {}

  enum class Need { must, may };
  /// A word without a dash.
  void argument(const std::string& name, std::string& value, const std::string& meaning, Need need = Need::must);
  /// One or more of them; with a `count`, exactly so many, which the help calls `shown`.
  void arguments(const std::string& name, std::vector<std::string>& values, const std::string& meaning, int count = 0,
                 const std::string& shown = "");
  /// An option with a text; `kind` is what the help calls it, such as DIR.
  void option(const std::string& name, std::string& value, const std::string& kind, const std::string& meaning,
              Need need = Need::may);
  /// An option that may be given several times.
  void repeatable(const std::string& name, std::vector<std::string>& values, const std::string& kind,
                  const std::string& meaning);
  /// An option with one of a few texts; the help shows the present value if it need not be given.
  void choice(const std::string& name, std::string& value, const std::vector<std::string>& choices,
              const std::string& meaning, Need need = Need::may);
  /// An option whose text is read by a function, which may throw DeckError.
  void parsed(const std::string& name, std::function<void(const std::string&)> read, const std::string& kind,
              const std::string& meaning);
  /// What a number on the command line may be; `kind` as of an option, `wanted` as in "must be a length above 0".
  struct Quantity {
    std::string kind;
    Unit unit;
    Range range;
    std::string wanted;
  };
  /// An option with a number, in SI or as a text with its unit. DeckError when it is not what is wanted.
  void quantity(const std::string& name, double& value, const Quantity& what, const std::string& meaning);
  void flag(const std::string& name, bool& value, const std::string& meaning);

 private:
  CLI::App& app_;
};

/// DECK and --set.
void declare_deck(Options& options, std::string& deck, std::vector<std::string>& overrides);
/// --set.
void declare_overrides(Options& options, std::vector<std::string>& overrides);

}  // namespace repose

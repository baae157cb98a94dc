#include "deck/repeated_sections.h"

#include <utility>
#include <vector>

#include "deck/deck.h"
#include "deck/value_text.h"

namespace repose {
namespace {

/// The visitor that notes them.
class Repeated {
 public:
  template <class T>
  void operator()(std::string_view, T&, Unit, const Range&, const Presence&, std::string_view) {}

  template <class S>
  void section(std::string_view name, S& value, const Presence&, std::string_view) {
    visit(name, [&] { describe(*this, value); });
  }

  template <class S>
  void sections(std::string_view name, std::vector<S>&, const Presence&, std::string_view) {
    visit(name, [&] {
      found.insert(around_);
      S one;
      describe(*this, one);
    });
  }

  template <class F>
  void group(std::string_view name, F&& inside) {
    visit(name, [&] { inside(*this); });
  }

  std::set<std::string> found;

 private:
  template <class F>
  void visit(std::string_view name, F&& inside) {
    const std::string outer = std::exchange(around_, child(around_, name));
    inside();
    around_ = outer;
  }

  std::string around_;
};

}  // namespace

const std::set<std::string>& repeated_sections() {
  static const std::set<std::string> all = [] {
    Deck deck;
    Repeated visitor;
    describe(visitor, deck);
    return visitor.found;
  }();
  return all;
}

}  // namespace repose

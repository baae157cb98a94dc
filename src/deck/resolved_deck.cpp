#include "deck/resolved_deck.h"

#include <utility>

#include <fmt/core.h>

#include "deck/deck.h"
#include "deck/key_reference.h"
#include "deck/value_text.h"

namespace repose {
namespace {

/// The visitor that writes a deck.
class Writer {
 public:
  template <class T>
  void operator()(std::string_view key, T& value, Unit, const Range& range, const Presence& presence,
                  std::string_view) {
    if (presence.applies && is_given(value, range)) text_ += fmt::format("{} = {}\n", key, toml_text(value));
  }

  template <class S>
  void section(std::string_view name, S& value, const Presence& presence, std::string_view) {
    if constexpr (requires { value.enabled; }) {
      if (!value.enabled || !presence.applies) return;
    }
    text_ += fmt::format("\n[{}{}]\n", group_, name);
    describe_inside(name, value);
  }

  template <class S>
  void sections(std::string_view name, std::vector<S>& values, const Presence&, std::string_view) {
    for (S& value : values) {
      text_ += fmt::format("\n[[{}{}]]\n", group_, name);
      describe_inside(name, value);
    }
  }

  template <class F>
  void group(std::string_view name, F&& visit) {
    group_ = fmt::format("{}.", name);
    visit(*this);
    group_.clear();
  }

  const std::string& text() const { return text_; }

 private:
  template <class S>
  void describe_inside(std::string_view name, S& value) {
    const std::string outer = std::exchange(group_, fmt::format("{}{}.", group_, name));
    describe(*this, value);
    group_ = outer;
  }

  std::string text_;
  std::string group_;
};

}  // namespace

std::string resolved_deck(const Deck& deck) {
  Deck copy = deck;  // the schema names members of a deck that may be changed
  Writer writer;
  describe(writer, copy);
  return writer.text();
}

std::string deck_keys() {
  return key_reference<Deck>("Keys of a deck. A number is SI; a text such as \"440 um\" carries its unit.");
}

}  // namespace repose

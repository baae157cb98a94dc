#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.h"
#include "import/place.h"

namespace repose {

/// A command of a script as it is carried out: variables are replaced, quotes taken off.
struct ScriptCommand {
  Place place;
  std::vector<std::string> words;  ///< at least one
};

/// The words in one line.
std::string text(const ScriptCommand& command);

/// A finite number; DeckError at the place when `word` is something else. `what` names it in the message.
double number_of(const std::string& word, const Place& place, std::string_view what);
/// The same for a whole number of at most this magnitude.
std::int64_t integer_of(const std::string& word, const Place& place, std::string_view what, double most);

/// Reads the words of a command one after the other. What is missing or malformed is a DeckError at its line.
class Words {
 public:
  explicit Words(const ScriptCommand& command, std::size_t first = 1) : command_(command), next_(first) {}

  const Place& place() const { return command_.place; }
  const ScriptCommand& command() const { return command_; }
  bool at_end() const { return next_ >= command_.words.size(); }
  /// Whether the next word is this one, which then is behind us.
  bool take(std::string_view word);
  /// The next word must be this one.
  void expect(std::string_view word);

  const std::string& word(std::string_view what);
  double number(std::string_view what);
  std::int64_t integer(std::string_view what);
  /// A number of steps, of which LIGGGHTS takes the whole part.
  std::int64_t steps(std::string_view what);
  Vec3 vector(std::string_view what);
  /// Of atoms or walls, from 1 on.
  int type();
  /// yes or no, on or off.
  bool choice(std::string_view what);
  /// Whether the word `key`, just read, is one that changes nothing here; its values, as many as stand beside it, are
  /// behind us then.
  bool skip_needless(const std::string& key, const std::map<std::string, int>& needless);
  /// All that are left.
  std::vector<std::string> rest();
  [[noreturn]] void fail(const std::string& what) const { refuse(command_.place, what); }

 private:
  const ScriptCommand& command_;
  std::size_t next_;
};

}  // namespace repose

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "import/script_command.h"

namespace repose {

/// The variables of a script. Formulas are kept as they are and evaluated when they are asked for, as LAMMPS does.
class Variables {
 public:
  /// `variable NAME STYLE ARGUMENTS`: index, loop, string, equal, delete; formulas of atom are kept as text.
  void define(const ScriptCommand& command);
  /// What the keyword dt of formulas is from now on.
  void set_time_step(double step) { time_step_ = step; }
  /// The next value of an index or a loop; false, and the variable is gone, when there is none.
  bool advance(const std::string& name, const Place& place);

  /// As a word of a command; of a formula with 15 digits, as LIGGGHTS writes it.
  std::string text(const std::string& name, const Place& place) const;
  /// Value of a formula that may name variables.
  double value(const std::string& formula, const Place& place) const;
  /// Of the variables of atom style that the words of a command name as v_NAME, their formulas in place of the words.
  void put_atom_formulas(std::vector<std::string>& words) const;
  /// A line with ${name}, $x and $(formula) replaced outside of quotes, if `in_quotes` is false.
  std::string replaced(const std::string& line, const Place& place, bool in_quotes = false) const;

 private:
  enum class Style { list, text, formula, of_atoms };
  struct Variable {
    Style style;
    std::vector<std::string> values;
    std::size_t at = 0;
  };
  const Variable& find(const std::string& name, const Place& place) const;
  std::string text(const std::string& name, const Place& place, int depth) const;
  double value(const std::string& formula, const Place& place, int depth) const;
  std::size_t replace_one(const std::string& line, std::size_t at, const Place& place, std::string& result) const;

  std::map<std::string, Variable> variables_;
  std::optional<double> time_step_;
};

}  // namespace repose

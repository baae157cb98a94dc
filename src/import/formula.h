#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace repose {

/// The value that a name such as v_NAME or c_NAME has, or nothing; may throw.
using NamedValue = std::function<std::optional<double>(const std::string& name)>;

/// Value of a formula of LAMMPS's equal-style variables, as far as it is constant: numbers, PI, names, + - * / % ^,
/// comparisons, && || !, and the functions of one or two numbers (docs.lammps.org/variable.html). DeckError with one
/// line for anything else, such as keywords that are known only while a simulation runs.
double evaluate(std::string_view formula, const NamedValue& value_of);

}  // namespace repose

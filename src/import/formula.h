#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace repose {

/// The value of the variable of a name; may throw.
using VariableValue = std::function<double(const std::string& name)>;

/// Value of a formula of LAMMPS's equal-style variables, as far as it is constant: numbers, PI, v_name, + - * / % ^,
/// comparisons, && || !, and the functions of one or two numbers (docs.lammps.org/variable.html). DeckError with one
/// line for anything else, such as keywords that are known only while a simulation runs.
double evaluate(std::string_view formula, const VariableValue& value_of);

}  // namespace repose

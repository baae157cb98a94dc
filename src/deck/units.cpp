#include "deck/units.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <span>

#include <fmt/core.h>

#include "base/math.h"
#include "base/trimmed.h"

namespace repose {
namespace {

struct Symbol {
  std::string_view text;
  int power;            ///< times ten to this power
  double factor = 1.0;  ///< and times this factor gives SI
};

constexpr Symbol metre[] = {{"m", 0}, {"km", 3}, {"cm", -2}, {"mm", -3}, {"um", -6}, {"nm", -9}};
constexpr Symbol area[] = {{"m2", 0}, {"cm2", -4}, {"mm2", -6}, {"um2", -12}};
constexpr Symbol volume[] = {{"m3", 0},  {"cm3", -6}, {"mm3", -9}, {"ml", -6},
                             {"ul", -9}, {"nl", -12}, {"pl", -15}, {"um3", -18}};
constexpr Symbol second[] = {{"s", 0}, {"ms", -3}, {"us", -6}, {"ns", -9}};
constexpr Symbol kilogram[] = {{"kg", 0}, {"t", 3}, {"g", -3}, {"mg", -6}, {"ug", -9}};
constexpr Symbol pascal[] = {{"Pa", 0}, {"kPa", 3}, {"MPa", 6}, {"GPa", 9}};
constexpr Symbol density[] = {{"kg/m3", 0}, {"g/cm3", 3}, {"t/m3", 3}, {"g/m3", -3}};
constexpr Symbol speed[] = {{"m/s", 0}, {"km/s", 3}, {"cm/s", -2}, {"mm/s", -3}, {"um/s", -6}};
constexpr Symbol acceleration[] = {{"m/s2", 0}, {"cm/s2", -2}, {"mm/s2", -3}};
constexpr Symbol joule[] = {{"J", 0}, {"kJ", 3}, {"mJ", -3}, {"uJ", -6}, {"nJ", -9}, {"pJ", -12}, {"fJ", -15}};
constexpr Symbol newton[] = {{"N", 0}, {"kN", 3}, {"mN", -3}, {"uN", -6}, {"nN", -9}};
constexpr Symbol newton_metre[] = {{"N m", 0}, {"mN m", -3}, {"uN m", -6}, {"nN m", -9}};
constexpr Symbol mass_rate[] = {{"kg/s", 0}, {"t/s", 3}, {"g/s", -3}, {"mg/s", -6}};
constexpr Symbol per_second[] = {{"1/s", 0}, {"1/ms", 3}};

constexpr Symbol hertz[] = {{"Hz", 0}, {"kHz", 3}};
constexpr Symbol angular_speed[] = {{"rad/s", 0}, {"deg/s", 0, pi / 180.0}, {"rpm", 0, pi / 30.0}};
constexpr Symbol stiffness[] = {{"N/m", 0}, {"kN/m", 3}, {"N/mm", 3}, {"mN/m", -3}, {"J/m2", 0}, {"mJ/m2", -3}};
constexpr Symbol kelvin[] = {{"K", 0}, {"mK", -3}};
constexpr Symbol watt[] = {{"W", 0}, {"mW", -3}};
constexpr Symbol conductance[] = {{"W/K", 0}, {"mW/K", -3}};
constexpr Symbol specific_power[] = {{"W/kg", 0}, {"kW/kg", 3}};
constexpr Symbol ohm[] = {{"ohm", 0}};
constexpr Symbol conductivity[] = {{"W/(m K)", 0}, {"mW/(m K)", -3}};
constexpr Symbol specific_heat[] = {{"J/(kg K)", 0}, {"kJ/(kg K)", 3}};
constexpr Symbol volumetric_heat[] = {{"J/(m3 K)", 0}, {"kJ/(m3 K)", 3}, {"MJ/(m3 K)", 6}};
constexpr Symbol diffusivity[] = {{"m2/s", 0}, {"mm2/s", -6}};
constexpr Symbol per_kelvin[] = {{"1/K", 0}};
constexpr Symbol heating_rate[] = {{"K/s", 0}, {"mK/s", -3}};

struct Dimension {
  std::string_view name;
  std::span<const Symbol> symbols;  ///< the SI unit first
};

Dimension dimension(Unit unit) {
  switch (unit) {
    case Unit::none:
      break;
    case Unit::metre:
      return {"a length", metre};
    case Unit::second:
      return {"a time", second};
    case Unit::area:
      return {"an area", area};
    case Unit::volume:
      return {"a volume", volume};
    case Unit::kilogram:
      return {"a mass", kilogram};
    case Unit::pascal:
      return {"a pressure", pascal};
    case Unit::density:
      return {"a density", density};
    case Unit::speed:
      return {"a speed", speed};
    case Unit::acceleration:
      return {"an acceleration", acceleration};
    case Unit::joule:
      return {"an energy", joule};
    case Unit::newton:
      return {"a force", newton};
    case Unit::newton_metre:
      return {"a torque", newton_metre};
    case Unit::hertz:
      return {"a frequency", hertz};
    case Unit::angular_speed:
      return {"an angular speed", angular_speed};
    case Unit::mass_rate:
      return {"a mass per time", mass_rate};
    case Unit::per_second:
      return {"a number per time", per_second};
    case Unit::stiffness:
      return {"a stiffness", stiffness};
    case Unit::kelvin:
      return {"a temperature", kelvin};
    case Unit::watt:
      return {"a power", watt};
    case Unit::conductance:
      return {"a thermal conductance", conductance};
    case Unit::specific_power:
      return {"a power per mass", specific_power};
    case Unit::ohm:
      return {"a resistance", ohm};
    case Unit::conductivity:
      return {"a thermal conductivity", conductivity};
    case Unit::specific_heat:
      return {"a specific heat", specific_heat};
    case Unit::volumetric_heat:
      return {"a volumetric heat capacity", volumetric_heat};
    case Unit::diffusivity:
      return {"a diffusivity", diffusivity};
    case Unit::per_kelvin:
      return {"a number per temperature", per_kelvin};
    case Unit::heating_rate:
      return {"a temperature per time", heating_rate};
  }
  return {"a number", {}};
}

/// "µm" (either code point of the sign) and "um", "m^3" and "m3" are the same unit.
std::string plain_symbol(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view two = text.substr(i, 2);
    if (two == "\xC2\xB5" || two == "\xCE\xBC") {
      plain += 'u';
      ++i;
    } else if (text[i] != '^') {
      plain += text[i];
    }
  }
  return plain;
}

Quantity problem(std::string_view text, const Dimension& wanted, std::string_view what) {
  std::string accepted;
  for (const Symbol& s : wanted.symbols) accepted += fmt::format("{}{}", accepted.empty() ? "" : ", ", s.text);
  return {0.0, fmt::format("\"{}\" {}; write {} with one of the units {}", text, what, wanted.name, accepted)};
}

}  // namespace

std::string_view symbol(Unit unit) { return unit == Unit::none ? "-" : dimension(unit).symbols.front().text; }

constexpr std::string_view no_double = "is too large or too small for a double";
constexpr int largest_exponent = 100'000;  // beyond any double, however many digits there are before it

Quantity parse_quantity(std::string_view text, Unit unit) {
  const Dimension wanted = dimension(unit);
  const std::string_view bare = trimmed(text, " \t");
  const std::string_view unsigned_text = bare.substr(bare.starts_with('+') && !bare.starts_with("+-") ? 1 : 0);
  double value = 0.0;
  const auto scan = std::from_chars(unsigned_text.data(), unsigned_text.data() + unsigned_text.size(), value);
  if (scan.ec == std::errc::invalid_argument || !std::isfinite(value)) return problem(text, wanted, "is not a number");
  const auto length = static_cast<std::size_t>(scan.ptr - unsigned_text.data());
  const std::string_view number = unsigned_text.substr(0, length);
  const std::string given = plain_symbol(trimmed(unsigned_text.substr(length), " \t"));
  if (given.empty()) return problem(text, wanted, "has no unit");

  for (const Symbol& s : wanted.symbols) {
    if (s.text != given) continue;
    const auto e = number.find_first_of("eE");
    int exponent = 0;
    if (e != std::string_view::npos) {
      const std::string_view digits = number.substr(e + (number.substr(e + 1).starts_with('+') ? 2 : 1));
      const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
      if (read.ec != std::errc{} || std::abs(exponent) > largest_exponent) return problem(text, wanted, no_double);
    }
    const std::string joined = fmt::format("{}e{}", number.substr(0, e), exponent + s.power);
    const auto result = std::from_chars(joined.data(), joined.data() + joined.size(), value);
    if (result.ec != std::errc{}) return problem(text, wanted, no_double);
    return {s.factor * value, {}};
  }
  return problem(text, wanted, fmt::format("is not {}", wanted.name));
}

}  // namespace repose

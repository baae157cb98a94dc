#pragma once

#include <array>
#include <limits>
#include <string>
#include <string_view>

#include "deck/deck.h"
#include "deck/units.h"

/// What the schema says of a key beside its name, its member and its meaning. A schema function is called with a
/// visitor that has
///   operator()(name, member, Unit, Range, Presence, meaning)    one key
///   section(name, struct, Presence, meaning)                    [name]
///   sections(name, vector of structs, Presence, meaning)        [[name]], at least one when required
///   group(name, function of the visitor)                        sections below [name.
namespace repose {

/// The values a number may take; of each component of a vector or a list.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool excludes_min = false;
  bool excludes_max = false;

  /// False for NaN.
  constexpr bool contains(double x) const {
    return (excludes_min ? x > min : x >= min) && (excludes_max ? x < max : x <= max);
  }
};

inline constexpr Range any_value{};
constexpr Range above(double min) { return {.min = min, .excludes_min = true}; }
constexpr Range at_least(double min) { return {.min = min}; }
constexpr Range from_to(double min, double max) { return {.min = min, .max = max}; }
constexpr Range from_to_below(double min, double max) { return {.min = min, .max = max, .excludes_max = true}; }
constexpr Range above_to(double min, double max) { return {.min = min, .max = max, .excludes_min = true}; }

/// As people write it: "> 0", ">= 1", "0 <= x < 0.5"; empty when everything is allowed.
std::string range_text(const Range& range);

/// Whether a key must, may or may not be given.
struct Presence {
  bool is_required = false;
  bool applies = true;              ///< false: the key belongs to another type and is refused
  std::string_view condition = {};  ///< what makes it apply, such as "type = profile"
  std::string_view fallback = {};   ///< the default in words where it is derived from other keys

  constexpr Presence when(bool holds, std::string_view what) const { return {is_required, holds, what, fallback}; }
};

inline constexpr Presence required{.is_required = true};
inline constexpr Presence optional{};
constexpr Presence optional_else(std::string_view fallback) { return {.fallback = fallback}; }

constexpr auto enumerators(Axis) { return std::array<std::string_view, 3>{"x", "y", "z"}; }
constexpr auto enumerators(DomainFace) {
  return std::array<std::string_view, 6>{"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};
}
constexpr auto enumerators(WallType) {
  return std::array<std::string_view, 5>{"profile", "plane", "disc", "rectangle", "mesh"};
}
constexpr auto enumerators(PhaseUntil) {
  return std::array<std::string_view, 4>{"kinetic_energy", "time", "steps", "tilt_onset"};
}
constexpr auto enumerators(MotionType) {
  return std::array<std::string_view, 3>{"translation", "oscillation", "rotation"};
}
constexpr auto enumerators(SizesType) {
  return std::array<std::string_view, 5>{"classes", "lognormal", "weibull", "uniform", "csv"};
}
constexpr auto enumerators(Weighting) { return std::array<std::string_view, 2>{"mass", "number"}; }
constexpr auto enumerators(ParticlesType) {
  return std::array<std::string_view, 5>{"fill", "lattice", "csv", "snapshot", "pour"};
}
constexpr auto enumerators(RegionShape) { return std::array<std::string_view, 3>{"cylinder", "box", "disc"}; }
constexpr auto enumerators(LatticeType) {
  return std::array<std::string_view, 3>{"simple_cubic", "body_centred", "face_centred"};
}
constexpr auto enumerators(NormalLaw) { return std::array<std::string_view, 2>{"hertz", "hooke"}; }
constexpr auto enumerators(TangentialSpring) { return std::array<std::string_view, 2>{"projected", "rotated"}; }
constexpr auto enumerators(RollingHistory) { return std::array<std::string_view, 2>{"fixed", "rotated"}; }
constexpr auto enumerators(Integrator) {
  return std::array<std::string_view, 2>{"velocity_verlet", "synchronised_verlet"};
}
constexpr auto enumerators(Camera) { return std::array<std::string_view, 2>{"orthographic", "perspective"}; }

}  // namespace repose
